// SPDX-License-Identifier: MIT
#include <cerrno>

#include <sqlite3.h>

#include <fmt/format.h>

#include "core/sqlite/connection.hpp"

namespace planum::sqlite {

namespace {

Error disk_error(const Connection& connection, int extended) {
    const int cause = connection.handle == nullptr ? 0 : sqlite3_system_errno(connection.handle);
    if (cause == ENOSPC || cause == EDQUOT || cause == EFBIG) {
        return {ErrorCode::Io, "the disk is full: nothing was changed; free some space and try again"};
    }
    if (cause == EROFS || cause == EACCES || cause == EPERM) {
        return {ErrorCode::Io, "the file or its folder cannot be written: check the permissions"};
    }
    if (extended == SQLITE_IOERR_SHORT_READ || extended == SQLITE_IOERR_CORRUPTFS) {
        return {ErrorCode::BadInput, "the file is damaged or cut short: restore a backup"};
    }
    return {ErrorCode::Io,
            fmt::format("reading or writing the disk failed ({}): nothing was changed; see that the disk has space, is "
                        "still there and allows files of this size, and try again",
                        sqlite3_errstr(extended))};
}

Error plain_error(const Connection& connection, int result) {
    const std::string said = connection.handle == nullptr ? sqlite3_errstr(result) : sqlite3_errmsg(connection.handle);
    switch (result & 0xFF) {
    case SQLITE_NOTADB: return {ErrorCode::BadInput, "not a SQLite database"};
    case SQLITE_CORRUPT: return {ErrorCode::BadInput, fmt::format("the file is damaged ({}): restore a backup", said)};
    case SQLITE_FORMAT: return {ErrorCode::BadInput, "the file is damaged: restore a backup"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return {ErrorCode::Io, "in use by another program: close it there and try again"};
    case SQLITE_FULL: return {ErrorCode::Io, "the disk is full: nothing was changed; free some space and try again"};
    case SQLITE_IOERR: return disk_error(connection, result);
    case SQLITE_READONLY:
        if (result == SQLITE_READONLY_ROLLBACK || result == SQLITE_READONLY_RECOVERY) {
            return {ErrorCode::Io, "an interrupted change has to be taken back first, and the file or its folder "
                                   "cannot be written: copy it with the files beside it to a place that can"};
        }
        return {ErrorCode::Io, "the file or its folder is read-only"};
    case SQLITE_CANTOPEN: return {ErrorCode::Io, "cannot be opened: check the name, the folder and the permissions"};
    case SQLITE_PERM:
    case SQLITE_AUTH: return {ErrorCode::Io, "access denied"};
    case SQLITE_CONSTRAINT: return {ErrorCode::Conflict, said};
    case SQLITE_TOOBIG: return {ErrorCode::BadInput, "a value is larger than 64 MB"};
    case SQLITE_INTERRUPT: return {ErrorCode::Cancelled, "stopped"};
    case SQLITE_NOMEM: return {ErrorCode::Io, "out of memory"};
    case SQLITE_MISUSE: return {ErrorCode::Internal, said};
    case SQLITE_SCHEMA: return {ErrorCode::Io, "another program changed the tables meanwhile: try again"};
    default: return {ErrorCode::BadInput, said};
    }
}

} // namespace

Connection::~Connection() {
    // Statements are owned by objects that must go first; _v2 waits for any that did not.
    sqlite3_close_v2(handle);
}

Error error_of(const Connection& connection, int result) {
    Error error = plain_error(connection, result);
    if (!connection.name.empty()) error.add_context(connection.name);
    return error;
}

} // namespace planum::sqlite
