// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace planum {

/// The whole file as bytes. Throws NotFound when it does not exist, BadInput when it is larger than
/// `limit` or no ordinary file, Io when reading fails.
[[nodiscard]] std::string read_file(const std::filesystem::path& file, std::uintmax_t limit);

/// Writes beside the target and renames, after fsync: the file is the old one or the new one, never
/// half. A link is followed; a device or pipe is written into. Throws Io, and then leaves nothing behind.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

} // namespace planum
