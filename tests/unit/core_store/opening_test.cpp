// SPDX-License-Identifier: MIT
#include <csignal>
#include <random>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/core_store/child_process.hpp"
#include "tests/unit/core_store/filled_project.hpp"

using namespace planum;
using namespace planum::store;
using planum::test::a_unit;
using planum::test::message_of;

namespace {

constexpr std::uintmax_t kLimit = 64U << 20U;

std::string filled_bytes(const test::TemporaryFolder& folder) {
    test::TestEnvironment environment;
    (void)test::fill_project(folder / "whole.gpkg", environment);
    return read_file(folder / "whole.gpkg", kLimit);
}

/// Opens, reads and tries to write; Errors are what is expected of damaged files, anything else is not.
/// Returns whether everything went well.
bool open_and_use(const std::filesystem::path& file, OpenMode mode) {
    test::TestEnvironment environment(99);
    try {
        const ProjectFile project = ProjectFile::open(file, mode, environment.get());
        (void)project.load();
        (void)project.history(100);
        (void)project.log(std::nullopt, 100);
        return true;
    } catch (const Error&) {
        return false;
    }
}

void run_sql(const std::filesystem::path& file, std::string_view sql) {
    sqlite::Database::open(file, sqlite::Access::ReadWrite).execute(sql);
}

} // namespace

TEST_CASE("Files that are no projects are refused with a sentence") {
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const auto said = [&](const std::filesystem::path& file) {
        return message_of([&] { (void)ProjectFile::open(file, OpenMode::ReadOnly, environment.get()); });
    };
    CHECK(said(folder / "none.gpkg").find("no such file") != std::string::npos);
    CHECK(said(folder.write("text.gpkg", "hello")).find("not a SQLite database") != std::string::npos);
    CHECK(said(folder.write("empty.gpkg", "")).find("empty") != std::string::npos);
    sqlite::Database::open(folder / "other.gpkg", sqlite::Access::Create).execute("CREATE TABLE t(a)");
    CHECK(said(folder / "other.gpkg").find("not a GeoPackage") != std::string::npos);
    sqlite::Database::open(folder / "plain.gpkg", sqlite::Access::Create)
        .execute("PRAGMA application_id = 1196444487; CREATE TABLE t(a)");
    CHECK(said(folder / "plain.gpkg").find("not a Planum project") != std::string::npos);
}

TEST_CASE("A newer schema is refused with both versions named") {
    const test::TemporaryFolder folder;
    (void)filled_bytes(folder);
    run_sql(folder / "whole.gpkg", "UPDATE planum_meta SET value = '9' WHERE key = 'schema_version'");
    test::TestEnvironment environment;
    const std::string said =
        message_of([&] { (void)ProjectFile::open(folder / "whole.gpkg", OpenMode::ReadWrite, environment.get()); });
    CHECK(said.find("schema version 9, this program knows up to " + std::to_string(kSchemaVersion)) !=
          std::string::npos);
}

TEST_CASE("A project cut short at any page is refused, and not a byte of it changes") {
    const test::TemporaryFolder folder;
    const std::string whole = filled_bytes(folder);
    for (std::size_t length = 0; length < whole.size(); length += 4096) {
        for (const std::size_t cut : {length, length + 100}) {
            INFO("cut at " << cut);
            const std::string bytes = whole.substr(0, cut);
            const auto file = folder.write("cut.gpkg", bytes);
            CHECK_FALSE(open_and_use(file, OpenMode::ReadWrite));
            CHECK(read_file(file, kLimit) == bytes);
        }
    }
}

// A rollback journal as SQLite writes it (file format, section 3), holding the first page as it was before.
std::string journal_of_first_page(const std::string& whole) {
    constexpr std::size_t kPage = 4096;
    constexpr std::uint32_t kNonce = 7;
    const auto big_endian = [](std::uint32_t value) {
        std::string bytes;
        for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<char>(value >> shift & 0xffU));
        return bytes;
    };
    const std::string page = whole.substr(0, kPage);
    std::uint32_t sum = kNonce;
    for (int at = static_cast<int>(kPage) - 200; at > 0; at -= 200) {
        sum += static_cast<unsigned char>(page[static_cast<std::size_t>(at)]);
    }
    std::string journal = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
    const auto pages = static_cast<std::uint32_t>(whole.size() / kPage);
    for (const std::uint32_t value : {1U, kNonce, pages, 512U, static_cast<std::uint32_t>(kPage)}) {
        journal += big_endian(value);
    }
    journal.resize(512);
    return journal + big_endian(1) + page + big_endian(sum);
}

