// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string>

namespace planum {

/// What kind of failure it was; decides the exit status (see exit_status).
enum class ErrorCode {
    Usage,     ///< the call itself is wrong
    BadInput,  ///< a file or value cannot be used
    NotFound,  ///< something named does not exist
    Conflict,  ///< a rule of the project forbids it
    Io,        ///< disk, permissions, a file in use
    Cancelled, ///< stopped by the user
    Internal,  ///< the program is wrong
};

/// The one exception type: the operation cannot be done. The message is lower case, names the thing
/// and the limit, and has no full stop. Context is put in front on the way up:
/// `site.gpkg: adding unit 1042: number already used in area A`.
class Error : public std::exception {
  public:
    Error(ErrorCode code, std::string message);

    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

    [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }

    /// Puts `context: ` in front. Use as `catch (Error& e) { e.add_context(file); throw; }`.
    void add_context(const std::string& context);

  private:
    ErrorCode code_;
    std::string message_;
};

/// Exit status of a program that ended with this error: 2 usage, 3 bad input, 4 I/O, 70 internal.
[[nodiscard]] int exit_status(ErrorCode code) noexcept;

} // namespace planum
