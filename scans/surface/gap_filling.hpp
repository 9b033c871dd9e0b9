// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

struct GapOptions {
    double reach = 0.5;     ///< cells farther than this from any ground stay unknown [m]
    double fence_gap = 0.2; ///< faces no farther apart than this are one side, where no ground is between [m]
    double doubt = 0.15;    ///< σ of a filled height for each metre from the ground it was taken from
};

/// Heights of a surface with its gaps closed.
struct FilledHeights {
    GridFrame frame;
    std::vector<float> height;   ///< NaN where unknown
    std::vector<float> sigma;    ///< of what was filled in; 0 where ground was seen [m]
    std::vector<float> distance; ///< from the ground that was seen nearest [m]
    std::vector<bool> was_seen;  ///< Surface or Disputed
};

/// Closes gaps in the ground by a membrane that upright sides cut: what lies in the shadow of a trench wall is
/// continued from the floor, not from the field above it. A cell that a side runs through is divided between the ground
/// on both sides of it by the line on which points of the side lie along it; where none shows the line,
/// halfway. Where a side is several cells wide, its cells lie where their points do.
[[nodiscard]] FilledHeights fill_gaps(const SurfaceGrid& grid, const GapOptions& options = {});

} // namespace planum::scans
