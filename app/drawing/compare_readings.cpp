// SPDX-License-Identifier: MIT
#include "app/drawing/compare_readings.hpp"

#include <map>
#include <set>
#include <unordered_set>
#include <utility>

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

} // namespace planum::app
