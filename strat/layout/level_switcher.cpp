// SPDX-License-Identifier: MIT
#include "strat/layout/level_switcher.hpp"

namespace planum::strat {

LevelSwitcher::LevelSwitcher(LayeredGraph& graph)
    : g_(graph), up_(neighbours_above(graph)), down_(neighbours_below(graph)), place_(graph.nodes, 0) {
    for (std::size_t level = 0; level < g_.layers.size(); ++level) number(level);
}

void LevelSwitcher::draw_near(std::size_t level, std::uint32_t node, std::uint32_t target) {
    std::vector<std::uint32_t>& layer = g_.layers[level];
    const auto from = static_cast<std::ptrdiff_t>(place_[node]);
    const std::ptrdiff_t step = place_[target] < place_[node] ? -1 : 1;
    std::int64_t more = 0;
    std::ptrdiff_t to = from;
    for (std::ptrdiff_t at = from + step; layer[static_cast<std::size_t>(at)] != target; at += step) {
        const std::uint32_t passed = layer[static_cast<std::size_t>(at)];
        more += step > 0 ? crossings(passed, node) - crossings(node, passed)
                         : crossings(node, passed) - crossings(passed, node);
        if (more <= 0) to = at;
    }
    layer.erase(layer.begin() + from);
    layer.insert(layer.begin() + to, node);
    number(level);
}

void LevelSwitcher::number(std::size_t level) {
    for (std::size_t i = 0; i < g_.layers[level].size(); ++i)
        place_[g_.layers[level][i]] = static_cast<std::uint32_t>(i);
}

// Of the edges of two nodes of a level, `left` standing left of `right`.
std::int64_t LevelSwitcher::crossings(std::uint32_t left, std::uint32_t right) const {
    std::int64_t count = 0;
    for (const Adjacency* side : {&up_, &down_}) {
        for (const std::uint32_t a : side->row(left)) {
            for (const std::uint32_t b : side->row(right)) count += place_[a] > place_[b] ? 1 : 0;
        }
    }
    return count;
}

void draw_together(LayeredGraph& graph, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    std::vector<std::size_t> level(graph.nodes, 0);
    for (std::size_t l = 0; l < graph.layers.size(); ++l) {
        for (const std::uint32_t node : graph.layers[l]) level[node] = l;
    }
    std::vector<bool> joined(graph.nodes, false);
    for (const auto& [upper, lower] : graph.edges) joined[upper] = joined[lower] = true;
    LevelSwitcher switcher(graph);
    for (const auto& [a, b] : pairs) {
        if (level[a] != level[b] || (joined[a] && joined[b])) continue;
        switcher.draw_near(level[a], joined[b] ? a : b, joined[b] ? b : a);
        joined[a] = joined[b] = true; // has its place now
    }
}

} // namespace planum::strat
