// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/layout/drawn_graph.hpp"

namespace planum::strat {

/// Part of the first phase, for graphs without bands: the widest levels of each component, where they are much
/// wider than the mean, give boxes to others, as dot's balancing does. Only boxes, or chains of boxes as a whole,
/// with one order above and one below move, and not over these, so that no line grows longer in sum. `fixed`
/// boxes stay. `rank`, by box, satisfies all orders but the `upwards` ones before and after.
void balance_levels(const DrawnGraph& graph, const std::vector<bool>& upwards,
                    const std::vector<std::uint32_t>& component, const std::vector<bool>& fixed,
                    std::vector<std::int32_t>& rank);

} // namespace planum::strat
