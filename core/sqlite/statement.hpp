// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct sqlite3_stmt;

namespace planum::sqlite {

struct Connection;

/// Storage class of one value, as SQLite sees it.
enum class ValueType { Null, Integer, Real, Text, Blob };

/// A compiled statement: bind, step, read columns, reset, again. Text and blobs that are bound are copied
/// at once unless the name says otherwise; views that columns return live until the next step or reset.
/// Invariant: holds a live statement of a Database that must outlive it (or nothing, once moved from).
///
/// Every function throws Error with the file's name in front: BadInput for damaged files and wrong SQL,
/// Conflict for broken constraints, Io for locks and disks, Cancelled when the stop token was used.
class Statement {
  public:
    Statement() noexcept = default;

    // Parameters, by name with their colon (":number") or by index from 1.
    Statement& bind(std::string_view name, std::int64_t value) { return bind(parameter(name), value); }

    Statement& bind(std::string_view name, double value) { return bind(parameter(name), value); }

    Statement& bind(std::string_view name, std::string_view value) { return bind(parameter(name), value); }

    Statement& bind_blob(std::string_view name, std::span<const std::byte> value) {
        return bind_blob(parameter(name), value);
    }

    Statement& bind_null(std::string_view name) { return bind_null(parameter(name)); }

    Statement& bind(int index, std::int64_t value);
    Statement& bind(int index, double value);
    Statement& bind(int index, std::string_view value);
    /// Without a copy: the text must stay as it is until the statement is reset.
    Statement& bind_static(int index, std::string_view value);
    Statement& bind_blob(int index, std::span<const std::byte> value);
    Statement& bind_null(int index);

    /// Index of a named parameter, from 1. Throws Internal when the statement has none of that name.
    [[nodiscard]] int parameter(std::string_view name) const;

    /// True when a row can be read, false when the statement has finished.
    bool step();

    /// Runs to the end and resets; for statements without a result.
    void run();

    /// Ready to run again; bindings stay.
    void reset() noexcept;

    [[nodiscard]] int column_count() const noexcept;
    [[nodiscard]] std::string_view column_name(int column) const noexcept;

    // Columns of the current row, counted from 0. NULL reads as 0, 0.0 or empty.
    [[nodiscard]] ValueType type(int column) const noexcept;
    [[nodiscard]] bool is_null(int column) const noexcept;
    [[nodiscard]] std::int64_t integer(int column) const noexcept;
    [[nodiscard]] double real(int column) const noexcept;
    [[nodiscard]] std::string_view text(int column) const noexcept;
    [[nodiscard]] std::span<const std::byte> blob(int column) const noexcept;
    [[nodiscard]] std::optional<std::int64_t> optional_integer(int column) const noexcept;
    [[nodiscard]] std::optional<double> optional_real(int column) const noexcept;

    /// False for a default-constructed or moved-from statement.
    [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(statement_); }

  private:
    friend class Database;

    struct Finalize {
        void operator()(sqlite3_stmt* statement) const noexcept;
    };

    Statement(const Connection& connection, sqlite3_stmt* statement) noexcept
        : connection_(&connection), statement_(statement) {}

    void check_bind(int result) const;

    const Connection* connection_ = nullptr;
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

} // namespace planum::sqlite
