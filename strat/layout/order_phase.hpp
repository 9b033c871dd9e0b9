// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/progress.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

/// Nodes on levels with edges between neighbouring levels only.
struct LayeredGraph {
    std::uint32_t nodes = 0;
    std::vector<std::vector<std::uint32_t>> layers;             ///< nodes of each level, left to right
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; ///< (upper, lower)
};

/// Each node's neighbours on the next level, and on the one before.
[[nodiscard]] Adjacency neighbours_below(const LayeredGraph& graph);
[[nodiscard]] Adjacency neighbours_above(const LayeredGraph& graph);

struct OrderOptions {
    std::int64_t work = 0;   ///< about how many steps may be spent; 0: by the size of the graph
    bool keep_given = false; ///< begin with the given order and only better it where neighbours swap
    std::vector<bool> held;  ///< by node: of these no two swap then; empty: none is held
};

/// Second phase: sorts each level so that few edges cross: barycentres and medians in sweeps, then
/// neighbours swapped and nodes sifted while that helps; the best order seen wins. Throws Cancelled.
void order_layers(LayeredGraph& graph, const OrderOptions& options, Progress& progress);

[[nodiscard]] std::int64_t count_crossings(const LayeredGraph& graph);

} // namespace planum::strat
