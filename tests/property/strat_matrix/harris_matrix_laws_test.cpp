// SPDX-License-Identifier: MIT
#include "strat/matrix/condensation.hpp"
#include "strat/matrix/harris_matrix.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "tests/support/catch.hpp"
#include "tests/support/record_builder.hpp"

using namespace planum;
using strat::HarrisMatrix;
using strat::NodeIndex;

namespace {

using Reach = std::vector<std::vector<bool>>;

// Warshall 1962: too slow to ship and too simple to be wrong.
Reach closure(std::size_t nodes, const std::vector<strat::Order>& orders) {
    Reach reach(nodes, std::vector<bool>(nodes, false));
    for (const auto& order : orders) reach[order.later][order.earlier] = true;
    for (std::size_t k = 0; k < nodes; ++k) {
        for (std::size_t i = 0; i < nodes; ++i) {
            for (std::size_t j = 0; j < nodes; ++j) {
                if (reach[i][k] && reach[k][j]) reach[i][j] = true;
            }
        }
    }
    return reach;
}

std::vector<strat::Order> all_orders(const HarrisMatrix& m) { return {m.orders().begin(), m.orders().end()}; }

std::vector<strat::Order> reduced_orders(const HarrisMatrix& m) {
    std::vector<strat::Order> orders;
    for (const auto at : m.reduced()) orders.push_back(m.orders()[at]);
    return orders;
}

struct Edge {
    int from = 0;
    int to = 0;
    int kind = 0; // 0…7 covers, 8 same_as
};

model::Record make_record(int units, const std::vector<Edge>& edges) {
    auto builder = test::a_record();
    for (int u = 0; u < units; ++u) builder.unit(std::to_string(u));
    for (const Edge& e : edges) {
        if (e.kind == 8) {
            builder.same_as(std::to_string(e.from), std::to_string(e.to));
        } else {
            builder.covers(std::to_string(e.from), std::to_string(e.to));
        }
    }
    return builder.record();
}

std::vector<Edge> some_edges(int units, bool acyclic) {
    const int count = *rc::gen::inRange(0, 3 * units);
    std::vector<Edge> edges;
    for (int i = 0; i < count; ++i) {
        Edge e{*rc::gen::inRange(0, units), *rc::gen::inRange(0, units), *rc::gen::inRange(0, 9)};
        if (acyclic) {
            e.kind = 0;
            if (e.from == e.to) continue;
            if (e.from > e.to) std::swap(e.from, e.to);
        }
        edges.push_back(e);
    }
    return edges;
}

} // namespace

TEST_CASE("Reduction keeps the closure, and every order between components is needed for it") {
    CHECK(rc::check([] {
        const int units = *rc::gen::inRange(1, 14);
        const auto matrix = HarrisMatrix::build(make_record(units, some_edges(units, false)));
        const auto full = closure(matrix.node_count(), all_orders(matrix));
        const auto reduced = reduced_orders(matrix);
        RC_ASSERT(closure(matrix.node_count(), reduced) == full);
        for (std::size_t i = 0; i < reduced.size(); ++i) {
            const auto a = matrix.component_of(reduced[i].later);
            const auto b = matrix.component_of(reduced[i].earlier);
            if (a == b) continue;
            // All orders between the same two components go together.
            std::vector<strat::Order> rest;
            for (const auto& o : reduced) {
                if (matrix.component_of(o.later) != a || matrix.component_of(o.earlier) != b) rest.push_back(o);
            }
            RC_ASSERT(closure(matrix.node_count(), rest) != full);
        }
    }));
}

TEST_CASE("Reachability, components and ranks agree with Warshall") {
    CHECK(rc::check([] {
        const int units = *rc::gen::inRange(1, 12);
        const auto matrix = HarrisMatrix::build(make_record(units, some_edges(units, false)));
        const auto reach = closure(matrix.node_count(), all_orders(matrix));
        for (NodeIndex a = 0; a < matrix.node_count(); ++a) {
            for (NodeIndex b = 0; b < matrix.node_count(); ++b) {
                RC_ASSERT(matrix.is_later(a, b) == reach[a][b]);
                RC_ASSERT((matrix.component_of(a) == matrix.component_of(b)) ==
                          (a == b || (reach[a][b] && reach[b][a])));
                RC_ASSERT(matrix.shortest_path(a, b).empty() != reach[a][b]);
            }
        }
        for (const auto& order : matrix.orders()) {
            const auto a = matrix.component_of(order.later);
            const auto b = matrix.component_of(order.earlier);
            RC_ASSERT(a <= b);
            RC_ASSERT(a == b || matrix.rank_from_top(a) < matrix.rank_from_top(b));
        }
    }));
}

TEST_CASE("An order added backwards along a path is always found as a cycle") {
    CHECK(rc::check([] {
        const int units = *rc::gen::inRange(2, 14);
        auto edges = some_edges(units, true);
        if (edges.empty()) edges.push_back({0, 1, 0});
        const auto before = HarrisMatrix::build(make_record(units, edges));
        RC_ASSERT(before.stats().cycle_groups == 0);
        const auto picked = edges[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(edges.size())))];
        edges.push_back({picked.to, picked.from, 0});
        RC_ASSERT(HarrisMatrix::build(make_record(units, edges)).stats().cycle_groups > 0);
    }));
}

TEST_CASE("The order of the input does not matter") {
    CHECK(rc::check([] {
        const int units = *rc::gen::inRange(1, 12);
        auto edges = some_edges(units, false);
        const auto one = HarrisMatrix::build(make_record(units, edges));
        std::reverse(edges.begin(), edges.end());
        const auto other = HarrisMatrix::build(make_record(units, edges));
        RC_ASSERT(one.stats() == other.stats());
        RC_ASSERT(all_orders(one) == all_orders(other));
        RC_ASSERT(reduced_orders(one) == reduced_orders(other));
    }));
}

TEST_CASE("Reduction in blocks of targets equals reduction pair by pair beyond one block") {
    // 2,500 components need three blocks; sparse enough for a search per pair as oracle.
    const std::size_t count = 2500;
    std::uint64_t state = 20250601; // the seed
    INFO("seed " << state);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t a = 0; a + 1 < count; ++a) {
        for (int k = 0; k < 3; ++k) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            const auto b =
                static_cast<std::uint32_t>(a + 1 + (state >> 33U) % std::min<std::size_t>(40, count - a - 1));
            pairs.emplace_back(a, b);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    const auto below = strat::Adjacency::make(
        count, pairs.size(), [&](std::size_t i) { return pairs[i].first; },
        [&](std::size_t i) { return pairs[i].second; });
    const auto redundant = strat::redundant_pairs(below);
    const auto reaches = [&](std::uint32_t from, std::uint32_t to) {
        std::vector<std::uint32_t> open = {from};
        std::vector<bool> seen(count, false);
        while (!open.empty()) {
            const auto at = open.back();
            open.pop_back();
            for (const auto next : below.row(at)) {
                if (next == to && at != from) return true;
                if (next < to && !seen[next]) {
                    seen[next] = true;
                    open.push_back(next);
                }
            }
        }
        return false;
    };
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) wrong += reaches(pairs[i].first, pairs[i].second) != redundant[i];
    CHECK(wrong == 0);
    CHECK(std::count(redundant.begin(), redundant.end(), true) > 0);
}
