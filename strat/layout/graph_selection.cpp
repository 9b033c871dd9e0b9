// SPDX-License-Identifier: MIT
#include "strat/layout/graph_selection.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "core/base/error.hpp"
#include "strat/matrix/condensation.hpp"

namespace planum::strat {

namespace {

constexpr std::uint32_t kLeftOut = Selection::kLeftOut;

template<class Values>
auto positions_by_id(const Values& values) {
    std::unordered_map<decltype(values.front().id), std::int32_t> place;
    for (std::size_t i = 0; i < values.size(); ++i) place.emplace(values[i].id, static_cast<std::int32_t>(i));
    return place;
}

template<class Map, class Key>
std::int32_t look_up(const Map& map, const Key& key) {
    const auto it = map.find(key);
    return it == map.end() ? -1 : it->second;
}

std::vector<bool> nodes_of_area(const LayoutRequest& request) {
    const model::Record& record = request.record;
    const auto area = std::find_if(record.areas.begin(), record.areas.end(),
                                   [&](const model::Area& a) { return a.name == request.options.area; });
    if (area == record.areas.end()) throw Error(ErrorCode::NotFound, "no area " + request.options.area);
    std::vector<bool> keep(request.matrix.node_count(), false);
    for (std::size_t u = 0; u < record.units.size(); ++u) {
        if (record.units[u].area == area->id) keep[request.matrix.node_of(static_cast<UnitIndex>(u))] = true;
    }
    return keep;
}

std::vector<bool> nodes_of_units(const LayoutRequest& request) {
    const std::unordered_set<model::UnitId> wanted(request.options.only.begin(), request.options.only.end());
    std::vector<bool> keep(request.matrix.node_count(), false);
    for (std::size_t u = 0; u < request.record.units.size(); ++u) {
        if (wanted.contains(request.record.units[u].id)) keep[request.matrix.node_of(static_cast<UnitIndex>(u))] = true;
    }
    return keep;
}

// Steps count along reduced orders, upwards and downwards alike, and to what is contemporary.
std::vector<bool> nodes_around(const LayoutRequest& request) {
    const HarrisMatrix& matrix = request.matrix;
    const UnitIndex unit = model::RecordIndex(request.record).find(request.options.around);
    if (unit == model::kNoUnit) {
        throw Error(ErrorCode::NotFound, "no unit with the id " + request.options.around.to_string());
    }
    std::vector<std::vector<NodeIndex>> beside(matrix.node_count());
    for (const std::uint32_t i : matrix.reduced()) {
        const Order& order = matrix.orders()[i];
        beside[order.later].push_back(order.earlier);
        beside[order.earlier].push_back(order.later);
    }
    for (const Order& pair : matrix.contemporaries()) {
        beside[pair.later].push_back(pair.earlier);
        beside[pair.earlier].push_back(pair.later);
    }
    std::vector<bool> keep(matrix.node_count(), false);
    std::vector<NodeIndex> open = {matrix.node_of(unit)};
    keep[open.front()] = true;
    for (int step = 0; step < request.options.around_steps; ++step) {
        std::vector<NodeIndex> next;
        for (const NodeIndex node : open) {
            for (const NodeIndex other : beside[node]) {
                if (keep[other]) continue;
                keep[other] = true;
                next.push_back(other);
            }
        }
        open = std::move(next);
    }
    return keep;
}

// Pairs of boxes with a path whose nodes in between are all left out.
std::vector<Selection::Pair> pairs_of_boxes(const HarrisMatrix& matrix, const std::vector<std::uint32_t>& box_of) {
    std::vector<std::vector<NodeIndex>> below(matrix.node_count());
    for (const std::uint32_t i : matrix.reduced()) {
        below[matrix.orders()[i].later].push_back(matrix.orders()[i].earlier);
    }
    std::vector<Selection::Pair> pairs;
    std::vector<NodeIndex> seen_from(matrix.node_count(), kNoNode);
    std::vector<NodeIndex> open;
    for (NodeIndex node = 0; node < matrix.node_count(); ++node) {
        if (box_of[node] == kLeftOut) continue;
        for (const NodeIndex next : below[node]) {
            if (box_of[next] != kLeftOut) {
                pairs.push_back({box_of[node], box_of[next], false, false});
            } else {
                open.push_back(next);
            }
        }
        while (!open.empty()) {
            const NodeIndex at = open.back();
            open.pop_back();
            if (seen_from[at] == node) continue;
            seen_from[at] = node;
            for (const NodeIndex next : below[at]) {
                if (box_of[next] == kLeftOut) {
                    open.push_back(next);
                } else {
                    pairs.push_back({box_of[node], box_of[next], false, true});
                }
            }
        }
    }
    return pairs;
}

// Distinct pairs between different boxes; a pair that is also stated directly is no `through`.
void make_distinct(std::vector<Selection::Pair>& pairs) {
    std::erase_if(pairs, [](const Selection::Pair& p) { return p.later == p.earlier; });
    const auto key = [](const Selection::Pair& p) { return std::make_tuple(p.later, p.earlier, p.through); };
    std::sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    const auto same = [](const Selection::Pair& a, const Selection::Pair& b) {
        return a.later == b.later && a.earlier == b.earlier;
    };
    pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
}

// Harris's fourth law once more, for the boxes: the matrix's own reduction does not know what was folded
// or left out.
void reduce_pairs(std::vector<Selection::Pair>& pairs, std::uint32_t box_count) {
    std::vector<Order> orders;
    orders.reserve(pairs.size());
    for (const Selection::Pair& p : pairs) orders.push_back({p.later, p.earlier});
    const Condensation condensation = condense(box_count, orders);
    const std::vector<bool> redundant = redundant_pairs(condensation.below);
    std::erase_if(pairs, [&](Selection::Pair& p) {
        const std::uint32_t from = condensation.component_of[p.later];
        const std::uint32_t to = condensation.component_of[p.earlier];
        p.in_cycle = from == to;
        if (p.in_cycle) return false;
        const auto row = condensation.below.row(from);
        const auto at = std::lower_bound(row.begin(), row.end(), to) - row.begin();
        return bool(redundant[condensation.below.begin[from] + static_cast<std::uint32_t>(at)]);
    });
}

// Numbers the boxes in natural order of their first nodes.
void number_boxes(const LayoutRequest& request, const std::vector<bool>& keep, Selection& selection) {
    const HarrisMatrix& matrix = request.matrix;
    const std::vector<std::int32_t> keys = fold_keys(request.record, request.options.fold);
    selection.box_of.assign(matrix.node_count(), kLeftOut);
    std::unordered_map<std::int32_t, std::uint32_t> box_of_key;
    for (NodeIndex node = 0; node < matrix.node_count(); ++node) {
        if (!keep[node]) continue;
        const std::int32_t key = keys[matrix.members(node).front()];
        if (key >= 0) {
            const auto known = box_of_key.find(key);
            if (known != box_of_key.end()) {
                selection.box_of[node] = known->second;
                continue;
            }
            box_of_key.emplace(key, selection.box_count);
        }
        selection.folded.push_back(key);
        selection.box_of[node] = selection.box_count++;
    }
}

} // namespace

std::vector<std::int32_t> fold_keys(const model::Record& record, Fold fold) {
    std::vector<std::int32_t> keys(record.units.size(), -1);
    const auto phases = positions_by_id(record.phases);
    const auto periods = positions_by_id(record.periods);
    const auto groups = positions_by_id(record.groups);
    std::unordered_map<model::UnitId, std::int32_t> group_of;
    for (std::size_t g = 0; g < record.groups.size(); ++g) {
        auto top = static_cast<std::int32_t>(g);
        // Parents may be damaged into a ring; more steps than groups are none.
        for (std::size_t step = 0; step < record.groups.size(); ++step) {
            const std::int32_t parent = look_up(groups, record.groups[static_cast<std::size_t>(top)].parent);
            if (parent < 0) break;
            top = parent;
        }
        for (const model::UnitId unit : record.groups[g].members) group_of.emplace(unit, top);
    }
    for (std::size_t u = 0; u < record.units.size(); ++u) {
        const model::StratigraphicUnit& unit = record.units[u];
        const std::int32_t phase = look_up(phases, unit.phase);
        switch (fold) {
        case Fold::None: break;
        case Fold::Phases: keys[u] = phase; break;
        case Fold::Periods:
            keys[u] = look_up(periods, unit.period);
            if (keys[u] < 0 && phase >= 0) {
                keys[u] = look_up(periods, record.phases[static_cast<std::size_t>(phase)].period);
            }
            break;
        case Fold::Groups: keys[u] = look_up(group_of, unit.id); break;
        }
    }
    return keys;
}

Selection select(const LayoutRequest& request) {
    const DrawingOptions& options = request.options;
    std::vector<bool> keep(request.matrix.node_count(), true);
    const auto narrow = [&](const std::vector<bool>& choice) {
        for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = keep[i] && choice[i];
    };
    if (!options.area.empty()) narrow(nodes_of_area(request));
    if (!options.only.empty()) narrow(nodes_of_units(request));
    if (!options.around.is_nil()) narrow(nodes_around(request));

    Selection selection;
    number_boxes(request, keep, selection);
    selection.pairs = pairs_of_boxes(request.matrix, selection.box_of);
    make_distinct(selection.pairs);
    reduce_pairs(selection.pairs, selection.box_count);
    return selection;
}

} // namespace planum::strat
