// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace planum::strat {

/// The longest line of a table or list, and the longest value between marks of XML or JSON, that a record may have.
inline constexpr std::size_t kMaxTextRun = 16U << 20U; // bytes

/// Throws BadInput naming file and line when a line is longer than kMaxTextRun. XML and JSON may stand in one line: of
/// files that begin like them, what stands between two angle brackets or quotation marks is measured instead. Looked
/// for before a file is decoded, as each step after that copies it.
void refuse_endless_text(std::string_view bytes, std::string_view file_name);

} // namespace planum::strat
