// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/project/project.hpp"
#include "app/scans/verify_scans.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// Number and heights of the points of a region. Lowest and highest are the 0.5 and 99.5 per cent quantiles: a person
/// in the trench or a mixed pixel is no height of a unit.
struct RegionHeights {
    std::int64_t points = 0;
    bool outside_scans = false; ///< there are registered scans of its day, and none shows it
    bool incomplete = false;    ///< a scan that may show it could not be read, so its points are not counted
    double lowest = 0.0;        ///< [m]
    double median = 0.0;
    double highest = 0.0;
};

struct CountedHeights {
    std::vector<RegionHeights> regions; ///< of every region of the record, in its order
    std::vector<ScanProblem> problems;  ///< scans whose points are not there, and what to do
};

/// Heights of all regions; kept in NAME.scans/regions by what they were made from, so that only what changed is counted
/// again. Without points where no registered scan shows the region. Throws Cancelled.
[[nodiscard]] CountedHeights heights_of_regions(Project& project, Progress& progress);

/// Files of NAME.scans/regions that no region of the record needs any more, sorted.
[[nodiscard]] std::vector<std::filesystem::path> stale_region_heights(Project& project);

} // namespace planum::app
