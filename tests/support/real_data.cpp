// SPDX-License-Identifier: MIT
#include "tests/support/real_data.hpp"

#include <cstdlib>
#include <iostream>

namespace planum::test {

std::optional<std::filesystem::path> real_data(std::string_view relative) {
    const char* told = std::getenv("PLANUM_SHARED_DATA");
    const std::filesystem::path root = told != nullptr ? told : source_folder() / "../shared/data";
    const std::filesystem::path file = root / relative;
    if (std::filesystem::exists(file)) return file;
    std::cerr << "SKIPPED, real data absent: " << relative << '\n';
    return std::nullopt;
}

std::filesystem::path source_folder() { return PLANUM_SOURCE_DIR; }

std::filesystem::path binary_folder() { return PLANUM_BINARY_DIR; }

} // namespace planum::test
