// SPDX-License-Identifier: MIT
#include "strat/checks/incremental.hpp"

#include <algorithm>
#include <utility>

namespace planum::strat {

namespace {

constexpr std::uint32_t kUnseen = static_cast<std::uint32_t>(-1);

// Breadth first from `later` down to `earlier`; flat tables, because a person waits for the answer.
std::vector<std::uint32_t> path_down(const HarrisMatrix& m, NodeIndex later, NodeIndex earlier) {
    const std::uint32_t last = m.component_of(earlier);
    if (later == earlier || m.component_of(later) > last) return {}; // components are numbered from the top
    std::vector<std::uint32_t> came_by(m.node_count(), kUnseen);
    std::vector<NodeIndex> queue = {later};
    for (std::size_t at = 0; at < queue.size() && came_by[earlier] == kUnseen; ++at) {
        for (const std::uint32_t order : m.orders_below(queue[at])) {
            const NodeIndex next = m.orders()[order].earlier;
            if (next == later || came_by[next] != kUnseen || m.component_of(next) > last) continue;
            came_by[next] = order;
            queue.push_back(next);
        }
    }
    std::vector<std::uint32_t> path;
    if (came_by[earlier] == kUnseen) return path;
    for (NodeIndex node = earlier; node != later; node = m.orders()[came_by[node]].later) path.push_back(came_by[node]);
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace

Prediction predict(const HarrisMatrix& matrix, const NewRelation& relation) {
    const NodeIndex subject = matrix.node_of(relation.subject);
    const NodeIndex object = matrix.node_of(relation.object);
    switch (model::time_meaning(relation.kind)) {
    case model::TimeMeaning::None: return {};
    case model::TimeMeaning::SubjectLater: {
        if (subject == object) return {Consequence::SelfRelation, {}};
        auto path = path_down(matrix, object, subject);
        if (path.empty()) return {};
        return {Consequence::ClosesCycle, std::move(path)};
    }
    case model::TimeMeaning::SameUnit:
    case model::TimeMeaning::SameTime: {
        auto path = path_down(matrix, subject, object);
        if (path.empty()) path = path_down(matrix, object, subject);
        if (path.empty()) return {};
        const bool same = model::time_meaning(relation.kind) == model::TimeMeaning::SameUnit;
        return {same ? Consequence::OrdersSame : Consequence::OrdersTogether, std::move(path)};
    }
    }
    return {};
}

} // namespace planum::strat
