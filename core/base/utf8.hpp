// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace planum::text {

/// Appends one code point; the caller sees to it that it is one (no surrogate, at most U+10FFFF).
void append_utf8(std::string& out, char32_t code);

} // namespace planum::text
