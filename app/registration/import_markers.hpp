// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"

namespace planum::app {

struct MarkerImport {
    std::size_t added = 0;
    std::size_t updated = 0;
    std::size_t same = 0;
    std::vector<std::string> conflicts; ///< sentences: other coordinates than those that are there, kept
    std::vector<std::string> warnings;  ///< scans the project does not have, markers nobody surveyed
};

struct MarkerImportOptions {
    bool update = false; ///< other coordinates replace those that are there
};

/// Merges the file into the project's markers, as one undo step. A second identical import changes nothing.
MarkerImport import_markers(Project& project, const std::filesystem::path& file, const MarkerImportOptions& options);

} // namespace planum::app
