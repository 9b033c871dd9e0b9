// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>

#include "strat/layout/network_simplex.hpp"
#include "strat/layout/order_phase.hpp"
#include "strat/layout/path_mover.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

std::vector<std::vector<std::uint32_t>> sorted(std::vector<std::vector<std::uint32_t>> layers) {
    for (auto& layer : layers) std::sort(layer.begin(), layer.end());
    return layers;
}

LayeredGraph a_layered_graph(std::uint32_t seed, std::size_t levels, std::size_t width, std::size_t edges) {
    std::mt19937 random(seed);
    LayeredGraph g;
    for (std::size_t l = 0; l < levels; ++l) {
        g.layers.emplace_back();
        for (std::size_t i = 0, n = 1 + random() % width; i < n; ++i) g.layers.back().push_back(g.nodes++);
    }
    for (std::size_t e = 0; e < edges; ++e) {
        const std::size_t l = random() % (levels - 1);
        g.edges.push_back(
            {g.layers[l][random() % g.layers[l].size()], g.layers[l + 1][random() % g.layers[l + 1].size()]});
    }
    std::sort(g.edges.begin(), g.edges.end());
    g.edges.erase(std::unique(g.edges.begin(), g.edges.end()), g.edges.end());
    return g;
}

// Pairs of edges between two levels whose ends stand in opposite orders.
std::int64_t crossings_by_definition(const LayeredGraph& g) {
    std::vector<std::size_t> place(g.nodes);
    std::vector<std::size_t> level(g.nodes);
    for (std::size_t l = 0; l < g.layers.size(); ++l) {
        for (std::size_t i = 0; i < g.layers[l].size(); ++i) {
            place[g.layers[l][i]] = i;
            level[g.layers[l][i]] = l;
        }
    }
    std::int64_t count = 0;
    for (const auto& [a, b] : g.edges) {
        for (const auto& [c, d] : g.edges) {
            if (level[a] == level[c] && place[a] < place[c] && place[b] > place[d]) ++count;
        }
    }
    return count;
}

struct Prepared {
    LayeredGraph graph;
    Adjacency up;
    Adjacency down;
    std::vector<std::uint32_t> position;
    std::vector<std::uint32_t> layer;

    explicit Prepared(LayeredGraph g) : graph(std::move(g)), position(graph.nodes), layer(graph.nodes) {
        const auto& edges = graph.edges;
        down = Adjacency::make(
            graph.nodes, edges.size(), [&](std::size_t i) { return edges[i].first; },
            [&](std::size_t i) { return edges[i].second; });
        up = Adjacency::make(
            graph.nodes, edges.size(), [&](std::size_t i) { return edges[i].second; },
            [&](std::size_t i) { return edges[i].first; });
        for (std::uint32_t l = 0; l < graph.layers.size(); ++l) {
            for (std::uint32_t i = 0; i < graph.layers[l].size(); ++i) {
                position[graph.layers[l][i]] = i;
                layer[graph.layers[l][i]] = l;
            }
        }
    }
};

} // namespace

TEST_CASE("Ordering keeps every node on its level and never makes more crossings") {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        const LayeredGraph before = a_layered_graph(seed, 2 + seed % 8, 2 + seed % 9, 10 + seed);
        LayeredGraph after = before;
        order_layers(after, {}, Progress::none());
        INFO("seed " << seed);
        CHECK(sorted(after.layers) == sorted(before.layers));
        CHECK(count_crossings(after) == crossings_by_definition(after));
        CHECK(crossings_by_definition(after) <= crossings_by_definition(before));
    }
}

TEST_CASE("Moving paths saves exactly the crossings that it says it saves") {
    std::int64_t saved = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        Prepared p(a_layered_graph(seed, 3 + seed % 9, 2 + seed % 12, 6 + seed % 40));
        const std::int64_t before = crossings_by_definition(p.graph);
        const auto nodes = sorted(p.graph.layers);
        std::int64_t work = 0;
        const std::int64_t said = PathMover(p.graph, p.up, p.down, p.position, p.layer).improve(work, 1'000'000'000);
        INFO("seed " << seed);
        REQUIRE(sorted(p.graph.layers) == nodes);
        REQUIRE(before - crossings_by_definition(p.graph) == said);
        for (const auto& layer : p.graph.layers) {
            for (std::uint32_t i = 0; i < layer.size(); ++i) REQUIRE(p.position[layer[i]] == i);
        }
        saved += said;
    }
    CHECK(saved > 0);
}

TEST_CASE("Moving the only path finds the best of all its ways") {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        // A path beside a graph whose other nodes have two neighbours above or below and stay.
        LayeredGraph g = a_layered_graph(seed, 4, 4, 0);
        std::mt19937 random(seed);
        for (std::size_t l = 0; l < 3; ++l) {
            for (const std::uint32_t a : g.layers[l]) {
                for (const std::uint32_t b : g.layers[l + 1]) {
                    if (random() % 3 != 0) g.edges.push_back({a, b});
                }
            }
        }
        std::vector<std::uint32_t> path;
        for (std::size_t l = 0; l < 4; ++l) {
            path.push_back(g.nodes++);
            g.layers[l].push_back(path.back());
            if (l > 0) g.edges.push_back({path[l - 1], path[l]});
        }
        std::sort(g.edges.begin(), g.edges.end());
        std::int64_t best = crossings_by_definition(g);
        std::vector<std::size_t> gaps(4, 0);
        while (true) { // every way there is
            LayeredGraph other = g;
            for (std::size_t l = 0; l < 4; ++l) {
                other.layers[l].pop_back();
                other.layers[l].insert(other.layers[l].begin() + static_cast<std::ptrdiff_t>(gaps[l]), path[l]);
            }
            best = std::min(best, crossings_by_definition(other));
            std::size_t l = 0;
            while (l < 4 && ++gaps[l] == g.layers[l].size()) gaps[l++] = 0;
            if (l == 4) break;
        }
        Prepared p(g);
        std::int64_t work = 0;
        static_cast<void>(PathMover(p.graph, p.up, p.down, p.position, p.layer).improve(work, 1'000'000'000));
        INFO("seed " << seed);
        CHECK(crossings_by_definition(p.graph) <= best);
    }
}

TEST_CASE("Levels by network simplex are the shortest there are") {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        const std::uint32_t nodes = 2 + seed % 4;
        std::vector<RankArc> arcs;
        for (std::uint32_t a = 0; a < nodes; ++a) {
            for (std::uint32_t b = a + 1; b < nodes; ++b) {
                if (random() % 3 == 0) continue;
                arcs.push_back(
                    {a, b, static_cast<std::int32_t>(random() % 3), static_cast<std::int32_t>(random() % 4)});
            }
        }
        const auto cost = [&](const std::vector<std::int32_t>& rank) {
            std::int64_t sum = 0;
            for (const RankArc& a : arcs) {
                const std::int64_t slack = rank[a.to] - rank[a.from] - a.length;
                if (slack < 0) return std::int64_t{1'000'000};
                sum += a.weight * slack;
            }
            return sum;
        };
        std::int64_t best = 1'000'000;
        std::vector<std::int32_t> rank(nodes, 0);
        while (true) { // all levels up to the longest path there can be
            best = std::min(best, cost(rank));
            std::size_t v = 0;
            while (v < nodes && ++rank[v] > 2 * static_cast<std::int32_t>(nodes - 1)) rank[v++] = 0;
            if (v == nodes) break;
        }
        INFO("seed " << seed);
        CHECK(cost(network_simplex(nodes, arcs, 1'000'000)) == best);
    }
}
