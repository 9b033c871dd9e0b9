// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scans/surface/gap_filling.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

struct UndugRules {
    double sigmas = 3.0;        ///< changes of no more σ than this can be none
    double point_sigma = 0.002; ///< of a single point: noise, and not the same grain on both days [m]
    double most_mean = 0.005;   ///< ground whose mean change is more was dug, however unsure the poses are [m]
    double near = 0.25;         ///< ground is judged together with what lies within so much [m]
    double farthest = 1.5;      ///< gaps are judged by what was seen within so much at most [m]
    double share = 0.9;         ///< of the cells seen on both days must be still
    int fewest = 40;            ///< cells seen on both days say something
    double beside = 0.1;        ///< gaps with changed ground, or signs of it, within so much are not undug [m]
    double spread = 0.25;       ///< nor what of the same gap lies within so much of such a sign [m]
    double hardly = 0.3;        ///< where fewer cells than this share of what is usual are seen beside, is a gap
    double below = 0.03;        ///< what lies, or must lie, lower by more contradicts [m]
    double side_shift = 0.25;   ///< sides that moved by more cells were cut back
};

/// A surface and its heights with gaps closed.
struct ClosedSurface {
    const SurfaceGrid& grid;
    const FilledHeights& filled;
};

/// Cells of common_frame() on which nobody dug between two surfaces: changes there are noise and errors of poses.
///
/// Ground that both saw is undug where it is *still*, changed by no more than noise, slope and poses allow, in the
/// midst of ground that is nearly all still and has not sunk or risen as a whole by more than the poses allow. A gap in
/// either surface is undug where the ground around it is, its sides stand where they stood, and nothing speaks against
/// it: no floor laid by a spot level on one day only, no line of sight and no point of one day clearly below the ground
/// of the other, no change right beside it.
///
/// It is meant for sums: that a hand's breadth was scraped by less than the poses can tell goes unnoticed.
[[nodiscard]] std::vector<bool> undug_ground(const ClosedSurface& before, const ClosedSurface& after,
                                             const UndugRules& rules = {});

} // namespace planum::scans
