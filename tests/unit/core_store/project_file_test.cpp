// SPDX-License-Identifier: MIT
#include "core/store/project_file.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/sqlite/database.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/filled_project.hpp"

using namespace planum;
using namespace planum::model;
using namespace planum::store;
using planum::test::a_unit;
using planum::test::message_of;

namespace {

ProjectFile new_project(const std::filesystem::path& file, test::TestEnvironment& environment,
                        NumberScope numbers = NumberScope::Site) {
    ProjectSettings settings = test::some_settings();
    settings.numbers = numbers;
    return ProjectFile::create(file, settings, environment.get());
}

} // namespace

TEST_CASE("A new project says what it was made with and holds nothing else") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const ProjectFile project = new_project(folder / "site.planum.gpkg", environment);
    CHECK(project.settings().name == "Test dig");
    CHECK(project.schema_version() == kSchemaVersion);
    CHECK(project.open_report().notes.empty());
    CHECK_FALSE(project.open_report().import_only);
    CHECK(project.load().units.empty());
    CHECK(project.history(10).empty());
    CHECK(std::distance(std::filesystem::directory_iterator{folder.path()}, {}) == 1);
}

TEST_CASE("A project is not made over another file, nor under a name that is no GeoPackage's") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    folder.write("site.gpkg", "something else");
    CHECK_THROWS_AS(new_project(folder / "site.gpkg", environment), Error);
    CHECK_THROWS_AS(new_project(folder / "site.db", environment), Error);
}

TEST_CASE("A project on a national grid describes that grid") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectSettings settings = test::some_settings();
    settings.srs_id = 25832;
    CHECK(ProjectFile::create(folder / "utm.gpkg", settings, environment.get()).settings().srs_id == 25832);
    settings.srs_id = 99999;
    const std::string said =
        message_of([&] { (void)ProjectFile::create(folder / "none.gpkg", settings, environment.get()); });
    CHECK(said.find("EPSG:99999") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "none.gpkg"));
}

TEST_CASE("Everything that goes into the file comes out of it as it was") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = test::fill_project(folder / "site.gpkg", environment);
    const Record before = project.load();
    REQUIRE(before.units.size() == 6);
    CHECK(before.units[0].number == "1");
    CHECK(before.units[3].details.at("munsell") == "10YR 5/2");
    CHECK(before.relations.size() == 3);
    CHECK(before.statements.size() == 4);
    CHECK(before.levels.size() == 3);
    CHECK(before.finds.at(0).x == 10.0);
    CHECK(before.regions.size() == 2);
    CHECK(before.scans.at(0).header_pose.value()[11] == 1.0 / 3.0);
    CHECK(before.poses.at(0).covariance[0] == 1e-6);
    CHECK(before.groups.at(0).members.size() == 2);
    CHECK(before.interpretations.at(0).added.size() == 1);
    // Written again field by field into a second file, it is the same record.
    ProjectFile copy = ProjectFile::create(folder / "copy.gpkg", before.settings, environment.get());
    copy.change("Copy", [&] {
        const auto all = [&](const auto& values) {
            for (const auto& value : values) copy.insert(value);
        };
        all(before.areas), all(before.sources), all(before.import_notes), all(before.periods), all(before.phases);
        auto units = before.units;
        std::stable_sort(units.begin(), units.end(), [](const auto& a, const auto& b) { return a.parent < b.parent; });
        all(units), all(before.relations), all(before.statements), all(before.groups), all(before.levels);
        all(before.finds), all(before.datings), all(before.samples), all(before.documents), all(before.surfaces);
        all(before.sections), all(before.regions), all(before.scans), all(before.runs), all(before.poses);
        all(before.decisions), all(before.interpretations);
    });
    const Record after = copy.load();
    CHECK(after.units == before.units);
    CHECK(after.relations == before.relations);
    CHECK(after.statements == before.statements);
    CHECK(after.levels == before.levels);
    CHECK(after.finds == before.finds);
    CHECK(after.datings == before.datings);
    CHECK(after.regions == before.regions);
    CHECK(after.sections == before.sections);
    CHECK(after.scans == before.scans);
    CHECK(after.poses == before.poses);
    CHECK(after.runs == before.runs);
    CHECK(after.groups == before.groups);
    CHECK(after.interpretations == before.interpretations);
    CHECK(after.decisions == before.decisions);
    CHECK(copy.canonical_dump() == project.canonical_dump());
}

