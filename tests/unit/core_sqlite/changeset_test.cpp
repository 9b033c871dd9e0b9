// SPDX-License-Identifier: MIT
#include "core/sqlite/changeset.hpp"

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::sqlite;

namespace {

const std::vector<std::string> kTables{"t"};

Database with_table() {
    Database db = Database::in_memory();
    db.execute("CREATE TABLE t(fid INTEGER PRIMARY KEY, a TEXT, b REAL); INSERT INTO t VALUES(1, 'one', 1.5)");
    return db;
}

Changeset some_changes(const Database& db) {
    Session session(db);
    session.attach("t");
    db.execute("UPDATE t SET a = 'uno' WHERE fid = 1; INSERT INTO t VALUES(2, 'two', NULL)");
    return session.changeset();
}

std::string dump(const Database& db) {
    return db.text(
        "SELECT group_concat(fid || ':' || a || ':' || coalesce(b, '-'), ' ') FROM (SELECT * FROM t ORDER BY fid)");
}

} // namespace

TEST_CASE("A changeset taken back and made again gives the same rows") {
    const Database db = with_table();
    const std::string before = dump(db);
    const Changeset changes = some_changes(db);
    const std::string after = dump(db);
    CHECK_FALSE(apply(db, changes, Direction::Inverse, kTables).has_value());
    CHECK(dump(db) == before);
    CHECK_FALSE(apply(db, changes, Direction::Forward, kTables).has_value());
    CHECK(dump(db) == after);
}

TEST_CASE("A row that was changed meanwhile is named, and nothing is applied") {
    const Database db = with_table();
    const Changeset changes = some_changes(db);
    db.execute("UPDATE t SET a = 'ein' WHERE fid = 1");
    const std::string before = dump(db);
    const auto conflict = apply(db, changes, Direction::Inverse, kTables);
    REQUIRE(conflict.has_value());
    CHECK(conflict->table == "t");
    CHECK(conflict->rowid == 1);
    CHECK(dump(db) == before);
}

TEST_CASE("The rows of a changeset can be read in both directions") {
    const Database db = with_table();
    const Changeset changes = some_changes(db);
    std::vector<std::string> seen;
    const auto see = [&](const ChangedRow& row) {
        const auto text = [](const auto& values) { return values.size() > 1 && values[1] ? values[1]->text : "?"; };
        seen.push_back(std::to_string(row.rowid) + " " + text(row.before) + "→" + text(row.after));
    };
    for_each_row(changes, Direction::Forward, see);
    for_each_row(changes, Direction::Inverse, see);
    std::sort(seen.begin(), seen.end());
    CHECK(seen == std::vector<std::string>{"1 one→uno", "1 uno→one", "2 ?→two", "2 two→?"});
}

TEST_CASE("A damaged changeset, or one for other tables, is refused") {
    const Database db = with_table();
    Changeset changes = some_changes(db);
    CHECK_THROWS_AS(apply(db, changes, Direction::Inverse, std::vector<std::string>{"u"}), Error);
    changes.resize(changes.size() - 3);
    CHECK_THROWS_AS(for_each_row(changes, Direction::Forward, [](const ChangedRow&) {}), Error);
    CHECK_THROWS_AS(apply(db, changes, Direction::Inverse, kTables), Error);
}
