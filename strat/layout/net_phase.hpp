// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/rank_phase.hpp"

namespace planum::strat {

/// Orders that share a line. Every later box of a net is later than every earlier one by an immediate
/// order of the drawing, so whatever the shared line is read as is true.
struct Net {
    std::vector<std::uint32_t> later;
    std::vector<std::uint32_t> earlier;
    std::vector<std::uint32_t> orders; ///< positions in DrawnGraph::orders: all later × earlier
    bool upwards = false;              ///< a single order drawn against time
};

/// Bundles orders into nets: complete fans of several later and several earlier boxes first, then stars,
/// the largest first, so that few lines meet at a box. Orders of different looks (uncertain, in a cycle,
/// marked) never share a line.
[[nodiscard]] std::vector<Net> bundle_orders(const DrawnGraph& graph, const Ranking& ranking);

} // namespace planum::strat
