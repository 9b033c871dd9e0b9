// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "strat/exchange/imported_record.hpp"

namespace planum::test {

/// The columns of the table of real matrices, in its order ("to remove" left out).
struct MatrixCounts {
    int units = 0;
    int orders = 0;
    int same_as = 0;
    int contemporary = 0;
    int self = 0;
    int mutual = 0;
    int merged = 0;
    int cycle_groups = 0;
    int largest = 0;
    int inside = 0;
    int redundant = 0;
    int of = 0;
    int depth = 0;
    int isolated = 0;
    int within_merged = 0; ///< orders between units that same_as makes one

    friend bool operator==(const MatrixCounts&, const MatrixCounts&) = default;
};

/// Counts a record by Warshall's closure: too slow to ship and too simple to be wrong. Units only named in
/// relations count as units. Isolated are merged units in no order.
inline MatrixCounts count_matrix(const strat::ImportedRecord& record) {
    std::map<strat::UnitName, int> index;
    const auto at = [&](const strat::UnitName& name) {
        return index.try_emplace(name, static_cast<int>(index.size())).first->second;
    };
    for (const auto& unit : record.units) at(unit.name);
    std::set<std::pair<int, int>> orders;
    std::set<std::pair<int, int>> same;
    std::set<std::pair<int, int>> contemporary;
    std::set<int> self;
    for (const auto& relation : record.relations) {
        const int a = at(relation.subject);
        const int b = at(relation.object);
        switch (model::time_meaning(relation.kind)) {
        case model::TimeMeaning::SubjectLater:
            if (a == b) self.insert(a);
            if (a != b) orders.emplace(a, b);
            break;
        case model::TimeMeaning::SameUnit: same.emplace(std::minmax(a, b)); break;
        case model::TimeMeaning::SameTime: contemporary.emplace(std::minmax(a, b)); break;
        case model::TimeMeaning::None: break;
        }
    }
    MatrixCounts out;
    const int n = static_cast<int>(index.size());
    out.units = n;
    out.orders = static_cast<int>(orders.size());
    out.same_as = static_cast<int>(same.size());
    out.contemporary = static_cast<int>(contemporary.size());
    out.self = static_cast<int>(self.size());
    for (const auto& [a, b] : orders) out.mutual += a < b && orders.contains({b, a}) ? 1 : 0;

    std::vector<int> node(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) node[static_cast<std::size_t>(i)] = i;
    const auto of = [&](int i) { return node[static_cast<std::size_t>(i)]; };
    for (const auto& [a, b] : same) {
        const int from = of(a);
        const int to = of(b);
        if (from == to) continue;
        ++out.merged;
        std::replace(node.begin(), node.end(), from, to);
    }

    using Matrix = std::vector<std::vector<char>>;
    const auto size = static_cast<std::size_t>(n);
    Matrix reach(size, std::vector<char>(size, 0));
    std::set<std::pair<int, int>> merged;
    for (const auto& [a, b] : orders) {
        if (of(a) != of(b)) merged.emplace(of(a), of(b));
        if (of(a) == of(b)) ++out.within_merged;
    }
    for (const auto& [a, b] : merged) reach[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = 1;
    for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t i = 0; i < size; ++i) {
            if (reach[i][k] == 0) continue;
            for (std::size_t j = 0; j < size; ++j) reach[i][j] |= reach[k][j];
        }
    }
    const auto reaches = [&](int a, int b) {
        return reach[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] != 0;
    };

    // A cycle group is named by its smallest node.
    std::map<int, int> group;
    std::map<int, int> sizes;
    const std::set<int> nodes(node.begin(), node.end());
    for (const int a : nodes) {
        group[a] = a;
        for (const int b : nodes) {
            if (b < group[a] && reaches(a, b) && reaches(b, a)) group[a] = b;
        }
        ++sizes[group[a]];
    }
    for (const auto& [name, members] : sizes) {
        out.cycle_groups += members > 1 ? 1 : 0;
        if (members > 1) out.largest = std::max(out.largest, members);
    }
    std::set<std::pair<int, int>> condensed;
    std::set<int> in_orders;
    for (const auto& [a, b] : merged) {
        in_orders.insert({a, b});
        if (group[a] == group[b]) ++out.inside;
        if (group[a] != group[b]) condensed.emplace(group[a], group[b]);
    }
    out.of = static_cast<int>(condensed.size());
    for (const auto& [a, b] : condensed) {
        const bool implied = std::any_of(condensed.begin(), condensed.end(), [&](const auto& first) {
            return first.first == a && first.second != b && reaches(first.second, b);
        });
        out.redundant += implied ? 1 : 0;
    }
    std::map<int, int> depth;
    const std::function<int(int)> longest = [&](int a) {
        if (const auto known = depth.find(a); known != depth.end()) return known->second;
        int below = 0;
        for (auto it = condensed.lower_bound({a, 0}); it != condensed.end() && it->first == a; ++it) {
            below = std::max(below, longest(it->second));
        }
        return depth[a] = below + 1;
    };
    for (const auto& [a, representative] : group) out.depth = std::max(out.depth, longest(representative));
    out.isolated = static_cast<int>(nodes.size() - in_orders.size());
    return out;
}

} // namespace planum::test
