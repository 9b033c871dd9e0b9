// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// A set of cells of a frame: 1 for those in it.
using CellSet = std::vector<std::uint8_t>;

/// Cells whose 3 × 3 neighbourhood lies in the set, grown again by as much: lines of one or two cells go.
[[nodiscard]] CellSet opened(const GridFrame& frame, const CellSet& set);

/// Takes the patch that hangs together with the cell `start` (corners count) out of the set. Ascending.
[[nodiscard]] std::vector<std::size_t> take_patch(const GridFrame& frame, CellSet& set, std::size_t start);

} // namespace planum::scans
