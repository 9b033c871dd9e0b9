// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// Writes the points of a region as binary PLY in site coordinates, with intensity and colour where the scans have
/// them. Returns their number. Throws NotFound when there are none, and says why; Io.
std::int64_t write_region_points(Project& project, const model::Region& region, const std::filesystem::path& ply,
                                 Progress& progress);

} // namespace planum::app
