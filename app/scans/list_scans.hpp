// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/model/scan.hpp"

namespace planum::app {

/// One line of `planum scan list`.
struct ListedScan {
    std::string scan;
    std::string day;
    std::string surface;
    std::int64_t points = 0;
    std::string status; ///< raw, registered
    std::string method; ///< of the run that placed it; empty: not placed
    std::array<double, 16> site_from_scan{};
    double rms = 0.0; ///< [m]
    double overlap = 0.0;
    double sigma_position = 0.0;     ///< root of the largest eigenvalue [m]
    double sigma_rotation_deg = 0.0; ///< the same of the rotation
    std::string verdict;
    std::string file; ///< of the original, as recorded
    bool original_there = true;
};

/// Scans in natural order of their names.
[[nodiscard]] std::vector<ListedScan> list_scans(Project& project);

/// The scan of that name. Throws NotFound.
[[nodiscard]] const model::Scan& scan_named(Project& project, std::string_view name);

/// Marks a scan deleted, as one undo step. Its point store stays as a cache until `verify --clean`.
void delete_scan(Project& project, std::string_view name);

} // namespace planum::app
