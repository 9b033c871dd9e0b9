// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/layout/drawn_graph.hpp"

namespace planum::strat {

/// The level of each box, 0 on top, and which orders had to be drawn upwards.
struct Ranking {
    std::vector<std::int32_t> rank;       ///< by box; isolated ones have 0
    std::vector<bool> upwards;            ///< by order: against a cycle's best reading, or against the bands
    std::vector<std::uint32_t> component; ///< by box: parts that no order, contemporaneity or frame joins
    std::uint32_t component_count = 0;
    /// First level of each band and, last, the level after them; empty without bands.
    std::vector<std::int32_t> band_begin;
};

/// First phase: later units on higher levels, contemporary ones on one level where no order contradicts,
/// lines short in sum, topsoil first and natural ground last in its component, bands one under the other.
/// Components begin at level 0 each, unless there are bands.
[[nodiscard]] Ranking rank_boxes(const DrawnGraph& graph);

} // namespace planum::strat
