// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "strat/layout/level_neighbours.hpp"

namespace planum::strat {

/// x of each node [pt], the mean of the four extreme layouts of Brandes and Köpf 2002, with the corrections of Brandes,
/// Walter and Zink 2020: where the third phase begins.
[[nodiscard]] std::vector<double> averaged_layouts(const LevelNeighbours& neighbours);

} // namespace planum::strat
