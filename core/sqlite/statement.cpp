// SPDX-License-Identifier: MIT
#include "core/sqlite/statement.hpp"

#include <sqlite3.h>

#include "core/base/error.hpp"
#include "core/sqlite/connection.hpp"

namespace planum::sqlite {

void Statement::Finalize::operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }

void Statement::check_bind(int result) const {
    if (result != SQLITE_OK) throw error_of(*connection_, result);
}

int Statement::parameter(std::string_view name) const {
    const int index = sqlite3_bind_parameter_index(statement_.get(), std::string{name}.c_str());
    if (index == 0) throw Error(ErrorCode::Internal, "a statement has no parameter " + std::string{name});
    return index;
}

Statement& Statement::bind(int index, std::int64_t value) {
    check_bind(sqlite3_bind_int64(statement_.get(), index, value));
    return *this;
}

Statement& Statement::bind(int index, double value) {
    check_bind(sqlite3_bind_double(statement_.get(), index, value));
    return *this;
}

Statement& Statement::bind(int index, std::string_view value) {
    const char* start = value.data() == nullptr ? "" : value.data();
    check_bind(sqlite3_bind_text64(statement_.get(), index, start, value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind_static(int index, std::string_view value) {
    const char* start = value.data() == nullptr ? "" : value.data();
    check_bind(sqlite3_bind_text64(statement_.get(), index, start, value.size(), SQLITE_STATIC, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind_blob(int index, std::span<const std::byte> value) {
    if (value.empty()) {
        check_bind(sqlite3_bind_zeroblob(statement_.get(), index, 0));
        return *this;
    }
    check_bind(sqlite3_bind_blob64(statement_.get(), index, value.data(), value.size(), SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind_null(int index) {
    check_bind(sqlite3_bind_null(statement_.get(), index));
    return *this;
}

bool Statement::step() {
    const int result = sqlite3_step(statement_.get());
    if (result == SQLITE_ROW) return true;
    if (result == SQLITE_DONE) return false;
    // The message belongs to the failure, so it is read before the reset clears it.
    Error error = error_of(*connection_, sqlite3_extended_errcode(connection_->handle));
    sqlite3_reset(statement_.get());
    throw error;
}

void Statement::run() {
    while (step()) {
    }
    reset();
}

void Statement::reset() noexcept { sqlite3_reset(statement_.get()); }

int Statement::column_count() const noexcept { return sqlite3_column_count(statement_.get()); }

std::string_view Statement::column_name(int column) const noexcept {
    const char* name = sqlite3_column_name(statement_.get(), column);
    return name == nullptr ? std::string_view{} : std::string_view{name};
}

ValueType Statement::type(int column) const noexcept {
    switch (sqlite3_column_type(statement_.get(), column)) {
    case SQLITE_INTEGER: return ValueType::Integer;
    case SQLITE_FLOAT: return ValueType::Real;
    case SQLITE_TEXT: return ValueType::Text;
    case SQLITE_BLOB: return ValueType::Blob;
    default: return ValueType::Null;
    }
}

bool Statement::is_null(int column) const noexcept {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const noexcept { return sqlite3_column_int64(statement_.get(), column); }

double Statement::real(int column) const noexcept { return sqlite3_column_double(statement_.get(), column); }

std::string_view Statement::text(int column) const noexcept {
    const unsigned char* start = sqlite3_column_text(statement_.get(), column);
    if (start == nullptr) return {};
    const auto length = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return {reinterpret_cast<const char*>(start), length};
}

std::span<const std::byte> Statement::blob(int column) const noexcept {
    const void* start = sqlite3_column_blob(statement_.get(), column);
    if (start == nullptr) return {};
    const auto length = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return {static_cast<const std::byte*>(start), length};
}

std::optional<std::int64_t> Statement::optional_integer(int column) const noexcept {
    return is_null(column) ? std::nullopt : std::optional{integer(column)};
}

std::optional<double> Statement::optional_real(int column) const noexcept {
    return is_null(column) ? std::nullopt : std::optional{real(column)};
}

} // namespace planum::sqlite
