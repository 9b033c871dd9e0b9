// SPDX-License-Identifier: MIT
#include "core/store/state.hpp"

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::store {

namespace {

constexpr std::string_view kSetContext = "UPDATE planum_context SET author = :author, made_at = :now, change = :change";
constexpr std::string_view kClearContext = "UPDATE planum_context SET author = NULL, made_at = NULL, change = NULL";
// New rows get the highest row number, so all from the first one on are new.
constexpr const char* kLogInserts = "INSERT INTO planum_log(made_at, author, action, table_name, record, change) "
                                    "SELECT :now, :author, 'insert', :table, uuid, :change FROM {} WHERE fid >= :first";
constexpr std::string_view kNoteChange = "UPDATE gpkg_contents SET last_change = :now WHERE table_name = :table";

void check_whole_file(const std::filesystem::path& file, sqlite::Access access) {
    sqlite::Database database = sqlite::Database::open(file, access);
    sqlite::Statement check = database.prepare("PRAGMA quick_check(1)");
    if (check.step() && check.text(0) != "ok") {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{}: the file is damaged ({}): restore a backup", file.string(), check.text(0)));
    }
}

} // namespace

std::string ProjectFile::State::now() const { return environment.clock->now(); }

Uuid ProjectFile::State::new_uuid() const { return environment.uuids->next(); }

void ProjectFile::State::start_check() {
    // A read-only database connection of its own, so that reading the record goes on beside it.
    const bool immutable = database.access() == sqlite::Access::Immutable;
    const sqlite::Access access = immutable ? sqlite::Access::Immutable : sqlite::Access::ReadOnly;
    check = std::async(std::launch::async, [path = file, access] { check_whole_file(path, access); });
}

void ProjectFile::State::wait_for_check() const {
    if (check.valid()) check.get();
}

void ProjectFile::State::require_writable() const {
    wait_for_check();
    if (mode == OpenMode::ReadOnly) {
        throw Error(ErrorCode::Internal, file.string() + ": opened for reading only");
    }
    if (report.import_only) {
        throw Error(ErrorCode::Conflict,
                    fmt::format("{}: may be read but not written, because {}: import it into a new project",
                                file.string(), report.import_only_because.front()));
    }
}

void ProjectFile::State::require_change(std::string_view table) {
    if (!in_change) throw Error(ErrorCode::Internal, "a record was written outside of a change");
    if (!touched.contains(table)) touched.emplace(table);
}

void ProjectFile::State::set_context(std::int64_t change) {
    sqlite::Statement set = database.prepare(kSetContext);
    const std::string time = now();
    set.bind(":author", std::string_view{environment.author}).bind(":now", std::string_view{time});
    set.bind(":change", change).run();
    change_number = change;
    unlogged.clear();
}

void ProjectFile::State::clear_context() {
    log_inserts();
    database.execute(kClearContext);
}

void ProjectFile::State::note_insert(std::string_view table) {
    if (!unlogged.contains(table)) unlogged.emplace(table, database.last_insert_rowid());
}

void ProjectFile::State::log_inserts() {
    if (unlogged.empty()) return;
    const std::string time = now();
    for (const auto& [table, first] : unlogged) {
        sqlite::Statement insert = database.prepare(fmt::format(kLogInserts, table));
        insert.bind(":now", std::string_view{time}).bind(":author", std::string_view{environment.author});
        insert.bind(":table", std::string_view{table}).bind(":change", change_number).bind(":first", first).run();
    }
    unlogged.clear();
}

void ProjectFile::State::note_last_change(const std::set<std::string, std::less<>>& tables) const {
    sqlite::Statement note = database.prepare(kNoteChange);
    const std::string time = now();
    for (const std::string& table : tables) {
        note.bind(":now", std::string_view{time}).bind(":table", std::string_view{table}).run();
    }
}

} // namespace planum::store
