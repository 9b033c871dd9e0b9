// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "scans/surface/cells_as_seen.hpp"
#include "scans/surface/passing_things.hpp"
#include "scans/surface/point_source.hpp"
#include "scans/surface/sight_lines.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

struct SurfaceOptions {
    double tolerance = 0.02;     ///< the project's own, a 95 % bound [m]; scans may differ by so much
    double disputed_area = 0.1;  ///< scans that disagree over less are averaged [m²]
    double steepest = 1.7320508; ///< tangent of 60°: steeper is a side
    bool remove_passing =
        true; ///< people, vehicles, strays, what hangs behind edges; see mark_passing(), mark_hanging()
    PassingRules passing;
    SightRules sight;
    std::uint64_t memory_bytes = 512ULL << 20U; ///< for points
    int threads = 2;
};

/// Where scans of one surface say different heights: it changed between them, or one is placed badly.
struct DisputedPatch {
    double x = 0.0; ///< a place inside [m]
    double y = 0.0;
    double area = 0.0;       ///< [m²]
    double difference = 0.0; ///< median of how much they differ [m]
    double detectable = 0.0; ///< median of what could be told apart there, 95 % [m]
    std::string lower;       ///< the scan that mostly says the lower height
    std::string higher;
    std::vector<std::size_t> cells; ///< of the frame, ascending
};

struct BuiltSurface {
    SurfaceGrid grid;
    std::vector<CellAsSeen> as_seen;     ///< cells that are otherwise in `grid` because of what hangs behind edges
    std::vector<DisputedPatch> disputed; ///< largest first
    std::uint64_t points = 0;            ///< of the scans, within the frame
    PassingReport passing;
    std::size_t hanging = 0; ///< layers of a few points that hang behind edges; see mark_hanging()
};

/// A frame that covers a rectangle, corners on whole cells. Throws BadInput for an empty rectangle, or one of more than
/// 400 million cells.
[[nodiscard]] GridFrame frame_around(const PlanBox& box, double cell);

/// The heights of a surface from its scans.
///
/// A cell with one layer of points (see find_layers) has its median for a height; two layers, points drawn out over
/// more than 60° give, or a slope of over 60° make a face. The slope is that of the plane which fits best
/// among windows of 5 × 5 and 3 × 5 cells that contain the cell (after Nagao and Matsuyama 1979), so that ground beside
/// an edge keeps its own. `pose_sigma` is how far an error of the poses lifts the ground at that place and slope, a
/// mean over the scans that see the cell: their errors are common to all of it.
/// Where scans disagree by more than 95 % of tolerance, noise, poses and slope allow, over `disputed_area` or more
/// after lines of up to two cells are left out, cells are Disputed and keep the height of the scan with most points.
///
/// The same input gives the same surface, whatever the threads and the memory.
[[nodiscard]] BuiltSurface build_surface(std::span<const SurfaceScan> scans, const GridFrame& frame,
                                         const SurfaceOptions& options, Progress& progress);

} // namespace planum::scans
