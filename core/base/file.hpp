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

/// Throws BadInput when `file` is an SQLite database: a slip of the hand (`-o site.gpkg`) must not cost
/// the record. Says nothing about files that are not there or cannot be read.
void refuse_to_replace_database(const std::filesystem::path& file);

/// Writes beside the target and renames, after fsync: the file is the old one or the new one, never
/// half. A link is followed; a device or pipe is written into. Throws BadInput when the target is an
/// SQLite database, else Io, and then leaves nothing behind.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

} // namespace planum
