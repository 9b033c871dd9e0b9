// SPDX-License-Identifier: MIT
#include "core/sqlite/database.hpp"

#include <array>
#include <mutex>
#include <utility>

#include <sqlite3.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/sqlite/connection.hpp"

namespace planum::sqlite {

namespace {

constexpr int kBusyTimeout = 10'000;   // [ms]
constexpr int kProgressEvery = 20'000; // virtual machine steps, a fraction of a millisecond

struct Limit {
    int what;
    int value;
};

// No record of a dig comes near any of these; a file made to exhaust memory or time does.
constexpr std::array kLimits = {
    Limit{SQLITE_LIMIT_LENGTH, 64 * 1024 * 1024},
    Limit{SQLITE_LIMIT_SQL_LENGTH, 200'000},
    Limit{SQLITE_LIMIT_COLUMN, 1000},
    Limit{SQLITE_LIMIT_EXPR_DEPTH, 200},
    Limit{SQLITE_LIMIT_COMPOUND_SELECT, 200},
    Limit{SQLITE_LIMIT_VDBE_OP, 250'000},
    Limit{SQLITE_LIMIT_FUNCTION_ARG, 32},
    Limit{SQLITE_LIMIT_ATTACHED, 0},
    Limit{SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 500},
    Limit{SQLITE_LIMIT_VARIABLE_NUMBER, 2000},
    Limit{SQLITE_LIMIT_TRIGGER_DEPTH, 10},
    Limit{SQLITE_LIMIT_WORKER_THREADS, 0},
};

int flags_of(Access access) noexcept {
    constexpr int kCommon = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE | SQLITE_OPEN_EXRESCODE;
    switch (access) {
    case Access::ReadOnly: return kCommon | SQLITE_OPEN_READONLY;
    case Access::Immutable: return kCommon | SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    case Access::ReadWrite: return kCommon | SQLITE_OPEN_READWRITE;
    case Access::Create: return kCommon | SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    }
    return kCommon | SQLITE_OPEN_READONLY;
}

// `file:` form of an absolute path; everything that has a meaning in a URI is escaped.
std::string immutable_uri(const std::filesystem::path& file) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string uri = "file://";
    for (const char c : std::filesystem::absolute(file).string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                           (byte >= 'a' && byte <= 'z') || byte == '/' || byte == '.' || byte == '-' || byte == '_';
        if (plain) {
            uri += c;
        } else {
            uri += '%';
            uri += kHex[byte >> 4U];
            uri += kHex[byte & 0xFU];
        }
    }
    return uri + "?immutable=1";
}

int stop_requested(void* context) { return static_cast<const Connection*>(context)->stop.stop_requested() ? 1 : 0; }

void harden(const Connection& connection) {
    sqlite3* db = connection.handle;
    for (const Limit& limit : kLimits) sqlite3_limit(db, limit.what, limit.value);
    sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_WRITABLE_SCHEMA, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_FTS3_TOKENIZER, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_FKEY, 1, nullptr);
    sqlite3_busy_timeout(db, kBusyTimeout);
    // Neither pragma reads the file, so a damaged one is not met here.
    const int result = sqlite3_exec(db, "PRAGMA cell_size_check=ON; PRAGMA mmap_size=0", nullptr, nullptr, nullptr);
    if (result != SQLITE_OK) throw error_of(connection, result);
}

// Memory statistics cost a lock for every allocation, a seventh of an import. Has no effect, and does no
// harm, where another library of the process has started SQLite already.
void configure_once() {
    static std::once_flag once;
    std::call_once(once, [] { sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0); });
}

std::unique_ptr<Connection> connect(const std::string& where, std::string name, int flags) {
    configure_once();
    auto connection = std::make_unique<Connection>();
    connection->name = std::move(name);
    const int result = sqlite3_open_v2(where.c_str(), &connection->handle, flags, nullptr);
    if (result != SQLITE_OK) throw error_of(*connection, result);
    harden(*connection);
    return connection;
}

bool has_content(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file, ignored);
    return !ignored && size > 0;
}

} // namespace

Database::Database(std::unique_ptr<Connection> connection, Access access) noexcept
    : connection_(std::move(connection)), access_(access) {}

Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

Database Database::open(const std::filesystem::path& file, Access access) {
    const std::string where = access == Access::Immutable ? immutable_uri(file) : file.string();
    Database database{connect(where, file.string(), flags_of(access)), access};
    const bool writes = access == Access::ReadWrite || access == Access::Create;
    // SQLite opens what it may not write read-only, without a word.
    if (writes && sqlite3_db_readonly(database.native(), "main") == 1) {
        throw Error(ErrorCode::Io, file.string() + ": the file is read-only");
    }
    return database;
}

