// SPDX-License-Identifier: MIT
#include "core/sqlite/changeset.hpp"

#include <algorithm>

#include <sqlite3.h>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/sqlite/connection.hpp"

namespace planum::sqlite {

namespace {

// Tables with more columns than this are not ours; a damaged changeset may claim any number.
constexpr int kMostColumns = 1000;

Error damaged() { return {ErrorCode::BadInput, "the record of this change is damaged"}; }

struct FinalizeIterator {
    void operator()(sqlite3_changeset_iter* iterator) const noexcept { sqlite3changeset_finalize(iterator); }
};

LoggedValue to_logged(sqlite3_value* value) {
    LoggedValue logged;
    const int type = sqlite3_value_type(value);
    if (type == SQLITE_NULL) return logged;
    logged.null = false;
    const auto bytes = static_cast<std::size_t>(sqlite3_value_bytes(value));
    if (type == SQLITE_BLOB) {
        const auto* start = static_cast<const unsigned char*>(sqlite3_value_blob(value));
        for (std::size_t i = 0; i < bytes; ++i) logged.text += fmt::format("{:02x}", start[i]);
        return logged;
    }
    // Reading as text may change the length, so that is asked for afterwards.
    const auto* text = reinterpret_cast<const char*>(sqlite3_value_text(value));
    if (text != nullptr) logged.text.assign(text, static_cast<std::size_t>(sqlite3_value_bytes(value)));
    return logged;
}

using ReadValue = int (*)(sqlite3_changeset_iter*, int, sqlite3_value**);

std::vector<std::optional<LoggedValue>> read_values(sqlite3_changeset_iter* iterator, int columns, ReadValue read) {
    std::vector<std::optional<LoggedValue>> values;
    values.reserve(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i) {
        sqlite3_value* value = nullptr;
        if (read(iterator, i, &value) != SQLITE_OK) throw damaged();
        values.push_back(value == nullptr ? std::nullopt : std::optional{to_logged(value)});
    }
    return values;
}

std::int64_t key_of(sqlite3_changeset_iter* iterator, int operation, int columns) {
    unsigned char* key = nullptr;
    int key_columns = 0;
    if (sqlite3changeset_pk(iterator, &key, &key_columns) != SQLITE_OK) return 0;
    for (int i = 0; i < std::min(columns, key_columns); ++i) {
        if (key[i] == 0) continue;
        sqlite3_value* value = nullptr;
        const int result = operation == SQLITE_INSERT ? sqlite3changeset_new(iterator, i, &value)
                                                      : sqlite3changeset_old(iterator, i, &value);
        return result == SQLITE_OK && value != nullptr ? sqlite3_value_int64(value) : 0;
    }
    return 0;
}

ChangedRow read_row(sqlite3_changeset_iter* iterator) {
    const char* table = nullptr;
    int columns = 0;
    int operation = 0;
    int indirect = 0;
    if (sqlite3changeset_op(iterator, &table, &columns, &operation, &indirect) != SQLITE_OK) throw damaged();
    if (columns > kMostColumns) throw damaged();
    ChangedRow row;
    row.table = table;
    row.rowid = key_of(iterator, operation, columns);
    row.operation = operation == SQLITE_INSERT   ? RowOperation::Insert
                    : operation == SQLITE_DELETE ? RowOperation::Delete
                                                 : RowOperation::Update;
    if (operation != SQLITE_INSERT) row.before = read_values(iterator, columns, &sqlite3changeset_old);
    if (operation != SQLITE_DELETE) row.after = read_values(iterator, columns, &sqlite3changeset_new);
    return row;
}

struct ApplyContext {
    std::span<const std::string> tables;
    std::optional<ApplyConflict> conflict;
    bool foreign_table = false;
};

int allow_table(void* context, const char* table) {
    auto& apply_context = *static_cast<ApplyContext*>(context);
    const auto& tables = apply_context.tables;
    if (std::find(tables.begin(), tables.end(), std::string_view{table}) != tables.end()) return 1;
    apply_context.foreign_table = true;
    return 0;
}

int note_conflict(void* context, int reason, sqlite3_changeset_iter* iterator) {
    auto& apply_context = *static_cast<ApplyContext*>(context);
    ApplyConflict conflict;
    if (reason != SQLITE_CHANGESET_FOREIGN_KEY) {
        const char* table = nullptr;
        int columns = 0;
        int operation = 0;
        int indirect = 0;
        if (sqlite3changeset_op(iterator, &table, &columns, &operation, &indirect) == SQLITE_OK) {
            conflict.table = table;
            conflict.rowid = key_of(iterator, operation, columns);
        }
    }
    if (!apply_context.conflict) apply_context.conflict = std::move(conflict);
    return SQLITE_CHANGESET_ABORT;
}

int size_of(std::span<const std::byte> changeset) {
    if (changeset.size() > 0x7FFFFFFFU) throw damaged();
    return static_cast<int>(changeset.size());
}

// The session API takes void* but only reads.
void* start_of(std::span<const std::byte> changeset) { return const_cast<std::byte*>(changeset.data()); }

} // namespace

void Session::Delete::operator()(sqlite3_session* session) const noexcept { sqlite3session_delete(session); }

Session::Session(const Database& database) : database_(&database) {
    sqlite3_session* session = nullptr;
    const int result = sqlite3session_create(database.native(), "main", &session);
    if (result != SQLITE_OK) throw error_of(database.connection(), result);
    session_.reset(session);
}

void Session::attach(std::string_view table) {
    const int result = sqlite3session_attach(session_.get(), std::string{table}.c_str());
    if (result != SQLITE_OK) throw error_of(database_->connection(), result);
}

Changeset Session::changeset() const {
    Changeset changes;
    const auto append = [](void* context, const void* data, int size) {
        auto& out = *static_cast<Changeset*>(context);
        const auto* start = static_cast<const std::byte*>(data);
        out.insert(out.end(), start, start + size);
        return SQLITE_OK;
    };
    const int result = sqlite3session_changeset_strm(session_.get(), append, &changes);
    if (result != SQLITE_OK) throw error_of(database_->connection(), result);
    return changes;
}

void for_each_row(std::span<const std::byte> changeset, Direction direction,
                  const std::function<void(const ChangedRow&)>& see) {
    if (changeset.empty()) return;
    sqlite3_changeset_iter* raw = nullptr;
    const int flags = direction == Direction::Inverse ? SQLITE_CHANGESETSTART_INVERT : 0;
    if (sqlite3changeset_start_v2(&raw, size_of(changeset), start_of(changeset), flags) != SQLITE_OK) throw damaged();
    const std::unique_ptr<sqlite3_changeset_iter, FinalizeIterator> iterator{raw};
    int result = sqlite3changeset_next(iterator.get());
    while (result == SQLITE_ROW) {
        see(read_row(iterator.get()));
        result = sqlite3changeset_next(iterator.get());
    }
    if (result != SQLITE_DONE) throw damaged();
}

std::optional<ApplyConflict> apply(const Database& database, std::span<const std::byte> changeset, Direction direction,
                                   std::span<const std::string> tables) {
    if (changeset.empty()) return std::nullopt;
    ApplyContext context{tables, std::nullopt, false};
    const int flags = direction == Direction::Inverse ? SQLITE_CHANGESETAPPLY_INVERT : 0;
    const int result = sqlite3changeset_apply_v2(database.native(), size_of(changeset), start_of(changeset),
                                                 &allow_table, &note_conflict, &context, nullptr, nullptr, flags);
    if (context.conflict) return context.conflict;
    if (context.foreign_table || (result & 0xFF) == SQLITE_CORRUPT) throw damaged();
    if (result != SQLITE_OK) throw error_of(database.connection(), result);
    return std::nullopt;
}

} // namespace planum::sqlite
