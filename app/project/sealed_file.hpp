// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace planum::app {

/// A file of a cache ends with the SHA-256 of what stands before it. What stands before it, or nothing where the file
/// is missing, damaged or cannot be read: what it holds is then made again.
[[nodiscard]] std::optional<std::string> read_sealed(const std::filesystem::path& file);

/// Writes one, with its folder. What cannot be written (read-only media, a full disk) is done without.
void write_sealed(const std::filesystem::path& file, std::string bytes);

} // namespace planum::app
