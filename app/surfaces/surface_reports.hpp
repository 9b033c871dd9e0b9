// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

/// Where two scans of a surface say different heights.
struct DisputeReport {
    double x = 0.0; ///< a place inside [m]
    double y = 0.0;
    double area = 0.0;       ///< [m²]
    double difference = 0.0; ///< [m]
    std::string lower;       ///< scan
    std::string higher;
};

struct HeightsReport {
    std::string surface;
    std::vector<std::string> scans; ///< that it was made from
    std::vector<std::string> raw;   ///< of that surface, not registered and so left out
    std::uint64_t points = 0;
    double area = 0.0;      ///< of ground, in plan [m²]
    double face_area = 0.0; ///< of sides, in plan [m²]
    double lowest = 0.0;    ///< of the ground [m]; 0 where there is none
    double highest = 0.0;
    std::vector<DisputeReport> disputed; ///< largest first
};

/// Makes the heights of a surface with cells of `cell` [m] and writes them as GeoTIFF in the project's reference
/// system, a world file (.tfw) beside it; `file` empty: only reports. Throws as known_surface() and
/// recorded_surface(), Usage for another ending than .tif or .tiff, Io.
HeightsReport write_heights(Project& project, std::string_view surface, double cell, const std::filesystem::path& file,
                            Progress& progress);

/// What changed between two surfaces where both saw ground.
struct ChangeReport {
    std::string before;
    std::string after;
    double compared_area = 0.0; ///< [m²]
    double lowered_area = 0.0;  ///< of it, beyond the level of detection [m²]
    double raised_area = 0.0;   ///< of it, beyond the level of detection [m²]
    double detectable = 0.0;    ///< median: smaller changes cannot be told from none, 95 % [m]; 0: nothing compared
};

/// Writes two bands, `change` (after − before) and `detectable`, as write_heights() does. Throws as that, and Usage
/// for surfaces of two areas.
ChangeReport write_change(Project& project, std::string_view before, std::string_view after, double cell,
                          const std::filesystem::path& file, Progress& progress);

} // namespace planum::app
