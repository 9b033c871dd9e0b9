// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/checks/check_context.hpp"
#include "strat/checks/feedback_arcs.hpp"
#include "strat/checks/relation_weights.hpp"

namespace planum::strat {

/// One cycle group as a graph of its own. Arc i is orders[i] of the matrix; its weight is the sum over the
/// relations behind it, moved up so that the least relation of the group still weighs something.
struct CycleGroup {
    CycleGroup(const CheckContext& context, const RelationWeights& weights, std::span<const NodeIndex> members);

    std::vector<NodeIndex> nodes; ///< ascending; positions are the nodes of the graph
    std::vector<WeightedArc> arcs;
    std::vector<std::uint32_t> orders;
    double shift = 0.0; ///< added to the log-odds of each relation

    [[nodiscard]] std::uint32_t local(NodeIndex node) const noexcept;
};

/// What to doubt in a cycle group.
struct GroupVerdict {
    std::vector<model::Suspect> suspects; ///< best first; the cheapest set of relations stands in front of its rivals
    std::vector<std::uint32_t> removals;  ///< positions in CycleGroup::arcs: without these no cycle is left
    bool exact = true;
    bool cannot_tell = false; ///< another choice would do as well
};

/// Prefer same_as statements where the group exists only because of them.
enum class SameAsFirst { No, Yes };

[[nodiscard]] GroupVerdict find_suspects(const CheckContext& context, const RelationWeights& weights,
                                         const CycleGroup& group, SameAsFirst same_as_first);

/// A shortest cycle through an arc, as positions in CycleGroup::arcs, beginning with it.
[[nodiscard]] std::vector<std::uint32_t> shortest_cycle_through(const CycleGroup& group, std::uint32_t arc);

} // namespace planum::strat
