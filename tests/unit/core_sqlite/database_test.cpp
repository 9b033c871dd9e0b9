// SPDX-License-Identifier: MIT
#include "core/sqlite/database.hpp"

#include <fstream>
#include <iterator>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::sqlite;

namespace {

template<class Work>
Error error_of_work(Work work) {
    try {
        work();
    } catch (const Error& e) {
        return e;
    }
    return {ErrorCode::Internal, "no error at all"};
}

} // namespace

TEST_CASE("Values go in by name or by index and come out as they were") {
    const Database db = Database::in_memory();
    db.execute("CREATE TABLE t(i INTEGER, r REAL, s TEXT, b BLOB, n TEXT)");
    Statement insert = db.prepare("INSERT INTO t VALUES(:i, :r, :s, :b, :n)");
    const std::array<std::byte, 3> bytes{std::byte{0}, std::byte{255}, std::byte{7}};
    insert.bind(":i", std::int64_t{1} << 40).bind(":r", 0.1).bind(":s", std::string_view{"a\0b", 3});
    insert.bind_blob(":b", bytes).bind_null(5);
    insert.run();
    Statement select = db.prepare("SELECT * FROM t");
    REQUIRE(select.step());
    CHECK(select.integer(0) == std::int64_t{1} << 40);
    CHECK(select.real(1) == 0.1);
    CHECK(select.text(2) == std::string_view{"a\0b", 3});
    CHECK(std::equal(bytes.begin(), bytes.end(), select.blob(3).begin(), select.blob(3).end()));
    CHECK(select.is_null(4));
    CHECK(select.column_name(1) == "r");
    CHECK_FALSE(select.optional_real(4).has_value());
    CHECK_FALSE(select.step());
}

TEST_CASE("A statement with an unknown parameter or a second statement behind it is our own mistake") {
    const Database db = Database::in_memory();
    Statement one = db.prepare("SELECT :a");
    CHECK(error_of_work([&] { (void)one.parameter(":b"); }).code() == ErrorCode::Internal);
    CHECK(error_of_work([&] { (void)db.prepare("SELECT 1; SELECT 2"); }).code() == ErrorCode::Internal);
}

TEST_CASE("A transaction that is not committed leaves nothing behind") {
    const Database db = Database::in_memory();
    db.execute("CREATE TABLE t(i)");
    {
        const Transaction dropped(db);
        db.execute("INSERT INTO t VALUES(1)");
    }
    CHECK(db.integer("SELECT count(*) FROM t") == 0);
    Transaction kept(db);
    db.execute("INSERT INTO t VALUES(1)");
    kept.commit();
    CHECK(db.integer("SELECT count(*) FROM t") == 1);
}

TEST_CASE("A broken rule is a conflict, said in the words of the rule") {
    const Database db = Database::in_memory();
    db.execute("CREATE TABLE t(i INTEGER CHECK(i > 0), CONSTRAINT small CHECK(i < 9))");
    const Error error = error_of_work([&] { db.execute("INSERT INTO t VALUES(10)"); });
    CHECK(error.code() == ErrorCode::Conflict);
    CHECK(std::string{error.what()}.find("small") != std::string::npos);
}

TEST_CASE("Files that are no database, empty or missing are refused by name") {
    const test::TemporaryFolder folder;
    const auto text_file = folder.write("notes.sqlite", std::string(200, 'x'));
    const Error not_one = error_of_work([&] { (void)Database::open_foreign(text_file); });
    CHECK(not_one.code() == ErrorCode::BadInput);
    CHECK(not_one.what() == text_file.string() + ": not a SQLite database");
    const auto empty = folder.write("empty.sqlite", "");
    CHECK(error_of_work([&] { (void)Database::open_foreign(empty); }).code() == ErrorCode::BadInput);
    CHECK(error_of_work([&] { (void)Database::open_foreign(folder / "none"); }).code() == ErrorCode::NotFound);
    CHECK(error_of_work([&] { (void)Database::open_foreign(folder.path()); }).code() == ErrorCode::BadInput);
}

TEST_CASE("A file cut short is said to be so before SQLite reads it") {
    const test::TemporaryFolder folder;
    const auto file = folder / "whole.sqlite";
    {
        const Database db = Database::open(file, Access::Create);
        db.execute("CREATE TABLE t(s); INSERT INTO t SELECT hex(randomblob(500)) FROM (VALUES(1),(2),(3),(4),(5))");
    }
    std::string bytes = read_file(file, 1 << 20);
    const auto cut = folder.write("cut.sqlite", bytes.substr(0, bytes.size() - 4096));
    const Error error = error_of_work([&] { (void)read_header(cut); });
    CHECK(error.code() == ErrorCode::BadInput);
    CHECK(std::string{error.what()}.find("cut short") != std::string::npos);
}

TEST_CASE("A foreign file in write-ahead mode is read without files being made beside it") {
    const test::TemporaryFolder folder;
    const auto file = folder / "foreign wal?#%.sqlite";
    {
        const Database db = Database::open(file, Access::Create);
        db.execute("PRAGMA journal_mode=WAL; CREATE TABLE us_table(us); INSERT INTO us_table VALUES(7)");
    }
    {
        const Database db = Database::open_foreign(file);
        CHECK(db.has_table("US_TABLE"));
        CHECK(db.columns("us_table") == std::vector<std::string>{"us"});
        CHECK(db.integer("SELECT us FROM us_table") == 7);
    }
    CHECK(std::distance(std::filesystem::directory_iterator{folder.path()}, {}) == 1);
}

TEST_CASE("A foreign file cannot be written") {
    const test::TemporaryFolder folder;
    const auto file = folder / "foreign.sqlite";
    Database::open(file, Access::Create).execute("CREATE TABLE t(i)");
    const Database db = Database::open_foreign(file);
    CHECK(error_of_work([&] { db.execute("INSERT INTO t VALUES(1)"); }).code() == ErrorCode::Io);
    CHECK(error_of_work([&] { db.execute("ATTACH ':memory:' AS other"); }).code() == ErrorCode::BadInput);
}

TEST_CASE("A schema that is not trusted cannot use dangerous functions") {
    const test::TemporaryFolder folder;
    const auto file = folder / "hostile.sqlite";
    Database::open(file, Access::Create).execute("CREATE VIEW v AS SELECT load_extension('evil') AS x");
    const Database db = Database::open_foreign(file);
    CHECK(error_of_work([&] { (void)db.integer("SELECT x FROM v"); }).code() == ErrorCode::BadInput);
}

TEST_CASE("A long query ends when the user has asked to stop") {
    Database db = Database::in_memory();
    std::stop_source source;
    db.stop_with(source.get_token());
    source.request_stop();
    const Error error = error_of_work([&] {
        (void)db.integer("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT 100000000) "
                         "SELECT count(*) FROM n");
    });
    CHECK(error.code() == ErrorCode::Cancelled);
}

TEST_CASE("Identifiers are quoted so that they stay identifiers") { CHECK(quote_identifier("a\"b") == "\"a\"\"b\""); }
