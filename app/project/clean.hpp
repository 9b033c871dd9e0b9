// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// What cleaning took away.
struct Cleaned {
    std::vector<std::filesystem::path> removed; ///< files, sorted
    std::uintmax_t removed_bytes = 0;
    std::uintmax_t freed_bytes = 0;    ///< by which the project file became shorter
    std::size_t forgotten_changes = 0; ///< that can no longer be taken back
};

/// What clean_scans removes, kept heights of regions that have changed since, files that an interrupted backup or `new`
/// left beside the project more than a day ago, and the free pages of the project file. Undo steps of the changes made
/// before `forget_undo_before` (ISO date; empty: none) are dropped. The record stays as it is. Throws as
/// Project::change.
Cleaned clean_project(Project& project, const std::string& forget_undo_before, Progress& progress);

} // namespace planum::app
