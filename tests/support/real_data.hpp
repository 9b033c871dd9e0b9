// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace planum::test {

/// A file or folder of the real data beside the repository (`matrix/hm/bldg-1-5`), or nullopt, said by
/// name on stderr, where it is absent. $PLANUM_SHARED_DATA says another place.
[[nodiscard]] std::optional<std::filesystem::path> real_data(std::string_view relative);

/// The repository, and the folder it is built in.
[[nodiscard]] std::filesystem::path source_folder();
[[nodiscard]] std::filesystem::path binary_folder();

} // namespace planum::test
