// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace planum::strat {

using Json = nlohmann::json;

/// Parses one JSON text. Throws Error{BadInput} with the line and column where it stopped and why, also for more than
/// 100 nested brackets, more than ten million values, and numbers beyond a double. Nothing of the library's own
/// exceptions leaves.
[[nodiscard]] Json parse_json(std::string_view utf8);

/// The member of an object, or nullptr when this is no object or has none of that name.
[[nodiscard]] const Json* json_member(const Json& value, std::string_view key);

/// The member as text, cleaned of control characters: strings, numbers and truth values as written; empty
/// when it is not there or something else.
[[nodiscard]] std::string json_text(const Json& value, std::string_view key);

/// A value itself as text, by the same rule.
[[nodiscard]] std::string json_scalar_text(const Json& value);

/// The member as a finite number, also when it is written as text.
[[nodiscard]] std::optional<double> json_number(const Json& value, std::string_view key);

} // namespace planum::strat
