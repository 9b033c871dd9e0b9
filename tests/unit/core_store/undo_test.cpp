// SPDX-License-Identifier: MIT
#include "core/base/error.hpp"
#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/filled_project.hpp"

using namespace planum;
using namespace planum::model;
using namespace planum::store;
using planum::test::a_unit;
using planum::test::message_of;

TEST_CASE("Undo gives the rows of before, redo those of after, to the last one") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    ProjectFile project = ProjectFile::create(file, test::some_settings(), environment.get());
    const std::string empty = test::raw_rows(file);
    project = test::fill_project(folder / "full.gpkg", environment);
    const std::string full = test::raw_rows(folder / "full.gpkg");
    const std::string dump = project.canonical_dump();
    CHECK(project.undo().label == "A day's work");
    CHECK(project.undo().label == "Import sheets.csv");
    CHECK(project.load().units.empty());
    CHECK(project.load().scans.empty());
    CHECK(message_of([&] { (void)project.undo(); }).find("nothing to take back") != std::string::npos);
    CHECK(project.redo().number == 1);
    CHECK(project.redo().number == 2);
    CHECK(test::raw_rows(folder / "full.gpkg") == full);
    CHECK(project.canonical_dump() == dump);
    CHECK(message_of([&] { (void)project.redo(); }).find("nothing to make again") != std::string::npos);
    CHECK(project.verify(Progress::none()).empty());
}

TEST_CASE("After new work the changes taken back cannot be made again, and history says so") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = ProjectFile::create(folder / "site.gpkg", test::some_settings(), environment.get());
    project.change("One", [&] { project.insert(a_unit("1")); });
    project.change("Two", [&] { project.insert(a_unit("2")); });
    (void)project.undo();
    project.change("Three", [&] { project.insert(a_unit("3")); });
    CHECK_THROWS_AS(project.redo(), Error);
    const std::vector<ChangeEntry> history = project.history(10);
    REQUIRE(history.size() == 3);
    CHECK(history[0].label == "Three");
    CHECK_FALSE(history[0].undone);
    CHECK(history[1].undone);
    CHECK(project.undo().label == "Three");
    CHECK(project.undo().label == "One");
}

TEST_CASE("Undo is logged, and never takes the log away") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = ProjectFile::create(folder / "site.gpkg", test::some_settings(), environment.get());
    StratigraphicUnit unit = a_unit("1");
    project.change("Add", [&] { unit.id = project.insert(unit); });
    unit.title = "new";
    project.change("Change", [&] { project.update(unit); });
    (void)project.undo();
    const std::vector<LogEntry> log = project.log(unit.id.value, 10);
    REQUIRE(log.size() == 3);
    CHECK(log[0].action == "undo");
    CHECK(log[0].field == "title");
    CHECK(log[0].old_value == "new");
    CHECK(log[0].new_value == "a layer");
    (void)project.undo();
    CHECK(project.log(unit.id.value, 10).size() == 4);
}

TEST_CASE("Undo of a row that somebody else changed since is refused in a sentence, and nothing is done") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    ProjectFile project = ProjectFile::create(file, test::some_settings(), environment.get());
    StratigraphicUnit unit = a_unit("1042");
    project.change("Add unit 1042", [&] { unit.id = project.insert(unit); });
    unit.title = "mine";
    project.change("Rename", [&] { project.update(unit); });
    sqlite::Database::open(file, sqlite::Access::ReadWrite).execute("UPDATE unit SET title = 'theirs'");
    const std::string before = test::raw_rows(file);
    const std::string said = message_of([&] { (void)project.undo(); });
    CHECK(said.find("undo \"Rename\": the unit 1042 was changed since") != std::string::npos);
    CHECK(test::raw_rows(file) == before);
    // What another program did is in the log, under no name of ours.
    CHECK(project.log(unit.id.value, 1).at(0).author == "outside Planum");
}

TEST_CASE("Undo does not take away what somebody else has come to refer to") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    ProjectFile project = ProjectFile::create(file, test::some_settings(), environment.get());
    project.change("Add unit 1", [&] { project.insert(a_unit("1")); });
    sqlite::Database::open(file, sqlite::Access::ReadWrite)
        .execute("INSERT INTO level(unit, z) SELECT uuid, 101.5 FROM unit");
    const std::string before = test::raw_rows(file);
    CHECK(message_of([&] { (void)project.undo(); }).find("refer to the unit") != std::string::npos);
    CHECK(test::raw_rows(file) == before);
    CHECK(project.verify(Progress::none()).empty());
}

TEST_CASE("A change of the coordinate system is taken back with its geometries") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    ProjectFile project = test::fill_project(file, environment);
    const std::string before = test::raw_rows(file);
    ProjectSettings settings = project.settings();
    settings.srs_id = 25832;
    project.change("Move to UTM", [&] { project.update(settings); });
    const auto layers_of = [&](std::string_view srs) {
        const auto database = sqlite::Database::open(file, sqlite::Access::ReadOnly);
        return database.integer("SELECT count(*) FROM gpkg_geometry_columns WHERE srs_id = " + std::string{srs});
    };
    CHECK(layers_of("25832") == 5);
    (void)project.undo();
    CHECK(test::raw_rows(file) == before);
    CHECK(layers_of("-1") == 5);
}

TEST_CASE("Undo steps are forgotten from the oldest on and only when asked; the rest stays as it is") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    ProjectFile project = ProjectFile::create(file, test::some_settings(), environment.get());
    FixedClock later("2025-07-01T12:00:00.000Z");
    project.change("June", [&] { project.insert(a_unit("1")); });
    Environment july = environment.get();
    july.clock = &later;
    ProjectFile open = ProjectFile::open(file, OpenMode::ReadWrite, july);
    open.change("July", [&] { open.insert(a_unit("2")); });
    const std::string dump = open.canonical_dump();

    CHECK(open.forget_changes("2025-06-01") == 0);
    CHECK(open.forget_changes("2025-07-01") == 1);
    CHECK(open.forget_changes("2025-07-01") == 0);
    open.compact();
    CHECK(open.canonical_dump() == dump);
    CHECK(open.verify(Progress::none()).empty());
    CHECK(open.history(10).size() == 2);
    CHECK(open.undo().label == "July");
    const std::string said = message_of([&] { (void)open.undo(); });
    CHECK(said.find("\"June\" of 2025-06-01T12:00:00.000Z is no longer possible") != std::string::npos);
    CHECK(open.redo().label == "July");
    CHECK(open.canonical_dump() == dump);
}

TEST_CASE("A later undo step that is missing while an older one is there is damage") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto file = folder / "site.gpkg";
    {
        ProjectFile project = ProjectFile::create(file, test::some_settings(), environment.get());
        project.change("One", [&] { project.insert(a_unit("1")); });
        project.change("Two", [&] { project.insert(a_unit("2")); });
    }
    sqlite::Database::open(file, sqlite::Access::ReadWrite).execute("DELETE FROM planum_change_chunk WHERE change = 2");
    const ProjectFile project = ProjectFile::open(file, OpenMode::ReadOnly, environment.get());
    CHECK(project.verify(Progress::none()).size() == 1);
}
