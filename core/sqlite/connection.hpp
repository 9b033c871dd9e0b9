// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <string>

#include "core/base/error.hpp"

struct sqlite3;

namespace planum::sqlite {

/// What Database, Statement and Session share: the handle, and the name that messages begin with.
struct Connection {
    sqlite3* handle = nullptr;
    std::string name;
    std::stop_token stop;

    Connection() = default;
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection();
};

/// The last failure of a connection as an Error: a plain sentence behind the file's name.
/// @param result what the SQLite call returned (an extended code)
[[nodiscard]] Error error_of(const Connection& connection, int result);

} // namespace planum::sqlite
