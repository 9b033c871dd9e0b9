// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// A cell as all of its points say it is, those too that hang behind edges.
///
/// What hangs is left out of grids for the sake of volumes. Mixed pixels do, but so does now and then the rim of an
/// undercut, and without it a cell shows the floor beneath as if that had lain open. What surfaces prove is read from
/// what was seen, where such a cell has two heights and proves nothing.
struct CellAsSeen {
    std::uint64_t cell = 0;
    float height = 0.0F; ///< this and the rest as in SurfaceGrid
    float spread = 0.0F;
    float pose_sigma = 0.0F;
    float slope = 0.0F;
    float side_east = 0.0F;
    float side_north = 0.0F;
    std::uint16_t count = 0;
    CellState state = CellState::Unseen;
};

/// The cells of `seen` that are otherwise in `grid`; both have the same frame. Ascending.
[[nodiscard]] std::vector<CellAsSeen> cells_as_seen(const SurfaceGrid& seen, const SurfaceGrid& grid);

/// Puts them back. Cells beyond the frame are passed over.
void put_back(SurfaceGrid& grid, std::span<const CellAsSeen> as_seen);

} // namespace planum::scans
