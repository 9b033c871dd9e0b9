// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scans/surface/gap_filling.hpp"

namespace planum::scans {

/// Continues sides that lean into a gap as steep as they were seen, down to what the gap was filled with: the foot of
/// a trench wall that stands at 5 cm a metre and ends in a shadow lies farther out than the last that was seen of it.
///
/// How a side leans is the plane through its faces within 30 cm that hang together, by least squares, each where its
/// points lie in its cell (SurfaceGrid::side_east), with `fence` for what a side is. It counts where the faces reach
/// over 0.7 cells across the side and the plane says half of how their points differ in height, within cells too, so
/// that the edges of cells are not taken for a lean. Cells of the side itself take their heights from the plane as
/// well. Gaps in which it would rise above a line of sight, cells that were seen and floors that spot heights laid stay
/// as they are.
void continue_leaning_sides(FilledHeights& filled, const SurfaceGrid& grid, const std::vector<bool>& fence);

} // namespace planum::scans
