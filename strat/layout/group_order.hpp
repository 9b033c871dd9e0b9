// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.hpp"
#include "strat/layout/order_phase.hpp"

namespace planum::strat {

/// Which nodes of a LayeredGraph stand in a frame together.
struct NodeGroups {
    std::vector<std::int32_t> group; ///< by node; −1: in none
    std::vector<bool> leads;         ///< by node: leftmost of its group on its level (the heading)
    std::int32_t count = 0;
};

/// After order_layers: brings the nodes of each group side by side on every level, with groups left and right
/// of each other alike on all levels, so that a rectangle can be drawn around each; crosses few edges within
/// these bounds. A group must have a node on every level from its first to its last. Throws Cancelled.
void order_groups(LayeredGraph& graph, const NodeGroups& groups, Progress& progress);

} // namespace planum::strat
