// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace planum::strat {

/// An arc of a levelling problem: rank(to) ≥ rank(from) + length; its slack costs `weight` a level.
struct RankArc {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::int32_t length = 1;
    std::int32_t weight = 1;
};

/// Ranks ≥ 0 that satisfy all arcs of an acyclic graph with the least weighted sum of spans, by network
/// simplex after Gansner, Koutsofios, North and Vo 1993; after `max_pivots` the best so far, which is
/// feasible all the same. Parts that no arc joins each begin at 0. `start`, where it is given, must satisfy
/// all arcs: a good one saves most of the work.
[[nodiscard]] std::vector<std::int32_t> network_simplex(std::uint32_t nodes, const std::vector<RankArc>& arcs,
                                                        std::int64_t max_pivots,
                                                        const std::vector<std::int32_t>& start = {});

} // namespace planum::strat
