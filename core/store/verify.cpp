// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/sqlite/backup.hpp"
#include "core/store/record_loader.hpp"
#include "core/store/schema.hpp"
#include "core/store/state.hpp"
#include "core/store/undo.hpp"

namespace planum::store {

namespace {

using Problems = std::vector<VerifyProblem>;

/// Rows that a rule of ours does not let in: a query of (uuid or row number) and what it says about them.
struct Rule {
    std::string_view where;
    std::string_view sql;
    std::string_view what;
};

constexpr std::array kRules = {
    Rule{"relation",
         "SELECT r.uuid FROM relation r JOIN unit u ON u.uuid IN (r.subject, r.object) "
         "WHERE r.deleted_at IS NULL AND u.deleted_at IS NOT NULL",
         "is between units of which one was deleted"},
    Rule{"relation_statement",
         "SELECT s.uuid FROM relation_statement s JOIN relation r ON r.uuid = s.relation "
         "WHERE s.deleted_at IS NULL AND r.deleted_at IS NOT NULL",
         "belongs to a relation that was deleted"},
    Rule{"level",
         "SELECT l.uuid FROM level l JOIN unit u ON u.uuid = l.unit "
         "WHERE l.deleted_at IS NULL AND u.deleted_at IS NOT NULL",
         "belongs to a unit that was deleted"},
    Rule{"unit",
         "SELECT u.number FROM unit u WHERE u.deleted_at IS NULL AND (SELECT numbers FROM project LIMIT 1) = 'site' "
         "GROUP BY u.number HAVING count(*) > 1",
         "is a number that several units have"},
    Rule{"interpretation_dropped",
         "SELECT d.uuid FROM interpretation_dropped d WHERE d.deleted_at IS NULL "
         "AND NOT EXISTS (SELECT 1 FROM relation WHERE uuid = d.relation) "
         "AND NOT EXISTS (SELECT 1 FROM interpretation_added WHERE uuid = d.relation)",
         "drops a relation that does not exist"},
    Rule{"project", "SELECT count(*) FROM project HAVING count(*) <> 1", "rows, where a file holds one project"},
    Rule{"planum_context", "SELECT count(*) FROM planum_context HAVING count(*) <> 1",
         "rows, where the log needs exactly one"},
    Rule{"gpkg_contents",
         "SELECT table_name FROM gpkg_contents c WHERE NOT EXISTS "
         "(SELECT 1 FROM sqlite_schema WHERE name = c.table_name COLLATE NOCASE AND type IN ('table','view'))",
         "is listed but does not exist"},
    Rule{"gpkg_geometry_columns",
         "SELECT table_name FROM gpkg_geometry_columns g WHERE NOT EXISTS "
         "(SELECT 1 FROM gpkg_spatial_ref_sys s WHERE s.srs_id = g.srs_id)",
         "uses a coordinate system that the file does not describe"},
};

void check_pages(const sqlite::Database& database, Problems& problems) {
    sqlite::Statement check = database.prepare("PRAGMA integrity_check");
    while (check.step()) {
        if (check.text(0) != "ok") problems.push_back({"file", std::string{check.text(0)}});
    }
}

void check_references(const sqlite::Database& database, Problems& problems) {
    sqlite::Statement check = database.prepare("SELECT \"table\", rowid, \"parent\" FROM pragma_foreign_key_check");
    while (check.step()) {
        problems.push_back({fmt::format("{} row {}", check.text(0), check.integer(1)),
                            fmt::format("refers to a {} that does not exist", check.text(2))});
    }
}

void check_rules(const sqlite::Database& database, Problems& problems) {
    for (const Rule& rule : kRules) {
        sqlite::Statement rows = database.prepare(rule.sql);
        while (rows.step())
            problems.push_back({fmt::format("{} {}", rule.where, rows.text(0)), std::string{rule.what}});
    }
    for (const std::string& table : record_tables()) {
        sqlite::Statement rows = database.prepare(fmt::format("SELECT fid, uuid FROM {}", table));
        while (rows.step()) {
            if (Uuid::parse(rows.text(1))) continue;
            problems.push_back({fmt::format("{} row {}", table, rows.integer(0)), "has no valid uuid"});
        }
    }
}

void check_changes(const sqlite::Database& database, Problems& problems) {
    sqlite::Statement changes = database.prepare("SELECT fid, label FROM planum_change WHERE state <> 'dropped'");
    while (changes.step()) {
        const std::int64_t number = changes.integer(0);
        const std::string where = fmt::format("change {} \"{}\"", number, changes.text(1));
        try {
            const sqlite::Changeset set = read_changeset(database, number);
            if (set.empty()) {
                if (!has_older_changeset(database, number)) continue; // forgotten on demand, the oldest first
                throw Error(ErrorCode::BadInput, "the record of this change is missing");
            }
            sqlite::for_each_row(set, sqlite::Direction::Inverse, [&](const sqlite::ChangedRow& row) {
                const auto& tables = record_tables();
                if (std::find(tables.begin(), tables.end(), row.table) == tables.end()) {
                    throw Error(ErrorCode::BadInput, "the record of this change names a table it may not");
                }
            });
        } catch (const Error& e) {
            problems.push_back({where, fmt::format("cannot be taken back: {}", e.what())});
        }
    }
}

void check_readable(const sqlite::Database& database, Problems& problems) {
    try {
        (void)load_record(database);
    } catch (const Error& e) {
        problems.push_back({"record", e.what()});
    }
}

// Contents first, then the name: after a power cut there is the whole backup or none.
void flush_to_disk(const std::filesystem::path& path) {
    const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0) throw Error(ErrorCode::Io, path.string() + ": cannot be opened to be written to the disk");
    const int result = ::fsync(handle);
    ::close(handle);
    if (result != 0) throw Error(ErrorCode::Io, path.string() + ": writing to the disk failed");
}

void check_copy(const std::filesystem::path& copy) {
    const sqlite::Database database = sqlite::Database::open(copy, sqlite::Access::ReadOnly);
    if (database.text("PRAGMA quick_check(1)") != "ok") {
        throw Error(ErrorCode::Io, copy.string() + ": the copy is damaged: check the disk");
    }
}

} // namespace

