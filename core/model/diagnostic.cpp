// SPDX-License-Identifier: MIT
#include "core/model/diagnostic.hpp"

namespace planum::model {

std::string_view to_word(Severity severity) noexcept {
    switch (severity) {
    case Severity::Error: return "error";
    case Severity::Warning: return "warning";
    case Severity::Info: return "info";
    }
    return {};
}

} // namespace planum::model
