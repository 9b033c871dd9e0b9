// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "strat/layout/level_neighbours.hpp"

namespace planum::strat {

/// Moves boxes, with the straight lines that hang on them, over the middle of what they fan out to, above or below,
/// where the levels have room and no line becomes longer or loses its straight run. The least sum of horizontal ways,
/// which the simplex finds, leaves it open where between two neighbours a box stands; a draughtsman would put it in the
/// middle. `x` [pt] by node, as place_nodes leaves it; no node comes nearer to another than its gap.
void centre_over_fans(const LevelNeighbours& neighbours, std::vector<double>& x);

} // namespace planum::strat