TEST_CASE("A find without a height has none when it comes back, one at height 0 has that") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = new_project(folder / "site.gpkg", environment);
    project.change("finds", [&] {
        for (const std::optional<double> z : {std::optional<double>{}, std::optional<double>{0.0}}) {
            Find find;
            find.number = z ? "at 0" : "flat";
            find.x = 1.0;
            find.y = 2.0;
            find.z = z;
            project.insert(find);
        }
    });
    for (const Find& find : project.load().finds) {
        CHECK(find.x == 1.0);
        CHECK(find.z.has_value() == (find.number == "at 0"));
    }
}

TEST_CASE("A number is used once on a site, or once in each area") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile site = new_project(folder / "site.gpkg", environment);
    site.change("Add", [&] { site.insert(a_unit("1042")); });
    const std::string said = message_of([&] { site.change("Again", [&] { site.insert(a_unit("1042")); }); });
    CHECK(said == (folder / "site.gpkg").string() + ": adding unit 1042: number already used");

    ProjectFile areas = new_project(folder / "areas.gpkg", environment, NumberScope::Area);
    AreaId a;
    areas.change("Add", [&] {
        a = areas.insert(Area{{}, "A", "", DigMethod::Stratigraphic, "", ""});
        const AreaId b = areas.insert(Area{{}, "B", "", DigMethod::Stratigraphic, "", ""});
        areas.insert(a_unit("1", a));
        areas.insert(a_unit("1", b));
    });
    const std::string twice = message_of([&] { areas.change("Again", [&] { areas.insert(a_unit("1", a)); }); });
    CHECK(twice.find("adding unit 1: number already used in area A") != std::string::npos);
    ProjectSettings strict = areas.settings();
    strict.numbers = NumberScope::Site;
    CHECK_THROWS_AS(areas.change("One series", [&] { areas.update(strict); }), Error);
}

TEST_CASE("A change that throws leaves the project as it was, and the exception goes on") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = new_project(folder / "site.gpkg", environment);
    const std::string before = project.canonical_dump();
    CHECK_THROWS_AS(project.change("Fails",
                                   [&] {
                                       project.insert(a_unit("1"));
                                       throw std::runtime_error("something else");
                                   }),
                    std::runtime_error);
    CHECK(project.canonical_dump() == before);
    CHECK(project.change("Nothing", [] {}) == 0);
    CHECK(project.history(10).empty());
    CHECK(project.change("Works", [&] { project.insert(a_unit("1")); }) == 1);
}

TEST_CASE("Writing outside a change, or a change inside a change, is the program's mistake") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = new_project(folder / "site.gpkg", environment);
    CHECK_THROWS_AS(project.insert(a_unit("1")), Error);
    CHECK_THROWS_AS(project.change("Outer", [&] { project.change("Inner", [] {}); }), Error);
}

TEST_CASE("Updating writes every field of the living record, and only of a living one") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = new_project(folder / "site.gpkg", environment);
    StratigraphicUnit unit = a_unit("1");
    project.change("Add", [&] { unit.id = project.insert(unit); });
    unit.title.clear();
    unit.description = "new";
    unit.details["colour"] = "red";
    project.change("Change", [&] { project.update(unit); });
    CHECK(project.load().units.at(0) == unit);
    project.change("Remove", [&] { project.remove(unit.id); });
    CHECK(project.load().units.empty());
    const std::string said = message_of([&] { project.change("Again", [&] { project.update(unit); }); });
    CHECK(said.find("no unit 1") != std::string::npos);
    CHECK_THROWS_AS(project.change("Again", [&] { project.remove(unit.id); }), Error);
    CHECK(project.change("Number free again", [&] { project.insert(a_unit("1")); }) > 0);
}

TEST_CASE("A removed unit takes its relations, statements, levels and memberships with it") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = test::fill_project(folder / "site.gpkg", environment);
    const Record before = project.load();
    project.change("Remove unit 1", [&] { project.remove(before.units[0].id); });
    const Record after = project.load();
    CHECK(after.units.size() == before.units.size() - 1);
    CHECK(after.relations.size() == before.relations.size() - 1);
    CHECK(after.statements.size() == before.statements.size() - 2);
    CHECK(after.levels.size() == before.levels.size() - 1);
    CHECK(after.groups.at(0).members.size() == 1);
    CHECK(after.interpretations.at(0).added.empty());
    CHECK(after.finds.size() == before.finds.size());
    CHECK(after.finds.at(0).unit.is_nil());
    CHECK(project.verify(Progress::none()).empty());
    (void)project.undo();
    CHECK(project.load().statements == before.statements);
}

