// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "app/scans/verify_scans.hpp"

namespace planum::app {

/// One line of `region list`.
struct RegionRow {
    std::string region;
    std::string unit; ///< empty: none
    std::string day;
    std::string shows;
    std::string category;
    double area = 0.0;       ///< what it shows: less the regions inside it and what another claims too [m²]
    double drawn_area = 0.0; ///< within its lines [m²]
    std::int64_t points = 0;
    bool incomplete = false;    ///< points of a scan that cannot be read are not counted
    bool outside_scans = false; ///< there are registered scans of its day, and none shows it
    /// Of its points (see RegionHeights), else of its outline [m]; unset: neither has heights.
    std::optional<double> z_min;
    std::optional<double> z_median;
    std::optional<double> z_max;
    std::string drawn;             ///< the number as drawn, where no unit has it
    std::vector<std::string> near; ///< units that number may stand for
};

struct RegionList {
    std::vector<RegionRow> rows;
    std::vector<ScanProblem> problems; ///< scans whose points are not there, and what to do
};

/// All regions: by day, surface, unit. `day` empty: all days. Throws Usage when it is no day.
[[nodiscard]] RegionList list_regions(Project& project, const std::string& day, Progress& progress = Progress::none());

} // namespace planum::app
