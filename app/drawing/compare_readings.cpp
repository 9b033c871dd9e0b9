// SPDX-License-Identifier: MIT
#include "app/drawing/compare_readings.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

namespace {

using Pair = std::pair<model::UnitId, model::UnitId>;
using Words = std::set<std::pair<model::RelationKind, model::Certainty>>;

std::map<Pair, Words> relations_by_pair(const model::Record& record) {
    std::map<Pair, Words> by_pair;
    for (const model::PhysicalRelation& r : record.relations) {
        by_pair[{r.subject, r.object}].insert({r.kind, r.certainty});
    }
    return by_pair;
}

std::unordered_set<model::UnitId> units_of(const model::Record& record) {
    std::unordered_set<model::UnitId> units;
    for (const model::StratigraphicUnit& unit : record.units) units.insert(unit.id);
    return units;
}

} // namespace

Comparison compare_readings(const model::Record& before, const model::Record& after) {
    Comparison result;
    result.both = after;
    std::map<model::UnitId, strat::Mark> marks;
    const std::unordered_set<model::UnitId> units_before = units_of(before);
    const std::unordered_set<model::UnitId> units_after = units_of(after);
    for (const model::StratigraphicUnit& unit : after.units) {
        if (!units_before.contains(unit.id)) marks[unit.id] = strat::Mark::Added;
    }
    for (const model::StratigraphicUnit& unit : before.units) {
        if (units_after.contains(unit.id)) continue;
        marks[unit.id] = strat::Mark::Removed;
        result.both.units.push_back(unit);
    }
    const std::map<Pair, Words> pairs_before = relations_by_pair(before);
    const std::map<Pair, Words> pairs_after = relations_by_pair(after);
    const auto mark = [&](const Pair& pair, strat::Mark how) {
        result.orders.push_back({pair.first, pair.second, how});
        marks.try_emplace(pair.first, strat::Mark::Changed);
        marks.try_emplace(pair.second, strat::Mark::Changed);
    };
    for (const auto& [pair, words] : pairs_after) {
        const auto old = pairs_before.find(pair);
        if (old == pairs_before.end()) mark(pair, strat::Mark::Added);
        if (old != pairs_before.end() && old->second != words) mark(pair, strat::Mark::Changed);
    }
    for (const auto& [pair, words] : pairs_before) {
        if (!pairs_after.contains(pair)) mark(pair, strat::Mark::Removed);
    }
    for (const model::PhysicalRelation& r : before.relations) {
        if (!pairs_after.contains({r.subject, r.object})) result.both.relations.push_back(r);
    }
    model::sort_record(result.both);
    for (const auto& [unit, how] : marks) result.units.push_back({unit, how});
    return result;
}

void keep_cycles_of(const model::Record& after, strat::MatrixDrawing& drawing) {
    const auto matrix = strat::HarrisMatrix::build(after);
    std::unordered_map<model::UnitId, std::uint32_t> group; // of units in cycles: their component
    for (const std::uint32_t component : matrix.cycle_groups()) {
        for (const strat::NodeIndex node : matrix.component(component)) {
            for (const strat::UnitIndex unit : matrix.members(node)) group.emplace(after.units[unit].id, component);
        }
    }
    const auto group_of = [&](const strat::DrawnBox& box) -> std::int64_t {
        for (const model::UnitId unit : box.units) {
            const auto it = group.find(unit);
            if (it != group.end()) return it->second;
        }
        return -1;
    };
    for (strat::DrawnBox& box : drawing.boxes) box.in_cycle = box.in_cycle && group_of(box) >= 0;
    for (strat::DrawnLine& line : drawing.lines) {
        const std::int64_t later = group_of(drawing.boxes[line.later]);
        line.in_cycle = line.in_cycle && line.mark != strat::Mark::Removed && later >= 0 &&
                        later == group_of(drawing.boxes[line.earlier]);
    }
}

} // namespace planum::app