std::vector<VerifyProblem> ProjectFile::verify(Progress& progress) const {
    Problems problems;
    const sqlite::Database& database = state_->database;
    try {
        state_->wait_for_check();
    } catch (const Error& e) {
        problems.push_back({"file", e.what()});
    }
    using Step = void (*)(const sqlite::Database&, Problems&);
    constexpr std::array<std::pair<std::string_view, Step>, 5> kSteps = {{{"checking pages", &check_pages},
                                                                          {"checking references", &check_references},
                                                                          {"checking rules", &check_rules},
                                                                          {"checking changes", &check_changes},
                                                                          {"reading the record", &check_readable}}};
    for (const auto& [name, step] : kSteps) {
        progress.check();
        progress.step(name);
        step(database, problems);
    }
    for (const std::string& why : state_->report.import_only_because) problems.push_back({"tables", why});
    return problems;
}

void ProjectFile::backup(const std::filesystem::path& target, Progress& progress) const {
    state_->wait_for_check();
    std::error_code failure;
    if (std::filesystem::equivalent(state_->file, target, failure)) {
        throw Error(ErrorCode::Usage, target.string() + ": a backup must be another file than the project");
    }
    progress.step("copying the project");
    const std::filesystem::path unfinished = target.string() + "." + state_->new_uuid().to_string() + ".new";
    try {
        sqlite::copy_database(state_->database, unfinished, progress);
        check_copy(unfinished);
        flush_to_disk(unfinished);
        std::filesystem::rename(unfinished, target);
        const std::filesystem::path folder = std::filesystem::absolute(target).parent_path();
        flush_to_disk(folder);
    } catch (const std::filesystem::filesystem_error& e) {
        std::filesystem::remove(unfinished, failure);
        throw Error(ErrorCode::Io, fmt::format("{}: {}", target.string(), e.code().message()));
    } catch (Error& e) {
        std::filesystem::remove(unfinished, failure);
        e.add_context(target.string());
        throw;
    }
}

} // namespace planum::store
