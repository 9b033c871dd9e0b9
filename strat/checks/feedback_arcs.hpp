// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planum::strat {

/// An arc of a small graph with what it costs to doubt it; weights are positive.
struct WeightedArc {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    double weight = 1.0;

    friend bool operator==(const WeightedArc&, const WeightedArc&) = default;
};

/// A set of arcs without which no cycle is left.
struct FeedbackSet {
    std::vector<std::uint32_t> arcs; ///< positions, ascending
    double weight = 0.0;
    bool exact = true;     ///< no cheaper set exists
    double at_least = 0.0; ///< proven: no set weighs less than this

    friend bool operator==(const FeedbackSet&, const FeedbackSet&) = default;
};

struct FeedbackOptions {
    std::size_t exact_up_to = 20; ///< nodes of a strong component that is solved exactly; at most 24
};

/// A feedback arc set of least weight: each strong component up to `exact_up_to` nodes exactly (dynamic
/// programme over subsets after contraction), larger ones by local ratio (Demetrescu, Finocchi 2003),
/// sifting and removal of what is not needed. Deterministic; ties go to the smaller positions.
[[nodiscard]] FeedbackSet minimum_feedback_arcs(std::size_t nodes, std::span<const WeightedArc> arcs,
                                                const FeedbackOptions& options = {});

/// The heuristic alone, whatever the size.
[[nodiscard]] FeedbackSet heuristic_feedback_arcs(std::size_t nodes, std::span<const WeightedArc> arcs);

/// The exact programme alone for one strongly connected graph of at most 24 nodes; `bound` is the weight
/// of any known solution (infinity: none).
[[nodiscard]] FeedbackSet exact_feedback_arcs(std::size_t nodes, std::span<const WeightedArc> arcs, double bound);

/// For each arc the weight of the cheapest feedback set that contains it. Exact where the graph is small
/// enough to solve it again without the arc, elsewhere an upper bound from exchanging the arc against
/// arcs of `best`. Arcs on no cycle get infinity.
[[nodiscard]] std::vector<double> cheapest_with_each(std::size_t nodes, std::span<const WeightedArc> arcs,
                                                     const FeedbackSet& best, const FeedbackOptions& options = {});

/// Whether the arcs without those flagged form no cycle.
[[nodiscard]] bool is_acyclic(std::size_t nodes, std::span<const WeightedArc> arcs, const std::vector<char>& left_out);

} // namespace planum::strat