TEST_CASE("A change that was killed before its new pages were written is taken back") {
    const test::TemporaryFolder folder;
    const std::string whole = filled_bytes(folder);
    // The first page says already how long the file is to be, the pages themselves have not come.
    std::string cut = whole;
    cut[30] = static_cast<char>(cut[30] + 1); // pages, big endian at 28
    cut[24] = static_cast<char>(cut[24] + 1); // change counter, and the one that the page count is valid for
    cut[92] = static_cast<char>(cut[92] + 1);
    for (const OpenMode mode : {OpenMode::ReadWrite, OpenMode::ReadOnly}) {
        const auto file = folder.write("killed.gpkg", cut);
        folder.write("killed.gpkg-journal", journal_of_first_page(whole));
        test::TestEnvironment environment(3);
        {
            const ProjectFile project = ProjectFile::open(file, mode, environment.get());
            CHECK_FALSE(project.load().units.empty());
            REQUIRE(project.open_report().notes.size() == 1);
            CHECK(project.open_report().notes.front() == "a change that had been interrupted was taken back");
        }
        CHECK(read_file(file, kLimit) == whole);
    }
    const auto file = folder.write("killed.gpkg", cut);
    CHECK_FALSE(open_and_use(file, OpenMode::ReadWrite)); // no journal, no way back
}

