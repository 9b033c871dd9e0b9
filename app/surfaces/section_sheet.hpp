// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/map_sheet.hpp"

namespace planum::app {

struct SectionRequest {
    std::array<double, 2> from{}; ///< site [m]
    std::array<double, 2> to{};
    std::string surface; ///< only its scans; empty: all scans
    /// Where the scans of several surfaces lie in the plane, each surface in one tone, with a key; later ones over
    /// earlier ones. False: as one picture, to draw on.
    bool surfaces_apart = false;
    double depth = 0.05; ///< points so far before and behind the plane are shown [m]
    double cell = 0.02;  ///< of the picture [m]
};

struct SectionSheet {
    geometry::MapSheet sheet; ///< x along the section from `from`, y height
    std::size_t points = 0;
    std::size_t outlines = 0;       ///< that lie in the plane
    std::vector<std::string> units; ///< whose outlines lie in the plane
};

/// A rectified picture of what registered scans show in a vertical plane, in scan colour or else reflectance
/// (or surfaces in tones, see SectionRequest), with level lines and the outlines of all regions that lie in the plane
/// within 10 cm. Throws Usage when both ends are one place, NotFound for an unknown surface, BadInput when neither
/// points nor outlines lie in the plane.
[[nodiscard]] SectionSheet section_sheet(Project& project, const SectionRequest& request, Progress& progress);

} // namespace planum::app
