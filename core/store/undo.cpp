// SPDX-License-Identifier: MIT
#include "core/store/undo.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/store/schema.hpp"
#include "core/store/state.hpp"

namespace planum::store {

namespace {

constexpr std::size_t kChunk = 1024 * 1024; // [bytes]; far below the limit of one value

constexpr std::string_view kDropUndoneChunks =
    "DELETE FROM planum_change_chunk WHERE change IN (SELECT fid FROM planum_change WHERE state = 'undone')";
constexpr std::string_view kDropUndone = "UPDATE planum_change SET state = 'dropped' WHERE state = 'undone'";
constexpr std::string_view kInsertChange = "INSERT INTO planum_change(fid, label, author, made_at, state) "
                                           "VALUES (:number, :label, :author, :now, 'done')";
constexpr std::string_view kInsertChunk = "INSERT INTO planum_change_chunk(change, changeset) VALUES (:number, :part)";
constexpr std::string_view kSelectChunks =
    "SELECT changeset FROM planum_change_chunk WHERE change = :number ORDER BY fid";
constexpr std::string_view kNewestDone =
    "SELECT fid, label, author, made_at FROM planum_change WHERE state = 'done' ORDER BY fid DESC LIMIT 1";
constexpr std::string_view kOldestUndone =
    "SELECT fid, label, author, made_at FROM planum_change WHERE state = 'undone' ORDER BY fid LIMIT 1";
// Only the oldest changes without a gap, whatever the clock said in between: undo goes one by one.
constexpr std::string_view kDroppable =
    "SELECT c.fid FROM planum_change c WHERE c.state = 'done' AND c.fid < "
    "(SELECT coalesce(min(later.fid), 9223372036854775807) FROM planum_change later WHERE later.made_at >= :before) "
    "AND EXISTS (SELECT 1 FROM planum_change_chunk k WHERE k.change = c.fid)";
constexpr std::string_view kHasOlder = "SELECT 1 FROM planum_change_chunk k JOIN planum_change c ON c.fid = k.change "
                                       "WHERE c.state = 'done' AND c.fid < :number LIMIT 1";
constexpr std::string_view kDropChunks = "DELETE FROM planum_change_chunk WHERE change = :number";
constexpr std::string_view kSetState = "UPDATE planum_change SET state = :state WHERE fid = :number";
constexpr std::string_view kInsertLog =
    "INSERT INTO planum_log(made_at, author, action, table_name, record, field, old_value, new_value, change) "
    "VALUES (:now, :author, :action, :table, :record, :field, :old, :new, :number)";

/// Triggers and foreign keys off while a changeset is applied: the changeset already holds what triggers did,
/// and the keys are checked once, over everything, afterwards.
class BareApplication {
  public:
    explicit BareApplication(const sqlite::Database& database) : database_(&database) {
        database.enable_foreign_keys(false);
        database.enable_triggers(false);
    }

    ~BareApplication() {
        database_->enable_triggers(true);
        database_->enable_foreign_keys(true);
    }

    BareApplication(const BareApplication&) = delete;
    BareApplication& operator=(const BareApplication&) = delete;

  private:
    const sqlite::Database* database_;
};

std::string what_is(const sqlite::Database& database, const sqlite::ApplyConflict& conflict) {
    const auto& tables = record_tables();
    if (std::find(tables.begin(), tables.end(), conflict.table) == tables.end()) return "a record";
    const std::vector<std::string> columns = database.columns(conflict.table);
    for (const std::string_view column : {"number", "name"}) {
        if (std::find(columns.begin(), columns.end(), column) == columns.end()) continue;
        sqlite::Statement row =
            database.prepare(fmt::format("SELECT {} FROM {} WHERE fid = :fid", column, conflict.table));
        row.bind(":fid", conflict.rowid);
        if (row.step()) return fmt::format("the {} {}", conflict.table, row.text(0));
    }
    return fmt::format("a row of the table {}", conflict.table);
}

void check_references(const sqlite::Database& database, const ProjectFile::State& state, std::string_view what) {
    sqlite::Statement broken = database.prepare("SELECT \"table\", \"parent\" FROM pragma_foreign_key_check LIMIT 1");
    if (!broken.step()) return;
    throw Error(ErrorCode::Conflict, fmt::format("{}: {}: rows of the table {} that were added since refer to the {} "
                                                 "it would take away: delete them first",
                                                 state.file.string(), what, broken.text(0), broken.text(1)));
}

/// Log rows of an undo or redo: one an inserted or removed record, one a changed field.
class UndoLog {
  public:
    UndoLog(const ProjectFile::State& state, std::string_view action, std::int64_t number)
        : state_(&state), action_(action), number_(number), time_(state.now()),
          insert_(state.database.prepare(kInsertLog)) {}

