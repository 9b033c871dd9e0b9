// SPDX-License-Identifier: MIT
#include "core/base/error.hpp"

#include <utility>

namespace planum {

Error::Error(ErrorCode code, std::string message) : code_(code), message_(std::move(message)) {}

void Error::add_context(const std::string& context) { message_ = context + ": " + message_; }

int exit_status(ErrorCode code) noexcept {
    switch (code) {
    case ErrorCode::Usage: return 2;
    case ErrorCode::BadInput:
    case ErrorCode::NotFound:
    case ErrorCode::Conflict: return 3;
    case ErrorCode::Io: return 4;
    case ErrorCode::Cancelled: return 130;
    case ErrorCode::Internal: return 70;
    }
    return 70;
}

} // namespace planum
