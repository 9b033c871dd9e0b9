// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace planum {

/// Whether the text is a day of the calendar as `2025-06-01`: not 30 February, and nothing behind it.
[[nodiscard]] bool is_day(std::string_view text) noexcept;

} // namespace planum
