// SPDX-License-Identifier: MIT
#include "core/store/opening.hpp"

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/store/schema.hpp"
#include "core/store/state.hpp"

namespace planum::store {

namespace {

// Temporary data in memory: a statement journal that once outgrew SQLite's 64 KB stays a file for the rest of the
// transaction, and an import then writes every page its 200,000 statements touch to it (3 GB in a million calls).
constexpr std::string_view kWriting =
    "PRAGMA synchronous = FULL; PRAGMA cache_spill = OFF; PRAGMA secure_delete = OFF; PRAGMA temp_store = MEMORY; "
    "PRAGMA recursive_triggers = ON";
constexpr std::string_view kReading = "PRAGMA query_only = ON; PRAGMA cache_size = -16000";

bool has_content(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file, ignored);
    return !ignored && size > 0;
}

sqlite::FileHeader check_header(const std::filesystem::path& file) {
    const sqlite::FileHeader header = sqlite::read_header(file);
    if (header.application_id != kApplicationId) {
        throw Error(ErrorCode::BadInput,
                    file.string() + ": a database, but not a GeoPackage and so not a Planum project");
    }
    return header;
}

/// A change that was interrupted (power, kill) is rolled back before anything is read; that needs writing
/// even where only reading is wanted.
void roll_back_interrupted(const std::filesystem::path& file, OpenReport& report) {
    if (!has_content(file.string() + "-journal")) return;
    const sqlite::Database database = sqlite::Database::open(file, sqlite::Access::ReadWrite);
    (void)database.integer("SELECT count(*) FROM sqlite_schema");
    if (!has_content(file.string() + "-journal")) {
        report.notes.emplace_back("a change that had been interrupted was taken back");
    }
}

sqlite::Database connect_for_reading(const std::filesystem::path& file, const sqlite::FileHeader& header,
                                     OpenReport& report) {
    if (header.wal) {
        report.notes.emplace_back("another program left the file in write-ahead mode (is it open in QGIS?)");
        // Without a write-ahead file there is nothing that locking would protect, and none has to be made.
        if (!has_content(file.string() + "-wal")) return sqlite::Database::open(file, sqlite::Access::Immutable);
    }
    return sqlite::Database::open(file, sqlite::Access::ReadOnly);
}

/// Back to a rollback journal: a project that is copied must be one file.
void leave_write_ahead_mode(ProjectFile::State& state) {
    std::string mode;
    // Whoever still edits the file keeps it in that mode; waiting for them would only delay the opening.
    const std::int64_t patience = state.database.integer("PRAGMA busy_timeout");
    state.database.execute("PRAGMA busy_timeout = 200");
    try {
        state.database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
        mode = state.database.text("PRAGMA journal_mode = DELETE");
    } catch (const Error& e) {
        if (e.code() != ErrorCode::Io) throw;
    }
    state.database.execute(fmt::format("PRAGMA busy_timeout = {}", patience));
    state.report.notes.emplace_back(
        mode == "delete" ? "the file had been left in write-ahead mode; it was set back"
                         : "the file stays in write-ahead mode while another program uses it (is it open in QGIS?)");
}

void check_version(ProjectFile::State& state) {
    state.version = read_schema_version(state.database);
    if (state.version > kSchemaVersion) {
        throw Error(ErrorCode::BadInput, fmt::format("{}: made with schema version {}, this program knows up to {}: "
                                                     "install a newer Planum",
                                                     state.file.string(), state.version, kSchemaVersion));
    }
}

bool has_work(const ProjectFile::State& state, const SchemaFindings& findings, const sqlite::FileHeader& header) {
    return header.wal || state.version < kSchemaVersion || !findings.rtree_tables.empty() ||
           !findings.missing_names.empty();
}

void migrate_forward(ProjectFile::State& state) {
    migrate(state.database, state.version, kSchemaVersion);
    state.report.notes.push_back(fmt::format("brought from schema version {} to {}", state.version, kSchemaVersion));
    state.version = read_schema_version(state.database);
}

/// What has to be written before work can begin; only after the whole file was found sound.
void repair(ProjectFile::State& state, const SchemaFindings& findings, const sqlite::FileHeader& header) {
    state.wait_for_check();
    if (header.wal) leave_write_ahead_mode(state);
    if (findings.rtree_tables.empty() && findings.missing_names.empty() && state.version >= kSchemaVersion) return;
    sqlite::Transaction transaction(state.database);
    for (const std::string& layer : findings.rtree_tables) {
        drop_rtree(state.database, layer);
        state.report.notes.push_back(fmt::format("the spatial index of the layer {} was dropped: its triggers cannot "
                                                 "run safely; QGIS works without it",
                                                 layer));
    }
    for (std::size_t i = 0; i < findings.missing_sql.size(); ++i) {
        state.database.execute(findings.missing_sql[i]);
        state.report.notes.push_back(
            fmt::format("{} had been dropped by another program; it was put back", findings.missing_names[i]));
    }
    // Last: the findings speak of the version that the file had.
    if (state.version < kSchemaVersion) migrate_forward(state);
    transaction.commit();
}

void require_gpkg_name(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
        throw Error(ErrorCode::NotFound, file.string() + ": no such file; make a project with planum new");
    }
}

} // namespace

void prepare_for_writing(const sqlite::Database& database) { database.execute(kWriting); }

std::unique_ptr<ProjectFile::State> open_project(const std::filesystem::path& file, OpenMode mode,
                                                 const Environment& environment) {
    require_gpkg_name(file);
    (void)check_header(file); // a file that is none of ours is not even rolled back
    OpenReport report;
    roll_back_interrupted(file, report);
    const sqlite::FileHeader header = check_header(file);
    const bool writes = mode == OpenMode::ReadWrite;
    auto state = std::make_unique<ProjectFile::State>(file, mode, environment,
                                                      writes ? sqlite::Database::open(file, sqlite::Access::ReadWrite)
                                                             : connect_for_reading(file, header, report));
    state->report = std::move(report);
    state->database.execute(writes ? kWriting : kReading);
    check_version(*state);
    state->start_check();
    const SchemaFindings findings = examine_schema(state->database, state->version);
    state->report.import_only = !findings.import_only_because.empty();
    state->report.import_only_because = findings.import_only_because;
    if (writes && !state->report.import_only && has_work(*state, findings, header)) repair(*state, findings, header);
    return state;
}

} // namespace planum::store
