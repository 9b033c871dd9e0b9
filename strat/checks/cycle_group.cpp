// SPDX-License-Identifier: MIT
#include "strat/checks/cycle_group.hpp"

#include <algorithm>

#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

namespace {

// Nothing is quite free to doubt.
constexpr double kLeastWeight = 0.2;

} // namespace

CycleGroup::CycleGroup(const CheckContext& context, const RelationWeights& weights, std::span<const NodeIndex> members)
    : nodes(members.begin(), members.end()) {
    const HarrisMatrix& m = context.matrix;
    std::sort(nodes.begin(), nodes.end());
    std::vector<double> odds;
    std::vector<double> relations_behind;
    double least = kLeastWeight;
    for (std::uint32_t v = 0; v < nodes.size(); ++v) {
        for (const std::uint32_t order : m.orders_below(nodes[v])) {
            const NodeIndex earlier = m.orders()[order].earlier;
            if (m.component_of(earlier) != m.component_of(nodes[v])) continue;
            arcs.push_back({v, local(earlier), 0.0});
            orders.push_back(order);
            double sum = 0.0;
            for (const RelationIndex r : m.because(order)) {
                const double one = weights.log_odds(r);
                sum += one;
                least = std::min(least, one);
            }
            odds.push_back(sum);
            relations_behind.push_back(static_cast<double>(m.because(order).size()));
        }
    }
    shift = kLeastWeight - least;
    for (std::size_t i = 0; i < arcs.size(); ++i) arcs[i].weight = odds[i] + relations_behind[i] * shift;
}

std::uint32_t CycleGroup::local(NodeIndex node) const noexcept {
    return static_cast<std::uint32_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
}

std::vector<std::uint32_t> shortest_cycle_through(const CycleGroup& group, std::uint32_t arc) {
    constexpr std::uint32_t kUnseen = static_cast<std::uint32_t>(-1);
    const Adjacency out = Adjacency::make(
        group.nodes.size(), group.arcs.size(), [&](std::size_t i) { return group.arcs[i].from; },
        [](std::size_t i) { return i; });
    std::vector<std::uint32_t> came_by(group.nodes.size(), kUnseen);
    const std::uint32_t start = group.arcs[arc].to;
    const std::uint32_t goal = group.arcs[arc].from;
    std::vector<std::uint32_t> queue = {start};
    for (std::size_t at = 0; at < queue.size() && came_by[goal] == kUnseen; ++at) {
        for (const std::uint32_t next : out.row(queue[at])) {
            const std::uint32_t to = group.arcs[next].to;
            if (to == start || came_by[to] != kUnseen) continue;
            came_by[to] = next;
            queue.push_back(to);
        }
    }
    std::vector<std::uint32_t> cycle;
    for (std::uint32_t v = goal; v != start && came_by[v] != kUnseen; v = group.arcs[came_by[v]].from) {
        cycle.push_back(came_by[v]);
    }
    cycle.push_back(arc);
    std::reverse(cycle.begin(), cycle.end());
    return cycle;
}

} // namespace planum::strat
