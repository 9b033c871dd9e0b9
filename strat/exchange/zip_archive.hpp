// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace planum::strat {

/// Whether the bytes begin as a zip does.
[[nodiscard]] bool is_zip(std::string_view bytes) noexcept;

/// The named members of a zip in memory, found by the last part of their path. Nothing is written to
/// disk. Throws BadInput when the archive is damaged, has over 10,000 members, or when a member is
/// larger than `limit` bytes or more than 200 times its share of the archive (a decompression bomb).
[[nodiscard]] std::map<std::string, std::string> read_zip(std::string_view bytes, std::string_view file_name,
                                                          std::span<const std::string_view> wanted, std::size_t limit);

/// A zip of these members; the same bytes for the same input (no times, fixed order).
[[nodiscard]] std::string write_zip(std::span<const std::pair<std::string, std::string>> members);

} // namespace planum::strat