TEST_CASE("Flipped bytes give an error or a project, never a crash, and reading changes nothing") {
    const test::TemporaryFolder folder;
    const std::string whole = filled_bytes(folder);
    std::mt19937 random(20250601);
    for (int round = 0; round < 150; ++round) {
        std::string bytes = whole;
        for (int flips = 0; flips < 1 + round % 40; ++flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        INFO("round " << round);
        const auto file = folder.write("flipped.gpkg", bytes);
        (void)open_and_use(file, OpenMode::ReadOnly);
        CHECK(read_file(file, kLimit) == bytes);
    }
}

TEST_CASE("Triggers, views and indexes of others on our tables make a project import-only") {
    const test::TemporaryFolder folder;
    const std::string whole = filled_bytes(folder);
    test::TestEnvironment environment;
    const std::array hostile = {
        "CREATE TRIGGER extra AFTER INSERT ON unit BEGIN DELETE FROM find; END",
        "CREATE TRIGGER extra AFTER UPDATE ON gpkg_contents BEGIN DELETE FROM find; END",
        "DROP TRIGGER unit_inserted; CREATE TRIGGER unit_inserted AFTER INSERT ON unit BEGIN DELETE FROM find; END",
        "CREATE VIEW seen AS SELECT * FROM unit",
        "CREATE TRIGGER rtree_find_geom_insert AFTER INSERT ON find BEGIN DELETE FROM unit; END",
        "DROP INDEX unit_number; CREATE INDEX unit_number ON unit(number)",
        "PRAGMA legacy_alter_table=ON; PRAGMA foreign_keys=OFF; DROP TABLE import_note; CREATE TABLE import_note(fid "
        "INTEGER "
        "PRIMARY KEY, uuid, source, line, code, raw_text, message, deleted_at)",
    };
    for (const char* sql : hostile) {
        INFO(sql);
        const auto file = folder.write("hostile.gpkg", whole);
        run_sql(file, sql);
        const std::string before = read_file(file, kLimit);
        ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
        CHECK(project.open_report().import_only);
        CHECK_FALSE(project.open_report().import_only_because.empty());
        CHECK(project.load().units.size() == 6);
        CHECK(message_of([&] {
                  project.change("Add", [&] { project.insert(a_unit("77")); });
              }).find("import it into a new project") != std::string::npos);
        CHECK_THROWS_AS(project.undo(), Error);
        CHECK(read_file(file, kLimit) == before);
    }
}

TEST_CASE("Tables, columns and templates of others are left alone") {
    const test::TemporaryFolder folder;
    (void)filled_bytes(folder);
    const auto file = folder / "whole.gpkg";
    run_sql(file, "CREATE TABLE my_notes(a); CREATE TRIGGER mine AFTER INSERT ON my_notes BEGIN SELECT 1; END;"
                  "CREATE VIEW my_view AS SELECT * FROM my_notes; ALTER TABLE unit ADD COLUMN weather TEXT");
    test::TestEnvironment environment(5);
    ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
    CHECK_FALSE(project.open_report().import_only);
    CHECK(project.open_report().notes.empty());
    CHECK(project.change("Add", [&] { project.insert(a_unit("77")); }) == 3);
    (void)project.undo();
}

TEST_CASE("A trigger or index that somebody dropped is put back, and that is said") {
    const test::TemporaryFolder folder;
    (void)filled_bytes(folder);
    run_sql(folder / "whole.gpkg", "DROP TRIGGER unit_changed; DROP INDEX unit_number");
    test::TestEnvironment environment(5);
    {
        const ProjectFile project = ProjectFile::open(folder / "whole.gpkg", OpenMode::ReadWrite, environment.get());
        CHECK(project.open_report().notes.size() == 2);
    }
    const ProjectFile again = ProjectFile::open(folder / "whole.gpkg", OpenMode::ReadWrite, environment.get());
    CHECK(again.open_report().notes.empty());
}

TEST_CASE("A project without one of its tables or columns is no project") {
    const test::TemporaryFolder folder;
    const std::string whole = filled_bytes(folder);
    for (const char* sql : {"PRAGMA foreign_keys=OFF; DROP TABLE level",
                            "DROP TRIGGER find_changed; DROP TRIGGER find_deleted; ALTER TABLE find DROP COLUMN box",
                            "PRAGMA foreign_keys=OFF; DROP TABLE find; CREATE VIEW find AS SELECT 1 AS fid",
                            "DELETE FROM planum_meta", "UPDATE planum_meta SET value = 'x'"}) {
        INFO(sql);
        const auto file = folder.write("broken.gpkg", whole);
        run_sql(file, sql);
        CHECK_FALSE(open_and_use(file, OpenMode::ReadOnly));
    }
}

TEST_CASE("Values that no rule would have let in are named by table, not met with a crash") {
    const test::TemporaryFolder folder;
    const std::string whole = filled_bytes(folder);
    test::TestEnvironment environment;
    for (const char* sql : {"PRAGMA ignore_check_constraints=ON; UPDATE unit SET kind = 'hole'",
                            "PRAGMA ignore_check_constraints=ON; UPDATE region SET geom = x'475000'",
                            "UPDATE scan_pose SET site_from_scan = '1 2 three'"}) {
        INFO(sql);
        const auto file = folder.write("odd.gpkg", whole);
        run_sql(file, sql);
        CHECK_FALSE(open_and_use(file, OpenMode::ReadOnly));
    }
}

TEST_CASE("A project left in write-ahead mode is read, and set back when opened for writing") {
    const test::TemporaryFolder folder;
    (void)filled_bytes(folder);
    const auto file = folder / "whole.gpkg";
    run_sql(file, "PRAGMA journal_mode = WAL");
    test::TestEnvironment environment(5);
    {
        const ProjectFile reading = ProjectFile::open(file, OpenMode::ReadOnly, environment.get());
        CHECK(reading.load().units.size() == 6);
        CHECK(reading.open_report().notes.size() == 1);
        CHECK_FALSE(std::filesystem::exists(file.string() + "-wal"));
    }
    ProjectFile writing = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
    REQUIRE(writing.open_report().notes.size() == 1);
    CHECK(writing.open_report().notes[0].find("it was set back") != std::string::npos);
    CHECK_FALSE(sqlite::read_header(file).wal);
    CHECK(writing.change("Add", [&] { writing.insert(a_unit("77")); }) > 0);
}

TEST_CASE("What another process left in a write-ahead file is not lost") {
    const test::TemporaryFolder folder;
    (void)filled_bytes(folder);
    const auto file = folder / "whole.gpkg";
    const int status = test::in_child([&] {
        const sqlite::Database database = sqlite::Database::open(file, sqlite::Access::ReadWrite);
        database.execute("PRAGMA journal_mode = WAL; UPDATE unit SET title = 'from the field' WHERE number = '1'");
        std::raise(SIGKILL); // as when QGIS crashes
        return 0;
    });
    REQUIRE(status == 1000 + SIGKILL);
    REQUIRE(std::filesystem::file_size(file.string() + "-wal") > 0);
    test::TestEnvironment environment(5);
    CHECK(ProjectFile::open(file, OpenMode::ReadOnly, environment.get()).load().units.at(0).title == "from the field");
    CHECK(ProjectFile::open(file, OpenMode::ReadWrite, environment.get()).load().units.at(0).title == "from the field");
    CHECK_FALSE(std::filesystem::exists(file.string() + "-wal"));
}
