// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "strat/layout/level_neighbours.hpp"

namespace planum::strat {

/// Takes small steps out of long lines, which look like slips of the pen, and lets lines run straight into boxes
/// anywhere along their edges. Only lines move; other lines in the way are pushed aside where that makes fewer bends in
/// all. `x` by node [pt]; separations are kept, but lines may come as near to boxes as style::kLeastLineGap.
void take_out_steps(const LevelNeighbours& neighbours, std::vector<double>& x);

} // namespace planum::strat
