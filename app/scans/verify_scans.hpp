// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

struct ScanProblem {
    std::string where; ///< `scan DAY/STEM`
    std::string what;  ///< a sentence
};

/// Reads all originals and all point stores: originals must be there with the hash they were added with, every block
/// of a store must have its checksum. A damaged store is made again from a sound original at once, and that is said;
/// one that is missing is no problem, it is made when next asked for. Throws Cancelled.
[[nodiscard]] std::vector<ScanProblem> verify_scans(Project& project, Progress& progress);

struct CleanedScans {
    std::vector<std::filesystem::path> removed;
    std::uint64_t bytes = 0;
};

/// Removes from `NAME.scans` the stores of scans that are no longer in the project, and half-written files that a
/// program left behind that was killed. What other programs are writing just now is left alone. Throws Io.
CleanedScans clean_scans(Project& project);

} // namespace planum::app
