// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/project/project.hpp"
#include "app/surfaces/surface_reports.hpp"
#include "core/base/progress.hpp"

namespace planum::scans {
struct SurfaceDifference;
} // namespace planum::scans

namespace planum::app {

/// What changed between two surfaces as numbers, cell by cell, for whoever draws it.
struct HeightChange {
    double low_x = 0.0; ///< of the south-western corner, site [m]
    double low_y = 0.0;
    double cell = 0.02; ///< [m]
    int columns = 0;
    int rows = 0;
    std::vector<float> change;     ///< after − before [m], row by row from the south; NaN unless both saw ground
    std::vector<float> detectable; ///< smaller changes cannot be told from none, 95 % [m]
    ChangeReport report;
};

/// Areas and the median level of detection of a difference; the names stay empty.
[[nodiscard]] ChangeReport report_on(const scans::SurfaceDifference& difference);

/// On the smallest of kComparedCells that the scans of both fill. Throws as known_surface() and recorded_surface(), and
/// Usage for surfaces of two areas.
[[nodiscard]] HeightChange height_change(Project& project, model::SurfaceId before, model::SurfaceId after,
                                         Progress& progress);

} // namespace planum::app