TEST_CASE("A pose of the same scan and run replaces the one before") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = test::fill_project(folder / "site.gpkg", environment);
    ScanPose pose = project.load().poses.at(0);
    pose.rms = 0.002;
    project.change("Better pose", [&] { project.insert(pose); });
    const Record record = project.load();
    REQUIRE(record.poses.size() == 1);
    CHECK(record.poses[0] == pose);
}

TEST_CASE("What refers to nothing, or holds what is no number, is refused by name") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = new_project(folder / "site.gpkg", environment);
    StratigraphicUnit unit = a_unit("7");
    unit.area.value = {1, 2};
    const std::string said = message_of([&] { project.change("Add", [&] { project.insert(unit); }); });
    CHECK(said.find("adding unit 7: it refers to a record that does not exist") != std::string::npos);
    Find find;
    find.number = "F9";
    find.z = std::numeric_limits<double>::quiet_NaN();
    CHECK(message_of([&] { project.change("Add", [&] { project.insert(find); }); }).find("find F9") !=
          std::string::npos);
    unit = a_unit("7");
    unit.details["color"] = "red";
    CHECK(message_of([&] { project.change("Add", [&] { project.insert(unit); }); }).find("color") != std::string::npos);
}

TEST_CASE("The log tells who did what, field by field") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    ProjectFile project = new_project(folder / "site.gpkg", environment);
    StratigraphicUnit unit = a_unit("1");
    project.change("Add", [&] { unit.id = project.insert(unit); });
    unit.title = "another";
    project.change("Change", [&] { project.update(unit); });
    project.change("Remove", [&] { project.remove(unit.id); });
    const std::vector<LogEntry> log = project.log(unit.id.value, 10);
    REQUIRE(log.size() == 3);
    CHECK(log[2].action == "insert");
    CHECK(log[2].author == "Ada");
    CHECK(log[2].made_at == "2025-06-01T12:00:00.000Z");
    CHECK(log[2].change == 1);
    CHECK(log[1].action == "update");
    CHECK(log[1].field == "title");
    CHECK(log[1].old_value == "a layer");
    CHECK(log[1].new_value == "another");
    CHECK(log[0].action == "delete");
    CHECK(project.log(std::nullopt, 2).size() == 2);
}

TEST_CASE("A backup is a whole project of its own") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const ProjectFile project = test::fill_project(folder / "site.gpkg", environment);
    project.backup(folder / "copy.gpkg", Progress::none());
    const ProjectFile copy = ProjectFile::open(folder / "copy.gpkg", OpenMode::ReadOnly, environment.get());
    CHECK(copy.canonical_dump() == project.canonical_dump());
    CHECK(copy.history(10).size() == 2);
    CHECK_THROWS_AS(project.backup(folder / "site.gpkg", Progress::none()), Error);
    CHECK_THROWS_AS(project.backup(folder / "no such folder" / "copy.gpkg", Progress::none()), Error);
}

TEST_CASE("A filled project verifies without a problem") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const ProjectFile project = test::fill_project(folder / "site.gpkg", environment);
    for (const VerifyProblem& problem : project.verify(Progress::none()))
        FAIL_CHECK(problem.where + ": " + problem.what);
    CHECK(project.verify(Progress::none()).empty());
}

TEST_CASE("What is marked together with a deleted record is found by index") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    (void)test::fill_project(folder / "site.gpkg", environment);
    const sqlite::Database database = sqlite::Database::open(folder / "site.gpkg", sqlite::Access::ReadOnly);
    const std::vector<std::pair<std::string, std::string>> taken_along = {
        {"relation", "subject"},  {"relation", "object"}, {"relation_statement", "relation"},
        {"group_member", "unit"}, {"level", "unit"},      {"dating", "unit"}};
    for (const auto& [table, column] : taken_along) {
        sqlite::Statement plan = database.prepare("EXPLAIN QUERY PLAN SELECT fid FROM " + table + " WHERE " + column +
                                                  " = 'x' AND deleted_at IS NULL");
        REQUIRE(plan.step());
        INFO(table << "." << column);
        CHECK(std::string{plan.text(3)}.starts_with("SEARCH"));
    }
}
