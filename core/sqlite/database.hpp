// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/sqlite/statement.hpp"

struct sqlite3;

namespace planum::sqlite {

enum class Access {
    ReadOnly,  ///< never writes, not even a journal
    Immutable, ///< read-only and without locks: for media that cannot be written by anybody
    ReadWrite, ///< must exist
    Create,    ///< made when it does not exist
};

/// What a file says about itself in its first 100 bytes, before SQLite touches it.
struct FileHeader {
    std::int64_t page_size = 0; ///< [bytes]
    std::int64_t pages = 0;     ///< as the header claims; 0 where an old writer left it stale
    std::int64_t file_size = 0; ///< [bytes]
    std::uint32_t application_id = 0;
    std::uint32_t user_version = 0;
    bool wal = false; ///< the file is in write-ahead mode
};

/// Reads the header with plain file reads. Throws NotFound, Io, or BadInput when the file is no SQLite
/// database or is shorter than its header says. With a journal beside it a short file is let through: a
/// commit writes the header before the pages it counts, so SQLite has to roll it back, or wait, first.
[[nodiscard]] FileHeader read_header(const std::filesystem::path& file);

/// One connection to one SQLite file, opened the distrustful way: triggers and views may use harmless
/// functions only (trusted_schema off), no writing of the schema table (defensive), no extensions, no
/// attached files, pages checked while read, limits on lengths and depths.
///
/// Invariant: an open connection (or nothing, once moved from). Not thread-safe; several connections to the
/// same file may live in several threads.
class Database {
  public:
    /// Throws Error with the file's name in front; see Statement for the codes. ReadWrite on a file that
    /// cannot be written is Error{Io}.
    [[nodiscard]] static Database open(const std::filesystem::path& file, Access access);

    /// Read-only opening of a file that another program made: the header is read first, and a file left in
    /// write-ahead mode is read without making files beside it. Foreign keys and triggers are off.
    [[nodiscard]] static Database open_foreign(const std::filesystem::path& file);

    [[nodiscard]] static Database in_memory();

    Database(Database&&) noexcept;
    Database& operator=(Database&&) noexcept;
    ~Database();

    /// One statement; text after it is an Error{Internal}.
    [[nodiscard]] Statement prepare(std::string_view sql) const;

    /// Any number of statements, results ignored.
    void execute(std::string_view script) const;

    /// First column of the first row; 0 or empty when there is none.
    [[nodiscard]] std::int64_t integer(std::string_view sql) const;
    [[nodiscard]] std::string text(std::string_view sql) const;

    [[nodiscard]] bool has_table(std::string_view name) const; ///< a table, not a view; ASCII case ignored
    /// Column names of a table in order; empty when there is no such table.
    [[nodiscard]] std::vector<std::string> columns(std::string_view table) const;

    [[nodiscard]] std::int64_t last_insert_rowid() const noexcept;
    [[nodiscard]] std::int64_t changes() const noexcept; ///< rows changed by the last statement
    [[nodiscard]] bool in_transaction() const noexcept;

    /// Statements that run longer than a moment look at the token and end with Error{Cancelled}.
    void stop_with(std::stop_token token);

    /// VACUUM: writes the file anew without free pages, outside a transaction.
    void compact() const;

    void enable_triggers(bool on) const;
    void enable_foreign_keys(bool on) const; ///< outside a transaction only

    [[nodiscard]] const std::string& name() const noexcept; ///< the file as it was given, for messages
    [[nodiscard]] Access access() const noexcept;           ///< as it was opened
    [[nodiscard]] sqlite3* native() const noexcept;         ///< for core/sqlite's own wrappers

    [[nodiscard]] const Connection& connection() const noexcept { return *connection_; }

  private:
    Database(std::unique_ptr<Connection> connection, Access access) noexcept;
    std::unique_ptr<Connection> connection_;
    Access access_;
};

/// BEGIN IMMEDIATE … COMMIT; rolls back in the destructor when commit() was not reached.
class Transaction {
  public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    void commit();

  private:
    const Database* database_;
};

/// "name" with its quotes doubled, for identifiers that come from a file.
[[nodiscard]] std::string quote_identifier(std::string_view name);

} // namespace planum::sqlite
