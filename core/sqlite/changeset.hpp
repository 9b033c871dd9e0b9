// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/sqlite/database.hpp"

struct sqlite3_session;

namespace planum::sqlite {

using Changeset = std::vector<std::byte>;

/// Records what happens to the rows of the attached tables from now until it is destroyed.
/// Invariant: a live session of a Database that outlives it.
class Session {
  public:
    explicit Session(const Database& database);

    void attach(std::string_view table);

    /// Everything that changed, as one value; empty when nothing did.
    [[nodiscard]] Changeset changeset() const;

  private:
    struct Delete {
        void operator()(sqlite3_session* session) const noexcept;
    };

    const Database* database_;
    std::unique_ptr<sqlite3_session, Delete> session_;
};

enum class Direction { Forward, Inverse };
enum class RowOperation { Insert, Update, Delete };

/// One value of a changeset as text, as the log shows it; blobs in hexadecimal.
struct LoggedValue {
    bool null = true;
    std::string text;

    friend bool operator==(const LoggedValue&, const LoggedValue&) = default;
};

/// One row of a changeset in the direction asked for. Values stand in column order; those that an update
/// leaves as they are (and the key's new value) are absent.
struct ChangedRow {
    std::string_view table;
    RowOperation operation = RowOperation::Insert;
    std::int64_t rowid = 0; ///< the integer primary key
    std::vector<std::optional<LoggedValue>> before;
    std::vector<std::optional<LoggedValue>> after;
};

/// Calls `see` for every row. Throws BadInput when the changeset is damaged.
void for_each_row(std::span<const std::byte> changeset, Direction direction,
                  const std::function<void(const ChangedRow&)>& see);

/// What kept a changeset from being applied.
struct ApplyConflict {
    std::string table; ///< empty: foreign keys would be broken
    std::int64_t rowid = 0;
};

/// Applies all of it or nothing, triggers as they are set on the connection, inside the caller's
/// transaction. Rows of tables outside `tables` make it damaged: Error{BadInput}. Returns the first
/// conflict, or nothing when all rows were as the changeset expects them.
[[nodiscard]] std::optional<ApplyConflict> apply(const Database& database, std::span<const std::byte> changeset,
                                                 Direction direction, std::span<const std::string> tables);

} // namespace planum::sqlite