    void add(const sqlite::ChangedRow& row) {
        const std::vector<std::string>& columns = columns_of(row.table);
        const auto& values = row.operation == sqlite::RowOperation::Delete ? row.before : row.after;
        if (row.operation != sqlite::RowOperation::Update) {
            const auto at =
                static_cast<std::size_t>(std::find(columns.begin(), columns.end(), "uuid") - columns.begin());
            const bool known = at < values.size() && values[at];
            write(row.table, known ? values[at]->text : std::string{}, {}, {}, {});
            return;
        }
        const std::string uuid = uuid_of(row);
        for (std::size_t i = 0; i < std::min(columns.size(), row.after.size()); ++i) {
            if (row.after[i]) write(row.table, uuid, columns[i], row.before[i], row.after[i]);
        }
    }

  private:
    const std::vector<std::string>& columns_of(std::string_view table) {
        auto it = columns_.find(table);
        if (it == columns_.end()) it = columns_.emplace(std::string{table}, state_->database.columns(table)).first;
        return it->second;
    }

    std::string uuid_of(const sqlite::ChangedRow& row) {
        auto it = uuid_queries_.find(row.table);
        if (it == uuid_queries_.end()) {
            const std::string sql =
                fmt::format("SELECT uuid FROM {} WHERE fid = :fid", sqlite::quote_identifier(row.table));
            it = uuid_queries_.emplace(std::string{row.table}, state_->database.prepare(sql)).first;
        }
        it->second.reset();
        it->second.bind(":fid", row.rowid);
        return it->second.step() ? std::string{it->second.text(0)} : std::string{};
    }

    void write(std::string_view table, std::string_view uuid, std::string_view field,
               const std::optional<sqlite::LoggedValue>& before, const std::optional<sqlite::LoggedValue>& after) {
        const auto put = [&](std::string_view name, const std::optional<sqlite::LoggedValue>& value) {
            if (value && !value->null)
                insert_.bind(name, std::string_view{value->text});
            else
                insert_.bind_null(name);
        };
        insert_.bind(":now", std::string_view{time_}).bind(":author", std::string_view{state_->environment.author});
        insert_.bind(":action", action_).bind(":table", table).bind(":record", uuid).bind(":number", number_);
        if (field.empty())
            insert_.bind_null(":field");
        else
            insert_.bind(":field", field);
        put(":old", before);
        put(":new", after);
        insert_.run();
    }

