// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/layout/order_phase.hpp"

namespace planum::strat {

/// What the third phase must know of a node beside its edges.
struct NodeExtent {
    double width = 0.0;   ///< [pt]
    double gap = 0.0;     ///< to its neighbours: the smaller of the two counts [pt]
    bool is_line = false; ///< a line passing the level, which should run straight
    /// Nodes of one group keep all others out of the rectangle around them, −1: of none. They must stand side by
    /// side on each level, and two groups in the same order on every level they share.
    std::int32_t group = -1;
};

/// Third phase: x of each node's centre [pt], neighbours at least their gaps apart, lines straight and
/// boxes near the middle of their neighbours: Brandes and Köpf 2002 with the corrections of Brandes,
/// Walter and Zink 2020; the four extreme layouts are averaged.
[[nodiscard]] std::vector<double> place_nodes(const LayeredGraph& graph, const std::vector<NodeExtent>& extents);

} // namespace planum::strat
