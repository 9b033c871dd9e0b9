// SPDX-License-Identifier: MIT
#include "scans/surface/cells_as_seen.hpp"

#include <bit>

namespace planum::scans {

namespace {

// Not a number is like itself here.
bool are_alike(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

CellAsSeen cell_of(const SurfaceGrid& grid, std::size_t i) {
    return {i,
            grid.height[i],
            grid.spread[i],
            grid.pose_sigma[i],
            grid.slope[i],
            grid.side_east[i],
            grid.side_north[i],
            grid.count[i],
            grid.state[i]};
}

bool are_alike(const CellAsSeen& a, const CellAsSeen& b) {
    return are_alike(a.height, b.height) && are_alike(a.spread, b.spread) && are_alike(a.pose_sigma, b.pose_sigma) &&
           are_alike(a.slope, b.slope) && are_alike(a.side_east, b.side_east) &&
           are_alike(a.side_north, b.side_north) && a.count == b.count && a.state == b.state;
}

} // namespace

std::vector<CellAsSeen> cells_as_seen(const SurfaceGrid& seen, const SurfaceGrid& grid) {
    std::vector<CellAsSeen> cells;
    for (std::size_t i = 0; i < grid.frame.cells(); ++i) {
        const CellAsSeen one = cell_of(seen, i);
        if (!are_alike(one, cell_of(grid, i))) cells.push_back(one);
    }
    return cells;
}

void put_back(SurfaceGrid& grid, std::span<const CellAsSeen> as_seen) {
    for (const CellAsSeen& one : as_seen) {
        if (one.cell >= grid.frame.cells()) continue;
        const auto i = static_cast<std::size_t>(one.cell);
        grid.height[i] = one.height;
        grid.spread[i] = one.spread;
        grid.pose_sigma[i] = one.pose_sigma;
        grid.slope[i] = one.slope;
        grid.side_east[i] = one.side_east;
        grid.side_north[i] = one.side_north;
        grid.count[i] = one.count;
        grid.state[i] = one.state;
    }
}

} // namespace planum::scans