    const ProjectFile::State* state_;
    std::string_view action_;
    std::int64_t number_;
    std::string time_;
    sqlite::Statement insert_;
    std::map<std::string, std::vector<std::string>, std::less<>> columns_;
    std::map<std::string, sqlite::Statement, std::less<>> uuid_queries_;
};

struct Step {
    std::string_view find;       ///< the change to work on
    std::string_view none;       ///< what to say when there is none
    sqlite::Direction direction; ///< how its changeset is applied
    std::string_view action;     ///< in the log
    std::string_view state;      ///< of the change afterwards
};

constexpr Step kUndo{kNewestDone, "there is nothing to take back", sqlite::Direction::Inverse, "undo", "undone"};
constexpr Step kRedo{kOldestUndone, "there is nothing to make again", sqlite::Direction::Forward, "redo", "done"};

ChangeEntry find_change(const ProjectFile::State& state, const Step& step) {
    sqlite::Statement row = state.database.prepare(step.find);
    if (!row.step()) throw Error(ErrorCode::Conflict, fmt::format("{}: {}", state.file.string(), step.none));
    return {row.integer(0), std::string{row.text(1)}, std::string{row.text(2)}, std::string{row.text(3)},
            step.direction == sqlite::Direction::Inverse};
}

void apply_changeset(const ProjectFile::State& state, const Step& step, const ChangeEntry& entry,
                     const sqlite::Changeset& changes) {
    const sqlite::Database& database = state.database;
    const std::string what = fmt::format("{} \"{}\"", step.action, entry.label);
    const auto conflict = sqlite::apply(database, changes, step.direction, record_tables());
    if (conflict) {
        throw Error(ErrorCode::Conflict,
                    fmt::format("{}: {}: {} was changed since by another program; nothing was done",
                                state.file.string(), what, what_is(database, *conflict)));
    }
    UndoLog log(state, step.action, entry.number);
    bool removed = false;
    sqlite::for_each_row(changes, step.direction, [&](const sqlite::ChangedRow& row) {
        removed = removed || row.operation == sqlite::RowOperation::Delete;
        log.add(row);
    });
    if (removed) check_references(database, state, what);
}

std::set<std::string, std::less<>> tables_of(const sqlite::Changeset& changes) {
    std::set<std::string, std::less<>> tables;
    sqlite::for_each_row(changes, sqlite::Direction::Forward, [&](const sqlite::ChangedRow& row) {
        if (!tables.contains(row.table)) tables.emplace(row.table);
    });
    return tables;
}

ChangeEntry run_step(ProjectFile::State& state, const Step& step) {
    state.require_writable();
    if (state.in_change) throw Error(ErrorCode::Internal, "undo was called inside a change");
    const sqlite::Database& database = state.database;
    const BareApplication bare(database);
    sqlite::Transaction transaction(database);
    ChangeEntry entry = find_change(state, step);
    const sqlite::Changeset changes = read_changeset(database, entry.number);
    if (changes.empty()) {
        throw Error(ErrorCode::Conflict, fmt::format("{}: {} \"{}\" of {} is no longer possible: undo steps up to then "
                                                     "were forgotten",
                                                     state.file.string(), step.action, entry.label, entry.made_at));
    }
    apply_changeset(state, step, entry, changes);
    sqlite::Statement set_state = database.prepare(kSetState);
    set_state.bind(":state", step.state).bind(":number", entry.number).run();
    sync_spatial_reference(state);
    state.note_last_change(tables_of(changes));
    transaction.commit();
    return entry;
}

} // namespace

void keep_change(ProjectFile::State& state, std::int64_t number, std::string_view label,
                 const sqlite::Changeset& changes) {
    const sqlite::Database& database = state.database;
    database.execute(kDropUndoneChunks);
    database.execute(kDropUndone);
    sqlite::Statement change = database.prepare(kInsertChange);
    const std::string time = state.now();
    change.bind(":number", number).bind(":label", label);
    change.bind(":author", std::string_view{state.environment.author}).bind(":now", std::string_view{time}).run();
    sqlite::Statement chunk = database.prepare(kInsertChunk);
    const std::span<const std::byte> all{changes};
    for (std::size_t at = 0; at < all.size(); at += kChunk) {
        chunk.bind(":number", number).bind_blob(":part", all.subspan(at, std::min(kChunk, all.size() - at))).run();
    }
}

sqlite::Changeset read_changeset(const sqlite::Database& database, std::int64_t change) {
    sqlite::Changeset changes;
    sqlite::Statement chunks = database.prepare(kSelectChunks);
    chunks.bind(":number", change);
    while (chunks.step()) {
        const auto part = chunks.blob(0);
        changes.insert(changes.end(), part.begin(), part.end());
    }
    return changes;
}

std::size_t drop_changesets(ProjectFile::State& state, std::string_view before) {
    state.require_writable();
    const sqlite::Database& database = state.database;
    sqlite::Transaction transaction(database);
    std::vector<std::int64_t> old;
    {
        sqlite::Statement rows = database.prepare(kDroppable);
        rows.bind(":before", before);
        while (rows.step()) old.push_back(rows.integer(0));
    }
    sqlite::Statement drop = database.prepare(kDropChunks);
    for (const std::int64_t number : old) drop.bind(":number", number).run();
    transaction.commit();
    return old.size();
}

bool has_older_changeset(const sqlite::Database& database, std::int64_t change) {
    sqlite::Statement row = database.prepare(kHasOlder);
    row.bind(":number", change);
    return row.step();
}

ChangeEntry take_back(ProjectFile::State& state) { return run_step(state, kUndo); }

ChangeEntry make_again(ProjectFile::State& state) { return run_step(state, kRedo); }

} // namespace planum::store
