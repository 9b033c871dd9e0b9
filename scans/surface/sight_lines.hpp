// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.hpp"
#include "scans/surface/layer_field.hpp"
#include "scans/surface/point_source.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

struct SightRules {
    double farthest = 2.5;    ///< shadows reach no farther in plan [m]
    double least_drop = 0.08; ///< from what throws a shadow to what is seen behind it [m]; less is a gap between points
    double around = 0.3;      ///< how many cells hold points is told from those within so much [m]
    double share = 0.3;       ///< of them must lie as a cell does, or it is a stray
    double fewest = 3.0;      ///< and so many at least
    double rough = 0.02;      ///< cells lie alike that differ by no more [m]
    double slope = 0.5;       ///< and by so much for each metre from one to the other
    int alone = 4; ///< cells with points within 6 cm, itself among them, are no more than this: a stray alone
    double alone_share = 0.2;  ///< nor than this share of what is usual
    double ground_near = 0.6;  ///< it hangs over ground within so much [m]
    double hangs = 0.08;       ///< that is lower by so much [m], and by `slope` times its distance
    double grazing = 0.03;     ///< no lower under a line of sight than this is on it [m]
    double beside_side = 0.04; ///< points of a side lie no farther apart than twice this [m]
    double hidden = 0.05; ///< share of what a scan saw that may lie in its own shadows, or it is none of one station
};

/// A layer that was taken out of the field: no ground, but it threw a shadow.
struct RemovedLayer {
    std::size_t cell = 0;
    HeightLayer layer;
};

/// How high ground can reach that nobody saw, cell by cell [m]; not a number where no shadow says so.
///
/// Where a scan saw an edge, and behind it something lower, what lies between is no higher than the line of sight over
/// that edge, or the scan would have seen it. Nothing is said of what lies before a side that only others saw: it may
/// belong to the edge. Of several scans the lowest line counts. Cells with ground get one too where they are strays
/// (see drop_hanging()). Scans after the 31st say nothing, nor those whose points lie behind each other as seen from
/// where they are said to stand, as flown clouds do.
[[nodiscard]] std::vector<float> lines_of_sight(const LayerField& field, std::span<const RemovedLayer> removed,
                                                const SurfaceGrid& grid, std::span<const SurfaceScan> scans,
                                                const SightRules& rules, int threads, Progress& progress);

/// Makes Unseen of strays, cells at a height at which hardly any cells around have their points, that hang on or above
/// a line of sight: beams that met an edge with half their width, which scanners report somewhere between it and what
/// lies behind. Returns how many there were.
std::size_t drop_hanging(SurfaceGrid& grid, const SightRules& rules);

} // namespace planum::scans
