// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "strat/matrix/adjacency.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

/// Strongly connected components of the orders, numbered in topological order (later first; among those
/// free to choose, by smallest node), with the graph between them.
struct Condensation {
    std::vector<std::uint32_t> component_of; ///< by node
    Adjacency members;                       ///< nodes of each component, ascending
    Adjacency below;                         ///< distinct components below each component, ascending
    std::vector<std::uint32_t> rank;         ///< longest chain above
    std::uint32_t depth = 0;                 ///< components on the longest chain
};

/// Tarjan's components through Boost.Graph, then Kahn's order with a queue by smallest node.
[[nodiscard]] Condensation condense(std::size_t node_count, std::span<const Order> orders);

/// Which pairs of `below` (by position in below.values) a longer path implies: transitive reduction of an
/// acyclic graph whose components are numbered topologically (Aho, Garey, Ullman 1972), with reachability
/// as bit sets over blocks of targets so that memory stays small.
[[nodiscard]] std::vector<bool> redundant_pairs(const Adjacency& below);

} // namespace planum::strat
