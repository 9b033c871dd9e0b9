// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// Slope of the ground at a cell.
struct LocalPlane {
    double dz_dx = 0.0;
    double dz_dy = 0.0;
    double rms = 0.0; ///< of the heights around the plane [m]
    double off = 0.0; ///< least distance of the cell from any plane through the others of a window [m]
};

/// The plane that fits best among the window of 5 × 5 cells around a cell and its four halves (3 × 5, the cell on their
/// edge), from heights that are numbers; where points lie sparsely, of 11 × 11 cells. nullopt with fewer than six in
/// each.
[[nodiscard]] std::optional<LocalPlane> local_plane(const GridFrame& frame, const std::vector<float>& height,
                                                    std::int32_t row, std::int32_t column);

} // namespace planum::scans
