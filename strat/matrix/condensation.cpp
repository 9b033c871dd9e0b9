// SPDX-License-Identifier: MIT
#include "strat/matrix/condensation.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/strong_components.hpp>

namespace planum::strat {

namespace {

using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                 boost::no_property, std::uint32_t, std::uint32_t>;

struct RawComponents {
    std::vector<std::uint32_t> of_node;
    std::uint32_t count = 0;
};

RawComponents strong_components(std::size_t node_count, std::span<const Order> orders) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(orders.size());
    for (const Order& order : orders) edges.emplace_back(order.later, order.earlier);
    const Graph graph(boost::edges_are_sorted, edges.begin(), edges.end(), static_cast<std::uint32_t>(node_count));
    RawComponents raw;
    raw.of_node.resize(node_count);
    if (node_count == 0) return raw;
    const auto index = boost::get(boost::vertex_index, graph);
    raw.count = boost::strong_components(graph, boost::make_iterator_property_map(raw.of_node.begin(), index));
    return raw;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

// Distinct pairs between different components, sorted.
std::vector<Pair> component_pairs(std::span<const Order> orders, const std::vector<std::uint32_t>& component_of) {
    std::vector<Pair> pairs;
    pairs.reserve(orders.size());
    for (const Order& order : orders) {
        const Pair pair{component_of[order.later], component_of[order.earlier]};
        if (pair.first != pair.second) pairs.push_back(pair);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

Adjacency adjacency_of(std::size_t rows, const std::vector<Pair>& pairs) {
    return Adjacency::make(
        rows, pairs.size(), [&](std::size_t i) { return pairs[i].first; },
        [&](std::size_t i) { return pairs[i].second; });
}

// Kahn 1962; the queue by smallest node makes the numbering independent of the input's order.
std::vector<std::uint32_t> topological_places(const Adjacency& below, const std::vector<std::uint32_t>& smallest_node) {
    std::vector<std::uint32_t> waiting(below.rows(), 0);
    for (const std::uint32_t target : below.values) ++waiting[target];
    using Entry = std::pair<std::uint32_t, std::uint32_t>; // smallest node, component
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> free;
    for (std::uint32_t c = 0; c < below.rows(); ++c) {
        if (waiting[c] == 0) free.emplace(smallest_node[c], c);
    }
    std::vector<std::uint32_t> place(below.rows(), 0);
    std::uint32_t next = 0;
    while (!free.empty()) {
        const std::uint32_t c = free.top().second;
        free.pop();
        place[c] = next++;
        for (const std::uint32_t target : below.row(c)) {
            if (--waiting[target] == 0) free.emplace(smallest_node[target], target);
        }
    }
    return place;
}

void rank_components(Condensation& c) {
    c.rank.assign(c.below.rows(), 0);
    for (std::uint32_t from = 0; from < c.below.rows(); ++from) {
        for (const std::uint32_t to : c.below.row(from)) c.rank[to] = std::max(c.rank[to], c.rank[from] + 1);
        c.depth = std::max(c.depth, c.rank[from] + 1);
    }
}

} // namespace

Condensation condense(std::size_t node_count, std::span<const Order> orders) {
    const RawComponents raw = strong_components(node_count, orders);
    std::vector<std::uint32_t> smallest(raw.count, kNoNode);
    for (std::uint32_t node = 0; node < node_count; ++node) {
        std::uint32_t& s = smallest[raw.of_node[node]];
        s = std::min(s, node);
    }
    const Adjacency raw_below = adjacency_of(raw.count, component_pairs(orders, raw.of_node));
    const std::vector<std::uint32_t> place = topological_places(raw_below, smallest);

    Condensation c;
    c.component_of.resize(node_count);
    for (std::size_t node = 0; node < node_count; ++node) c.component_of[node] = place[raw.of_node[node]];
    c.members = Adjacency::make(
        raw.count, node_count, [&](std::size_t node) { return c.component_of[node]; },
        [](std::size_t node) { return node; });
    c.below = adjacency_of(raw.count, component_pairs(orders, c.component_of));
    rank_components(c);
    return c;
}

std::vector<bool> redundant_pairs(const Adjacency& below) {
    constexpr std::size_t kWords = 16; // a block of 1,024 targets: 128 bytes a row stay in the cache
    constexpr std::size_t kBits = 64 * kWords;
    using Row = std::array<std::uint64_t, kWords>;
    const std::size_t count = below.rows();
    std::vector<bool> redundant(below.values.size(), false);
    std::vector<Row> reach(count);
    for (std::size_t first = 0; first < count; first += kBits) {
        const std::size_t end = std::min(first + kBits, count);
        // Only components numbered before the block's end can lie above something in it.
        for (std::size_t i = end; i-- > 0;) {
            Row beyond{}; // what the components directly below reach: implied by a longer path
            const std::uint32_t row_begin = below.begin[i];
            const std::uint32_t row_end = below.begin[i + 1];
            for (std::uint32_t at = row_begin; at < row_end; ++at) {
                const std::uint32_t target = below.values[at];
                if (target >= end) break; // ascending
                const Row& theirs = reach[target];
                for (std::size_t w = 0; w < kWords; ++w) beyond[w] |= theirs[w];
            }
            Row& mine = reach[i];
            mine = beyond;
            for (std::uint32_t at = row_begin; at < row_end; ++at) {
                const std::uint32_t target = below.values[at];
                if (target < first) continue;
                if (target >= end) break;
                const std::size_t bit = target - first;
                if (((beyond[bit / 64] >> (bit % 64)) & 1U) != 0) redundant[at] = true;
                mine[bit / 64] |= std::uint64_t{1} << (bit % 64);
            }
        }
    }
    return redundant;
}

} // namespace planum::strat
