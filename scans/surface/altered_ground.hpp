// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// A patch of ground that does not lie where it should.
struct AlteredPatch {
    double x = 0.0; ///< the middle of a cell in it [m, site]
    double y = 0.0;
    double area = 0.0;       ///< of its cells inside outlines [m²]
    double change = 0.0;     ///< median of how much higher it is now [m]; 0 from patch_inside()
    double detectable = 0.0; ///< median of what could be told from none there, 95 % [m]; 0 from patch_inside()
    double low = 0.0;        ///< heights of the ground there [m, site]
    double high = 0.0;
    std::map<std::int32_t, double> regions; ///< its area by region [m²]
};

struct RiseRules {
    double tolerance = 0.02;     ///< the project's own, a 95 % bound [m]
    double sensor_sigma = 0.002; ///< of one point [m]
    double least_area = 0.1;     ///< smaller patches are passed over [m²]
};

/// Where the ground is higher than on the surface before: by more than twice the tolerance (see step_between(), which
/// lets such cells prove nothing) and more than 95 % of noise, poses and slope allow. Only cells that both saw as
/// ground and that `region` puts into an outline count; lines of one or two cells do not. Largest first. `region` has
/// frame.cells() values, kNoRegion outside. Throws BadInput when the grids do not lie on the same cells.
[[nodiscard]] std::vector<AlteredPatch> risen_ground(const SurfaceGrid& before, const SurfaceGrid& after,
                                                     std::span<const std::int32_t> region, const RiseRules& rules);

/// The part of a patch that lies inside outlines; area 0 where none does.
[[nodiscard]] AlteredPatch patch_inside(const SurfaceGrid& grid, std::span<const std::size_t> cells,
                                        std::span<const std::int32_t> region);

} // namespace planum::scans
