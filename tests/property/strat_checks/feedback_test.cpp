// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include <rapidcheck.h>

#include "strat/checks/feedback_arcs.hpp"
#include "tests/support/catch.hpp"

using namespace planum::strat;

namespace {

struct SmallGraph {
    std::size_t nodes = 0;
    std::vector<WeightedArc> arcs;
};

SmallGraph any_graph(std::size_t most_nodes, std::size_t most_arcs) {
    SmallGraph g;
    g.nodes = *rc::gen::inRange<std::size_t>(2, most_nodes + 1);
    const auto arcs = *rc::gen::inRange<std::size_t>(1, most_arcs + 1);
    for (std::size_t i = 0; i < arcs; ++i) {
        const auto from = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(g.nodes));
        const auto to = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(g.nodes));
        if (from != to) g.arcs.push_back({from, to, static_cast<double>(*rc::gen::inRange(1, 20)) / 4.0});
    }
    return g;
}

// Too slow to ship and too simple to be wrong: every order of the nodes.
double brute_force(const SmallGraph& g) {
    std::vector<std::size_t> place(g.nodes);
    std::iota(place.begin(), place.end(), 0U);
    double best = 1e300;
    do {
        double weight = 0.0;
        for (const WeightedArc& a : g.arcs) weight += place[a.from] > place[a.to] ? a.weight : 0.0;
        best = std::min(best, weight);
    } while (std::next_permutation(place.begin(), place.end()));
    return best;
}

bool breaks_all(const SmallGraph& g, const FeedbackSet& set) {
    std::vector<char> left_out(g.arcs.size(), 0);
    for (const std::uint32_t arc : set.arcs) left_out[arc] = 1;
    return is_acyclic(g.nodes, g.arcs, left_out);
}

double weight_of(const SmallGraph& g, const FeedbackSet& set) {
    double weight = 0.0;
    for (const std::uint32_t arc : set.arcs) weight += g.arcs[arc].weight;
    return weight;
}

} // namespace

TEST_CASE("The exact feedback set is as cheap as the best of all orders") {
    CHECK(rc::check([] {
        const SmallGraph g = any_graph(7, 20);
        const FeedbackSet set = minimum_feedback_arcs(g.nodes, g.arcs);
        RC_ASSERT(set.exact);
        RC_ASSERT(breaks_all(g, set));
        RC_ASSERT(std::abs(set.weight - weight_of(g, set)) < 1e-9);
        RC_ASSERT(std::abs(set.weight - brute_force(g)) < 1e-9);
    }));
}

TEST_CASE("The heuristic breaks all cycles, needs each of its arcs and is never cheaper than the best") {
    std::size_t same = 0;
    std::size_t all = 0;
    CHECK(rc::check([&] {
        const SmallGraph g = any_graph(12, 40);
        const FeedbackSet exact = minimum_feedback_arcs(g.nodes, g.arcs, {20});
        const FeedbackSet set = heuristic_feedback_arcs(g.nodes, g.arcs);
        RC_ASSERT(breaks_all(g, set));
        RC_ASSERT(set.weight >= exact.weight - 1e-9);
        RC_ASSERT(set.weight <= 1.5 * exact.weight + 1e-9);
        for (std::size_t i = 0; i < set.arcs.size(); ++i) {
            FeedbackSet less = set;
            less.arcs.erase(less.arcs.begin() + static_cast<std::ptrdiff_t>(i));
            RC_ASSERT(!breaks_all(g, less));
        }
        ++all;
        same += set.weight <= exact.weight + 1e-9 ? 1U : 0U;
    }));
    INFO(same << " of " << all << " as cheap as the best");
    CHECK(same * 10 >= all * 9);
}

TEST_CASE("The cheapest set with an arc costs no less than the best, and the best one for its own arcs") {
    CHECK(rc::check([] {
        const SmallGraph g = any_graph(7, 16);
        const FeedbackSet best = minimum_feedback_arcs(g.nodes, g.arcs);
        const std::vector<double> cheapest = cheapest_with_each(g.nodes, g.arcs, best);
        for (std::uint32_t i = 0; i < cheapest.size(); ++i) {
            if (std::binary_search(best.arcs.begin(), best.arcs.end(), i)) {
                RC_ASSERT(std::abs(cheapest[i] - best.weight) < 1e-9);
            } else {
                RC_ASSERT(cheapest[i] >= best.weight - 1e-9);
            }
        }
    }));
}
