// SPDX-License-Identifier: MIT
#include "core/store/project_file.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/store/opening.hpp"
#include "core/store/record_loader.hpp"
#include "core/store/record_writer.hpp"
#include "core/store/schema.hpp"
#include "core/store/state.hpp"
#include "core/store/undo.hpp"

namespace planum::store {

namespace {

constexpr std::string_view kDescribeFile = "PRAGMA page_size = 4096; PRAGMA encoding = 'UTF-8'; "
                                           "PRAGMA application_id = 1196444487; PRAGMA user_version = 10300";

void fill_new_file(ProjectFile::State& state, const model::ProjectSettings& settings) {
    const sqlite::Database& database = state.database;
    database.execute(kDescribeFile);
    sqlite::Transaction transaction(database);
    create_schema(database);
    const std::string time = state.now();
    for (const std::string_view sql :
         {"UPDATE gpkg_contents SET last_change = :now", "UPDATE layer_styles SET update_time = :now"}) {
        sqlite::Statement stamp = database.prepare(sql);
        stamp.bind(":now", std::string_view{time}).run();
    }
    state.set_context(0);
    state.in_change = true;
    insert_record(state, settings, state.new_uuid());
    state.in_change = false;
    sync_spatial_reference(state);
    state.clear_context();
    transaction.commit();
}

void check_new_name(const std::filesystem::path& file) {
    if (file.extension() != ".gpkg") {
        throw Error(ErrorCode::Usage, file.string() + ": the name of a project must end in .gpkg");
    }
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        throw Error(ErrorCode::Conflict, file.string() + ": a file of this name is there already");
    }
}

/// Ends a change whichever way it goes: nothing of it may show in the next one.
class ChangeScope {
  public:
    explicit ChangeScope(ProjectFile::State& state) : state_(&state) {
        state.in_change = true;
        state.touched.clear();
    }

    ~ChangeScope() {
        state_->in_change = false;
        state_->touched.clear();
        state_->unlogged.clear();
        // A statement that stopped half-way would keep the rollback from ending.
        for (auto& [table, statements] : state_->statements) {
            if (statements.insert) statements.insert.reset();
            if (statements.update) statements.update.reset();
            if (statements.remove) statements.remove.reset();
        }
    }

    ChangeScope(const ChangeScope&) = delete;
    ChangeScope& operator=(const ChangeScope&) = delete;

  private:
    ProjectFile::State* state_;
};

} // namespace

ProjectFile::ProjectFile(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}

ProjectFile::ProjectFile(ProjectFile&&) noexcept = default;
ProjectFile& ProjectFile::operator=(ProjectFile&&) noexcept = default;
ProjectFile::~ProjectFile() = default;

ProjectFile ProjectFile::create(const std::filesystem::path& file, const model::ProjectSettings& settings,
                                const Environment& environment) {
    check_new_name(file);
    // Made beside its place and renamed: nobody ever sees half a project.
    const std::filesystem::path unfinished = file.string() + "." + environment.uuids->next().to_string() + ".new";
    try {
        State state{unfinished, OpenMode::ReadWrite, environment,
                    sqlite::Database::open(unfinished, sqlite::Access::Create)};
        prepare_for_writing(state.database);
        fill_new_file(state, settings);
    } catch (const Error& e) {
        std::error_code ignored;
        std::filesystem::remove(unfinished, ignored);
        throw Error(e.code(), text::replace_all(e.what(), unfinished.string(), file.string()));
    }
    std::error_code failure;
    std::filesystem::rename(unfinished, file, failure);
    if (failure) throw Error(ErrorCode::Io, fmt::format("{}: {}", file.string(), failure.message()));
    return open(file, OpenMode::ReadWrite, environment);
}

ProjectFile ProjectFile::open(const std::filesystem::path& file, OpenMode mode, const Environment& environment) {
    return ProjectFile{open_project(file, mode, environment)};
}

const std::filesystem::path& ProjectFile::path() const noexcept { return state_->file; }

const OpenReport& ProjectFile::open_report() const noexcept { return state_->report; }

std::int64_t ProjectFile::schema_version() const noexcept { return state_->version; }

model::Record ProjectFile::load() const {
    model::Record record = load_record(state_->database);
    state_->wait_for_check();
    return record;
}

RemovedRecords ProjectFile::load_removed(std::string_view since) const {
    RemovedRecords removed = store::load_removed(state_->database, since);
    state_->wait_for_check();
    return removed;
}

model::ProjectSettings ProjectFile::settings() const {
    state_->wait_for_check();
    return load_settings(state_->database);
}

std::int64_t ProjectFile::change(std::string_view label, const std::function<void()>& work) {
    State& state = *state_;
    state.require_writable();
    if (state.in_change) throw Error(ErrorCode::Internal, "a change was begun inside another");
    const sqlite::Database& database = state.database;
    sqlite::Transaction transaction(database);
    const ChangeScope scope(state);
    sync_spatial_reference(state);
    const std::int64_t number = database.integer("SELECT coalesce(max(fid), 0) + 1 FROM planum_change");
    state.set_context(number);
    sqlite::Changeset changes;
    {
        sqlite::Session session(database);
        // The session looks tables up in this order for every row; most rows of an import are these.
        for (const char* table : {"relation_statement", "relation", "unit"}) session.attach(table);
        for (const std::string& table : record_tables()) session.attach(table);
        work();
        changes = session.changeset();
    }
    if (changes.empty()) return 0;
    keep_change(state, number, label, changes);
    state.note_last_change(state.touched);
    state.clear_context();
    transaction.commit();
    return number;
}

ChangeEntry ProjectFile::undo() { return take_back(*state_); }

ChangeEntry ProjectFile::redo() { return make_again(*state_); }

std::size_t ProjectFile::forget_changes(std::string_view day) { return drop_changesets(*state_, day); }

void ProjectFile::compact() {
    state_->require_writable();
    state_->statements.clear(); // compiled statements would hold the file open in the old shape
    state_->database.compact();
}

} // namespace planum::store
