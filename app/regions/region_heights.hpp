// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// Number and heights of the points of a region. Lowest and highest are the 0.5 and 99.5 per cent quantiles: a person
/// in the trench or a mixed pixel is no height of a unit.
struct RegionHeights {
    std::int64_t points = 0;
    bool outside_scans = false; ///< there are registered scans of its day, and none shows it
    double lowest = 0.0;        ///< [m]
    double median = 0.0;
    double highest = 0.0;
};

/// Heights of every region of the record, in its order; kept in NAME.scans/regions by what they were made from, so
/// that only what changed is counted again. Without points where no registered scan shows the region.
[[nodiscard]] std::vector<RegionHeights> heights_of_regions(Project& project, Progress& progress);

} // namespace planum::app
