// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planum::scans {

/// Unpacks LZF, as PCD's binary_compressed uses it. Throws BadInput that names the byte when the packed
/// bytes are damaged or do not give exactly `size` bytes; refuses before allocating when so few packed
/// bytes cannot give so many.
[[nodiscard]] std::string unpack_lzf(std::string_view packed, std::size_t size);

} // namespace planum::scans
