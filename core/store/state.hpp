// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <future>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/sqlite/changeset.hpp"
#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"

namespace planum::store {

/// Statements of one table, compiled on first use and kept: an import runs them 100,000 times.
struct TableStatements {
    sqlite::Statement insert;
    sqlite::Statement update;
    sqlite::Statement remove;
};

/// What an open project file is made of. The members of ProjectFile are spread over several sources that
/// all work on this.
struct ProjectFile::State {
    std::filesystem::path file;
    OpenMode mode = OpenMode::ReadOnly;
    Environment environment;
    sqlite::Database database;
    OpenReport report;
    std::int64_t version = kSchemaVersion;
    std::int32_t srs_id = -1; ///< of the geometries that are written

    std::map<std::string, TableStatements, std::less<>> statements;
    std::set<std::string, std::less<>> touched;                ///< tables written by the change that is under way
    std::map<std::string, std::int64_t, std::less<>> unlogged; ///< table → first row inserted since log_inserts()
    bool in_change = false;

    /// quick_check, running on a connection of its own; invalid once it was waited for.
    mutable std::future<void> check;

    State(std::filesystem::path path, OpenMode open_mode, Environment env, sqlite::Database db)
        : file(std::move(path)), mode(open_mode), environment(std::move(env)), database(std::move(db)) {}

    [[nodiscard]] std::string now() const;
    [[nodiscard]] Uuid new_uuid() const;

    void start_check();
    /// Throws BadInput when the file turned out to be damaged.
    void wait_for_check() const;

    /// Throws Conflict or Io when this file may not be written.
    void require_writable() const;
    /// Throws Internal outside change(): a write that no undo step would hold.
    void require_change(std::string_view table);

    void set_context(std::int64_t change);
    void clear_context();
    std::int64_t change_number = 0; ///< of the change that is under way

    /// Notes that the row just inserted has no log entry yet.
    void note_insert(std::string_view table);
    /// Writes the log entries of all inserts noted so far, many rows at a time. Before any other change of a
    /// row, so that the log keeps the order of events.
    void log_inserts();
    /// gpkg_contents.last_change of the tables touched.
    void note_last_change(const std::set<std::string, std::less<>>& tables) const;
};

/// Brings gpkg tables and srs_id in line with the project's coordinate system.
void sync_spatial_reference(ProjectFile::State& state);

/// Makes a coordinate system known to the file. Throws BadInput when nobody knows the code.
void add_spatial_reference(const sqlite::Database& database, std::int64_t srs_id);

} // namespace planum::store