Database Database::open_foreign(const std::filesystem::path& file) {
    const FileHeader header = read_header(file);
    const bool wal_beside = has_content(file.string() + "-wal");
    Database database = open(file, header.wal && !wal_beside ? Access::Immutable : Access::ReadOnly);
    database.enable_foreign_keys(false);
    database.enable_triggers(false);
    return database;
}

Database Database::in_memory() { return Database{connect(":memory:", "", flags_of(Access::Create)), Access::Create}; }

Statement Database::prepare(std::string_view sql) const {
    sqlite3_stmt* statement = nullptr;
    const char* rest = nullptr;
    const int result = sqlite3_prepare_v3(connection_->handle, sql.data(), static_cast<int>(sql.size()),
                                          SQLITE_PREPARE_PERSISTENT, &statement, &rest);
    if (result != SQLITE_OK) throw error_of(*connection_, result);
    Statement prepared{*connection_, statement};
    const std::string_view left = sql.substr(static_cast<std::size_t>(rest - sql.data()));
    if (statement == nullptr || !text::trim(left).empty()) {
        throw Error(ErrorCode::Internal, "not exactly one statement: " + std::string{sql.substr(0, 80)});
    }
    return prepared;
}

void Database::execute(std::string_view script) const {
    const int result = sqlite3_exec(connection_->handle, std::string{script}.c_str(), nullptr, nullptr, nullptr);
    if (result != SQLITE_OK) throw error_of(*connection_, result);
}

std::int64_t Database::integer(std::string_view sql) const {
    Statement statement = prepare(sql);
    return statement.step() ? statement.integer(0) : 0;
}

std::string Database::text(std::string_view sql) const {
    Statement statement = prepare(sql);
    return statement.step() ? std::string{statement.text(0)} : std::string{};
}

bool Database::has_table(std::string_view name) const {
    Statement statement = prepare("SELECT 1 FROM sqlite_schema WHERE type='table' AND name=:name COLLATE NOCASE");
    return statement.bind(":name", name).step();
}

std::vector<std::string> Database::columns(std::string_view table) const {
    std::vector<std::string> names;
    Statement statement = prepare("SELECT name FROM pragma_table_info(:table) ORDER BY cid");
    statement.bind(":table", table);
    while (statement.step()) names.emplace_back(statement.text(0));
    return names;
}

std::int64_t Database::last_insert_rowid() const noexcept { return sqlite3_last_insert_rowid(connection_->handle); }

std::int64_t Database::changes() const noexcept { return sqlite3_changes64(connection_->handle); }

bool Database::in_transaction() const noexcept { return sqlite3_get_autocommit(connection_->handle) == 0; }

void Database::stop_with(std::stop_token token) {
    connection_->stop = std::move(token);
    if (connection_->stop.stop_possible()) {
        sqlite3_progress_handler(connection_->handle, kProgressEvery, &stop_requested, connection_.get());
    } else {
        sqlite3_progress_handler(connection_->handle, 0, nullptr, nullptr);
    }
}

void Database::compact() const {
    // SQLite attaches the new file to the old one while it copies; on disk, also where temporary data are kept in
    // memory.
    const int none = sqlite3_limit(connection_->handle, SQLITE_LIMIT_ATTACHED, 1);
    const std::string temporary = text("PRAGMA temp_store");
    const auto restore = [&] {
        execute("PRAGMA temp_store = " + temporary);
        sqlite3_limit(connection_->handle, SQLITE_LIMIT_ATTACHED, none);
    };
    execute("PRAGMA temp_store = FILE");
    try {
        execute("VACUUM");
    } catch (...) {
        restore();
        throw;
    }
    restore();
}

void Database::enable_triggers(bool on) const {
    sqlite3_db_config(connection_->handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, on ? 1 : 0, nullptr);
}

void Database::enable_foreign_keys(bool on) const {
    sqlite3_db_config(connection_->handle, SQLITE_DBCONFIG_ENABLE_FKEY, on ? 1 : 0, nullptr);
}

const std::string& Database::name() const noexcept { return connection_->name; }

Access Database::access() const noexcept { return access_; }

sqlite3* Database::native() const noexcept { return connection_->handle; }

Transaction::Transaction(const Database& database) : database_(&database) { database.execute("BEGIN IMMEDIATE"); }

Transaction::~Transaction() {
    if (database_ == nullptr || !database_->in_transaction()) return;
    // A rollback that fails leaves a hot journal, which the next opening rolls back.
    sqlite3_exec(database_->native(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
    database_->execute("COMMIT");
    database_ = nullptr;
}

std::string quote_identifier(std::string_view name) { return "\"" + text::replace_all(name, "\"", "\"\"") + "\""; }

} // namespace planum::sqlite
