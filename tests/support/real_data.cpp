// SPDX-License-Identifier: MIT
#include "tests/support/real_data.hpp"

#include <cstdlib>
#include <iostream>

namespace planum::test {

std::optional<std::filesystem::path> real_data(std::string_view relative) {
    const char* told = std::getenv("PLANUM_SHARED_DATA");
    const std::filesystem::path root = told != nullptr ? told : PLANUM_SHARED_DATA;
    const std::filesystem::path file = root / relative;
    if (std::filesystem::exists(file)) return file;
    std::cerr << "SKIPPED, real data absent: " << relative << '\n';
    return std::nullopt;
}

} // namespace planum::test
