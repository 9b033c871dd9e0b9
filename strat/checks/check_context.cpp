// SPDX-License-Identifier: MIT
#include "strat/checks/check_context.hpp"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

namespace planum::strat {

namespace {

// Statements come grouped in the order of relations; a record built by hand may break that, and is then
// looked up. Counts sides and remembers where each relation's statements begin.
void count_statements(CheckContext& c) {
    const auto& relations = c.record.relations;
    const auto& statements = c.record.statements;
    c.stated.assign(relations.size(), {});
    c.statement_begin.assign(relations.size() + 1, 0);
    std::unordered_map<model::RelationId, std::uint32_t> places;
    std::size_t at = 0;
    std::size_t filled = 0; // statement_begin is set up to here
    for (std::size_t s = 0; s < statements.size(); ++s) {
        while (at < relations.size() && relations[at].id != statements[s].relation) ++at;
        std::size_t relation = at;
        if (at == relations.size()) {
            if (places.empty()) {
                for (std::size_t i = 0; i < relations.size(); ++i) {
                    places.emplace(relations[i].id, static_cast<std::uint32_t>(i));
                }
            }
            const auto it = places.find(statements[s].relation);
            if (it == places.end()) continue;
            relation = it->second;
        } else {
            while (filled <= relation) c.statement_begin[filled++] = static_cast<std::uint32_t>(s);
        }
        StatedSides& sides = c.stated[relation];
        switch (statements[s].side) {
        case model::StatementSide::Subject: ++sides.subject; break;
        case model::StatementSide::Object: ++sides.object; break;
        case model::StatementSide::Neither: ++sides.neither; break;
        }
    }
    while (filled <= relations.size()) c.statement_begin[filled++] = static_cast<std::uint32_t>(statements.size());
}

void place_relations(CheckContext& c) {
    const auto& relations = c.record.relations;
    c.subject.resize(relations.size());
    c.object.resize(relations.size());
    c.relation_begin.assign(c.record.units.size() + 1, 0);
    const auto each_end = [&](std::size_t r, auto&& use) {
        if (c.subject[r] != model::kNoUnit) use(c.subject[r]);
        if (c.object[r] != model::kNoUnit && c.object[r] != c.subject[r]) use(c.object[r]);
    };
    for (std::size_t r = 0; r < relations.size(); ++r) {
        c.subject[r] = c.index.find(relations[r].subject);
        c.object[r] = c.index.find(relations[r].object);
        each_end(r, [&](UnitIndex u) { ++c.relation_begin[u + 1]; });
    }
    for (std::size_t u = 0; u < c.record.units.size(); ++u) c.relation_begin[u + 1] += c.relation_begin[u];
    c.relations_by_unit.resize(c.relation_begin.back());
    std::vector<std::uint32_t> next(c.relation_begin.begin(), c.relation_begin.end() - 1);
    for (std::size_t r = 0; r < relations.size(); ++r) {
        each_end(r, [&](UnitIndex u) { c.relations_by_unit[next[u]++] = static_cast<RelationIndex>(r); });
    }
}

void widen(std::optional<double>& highest, std::optional<double>& lowest, double z) {
    highest = highest ? std::max(*highest, z) : z;
    lowest = lowest ? std::min(*lowest, z) : z;
}

void place_levels(CheckContext& c) {
    const auto& levels = c.record.levels;
    const std::size_t units = c.record.units.size();
    std::vector<UnitIndex> unit_of(levels.size());
    c.level_begin.assign(units + 1, 0);
    c.heights.assign(units, {});
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const UnitIndex u = c.index.find(levels[i].unit);
        unit_of[i] = u;
        if (u == model::kNoUnit) continue;
        ++c.level_begin[u + 1];
        Heights& h = c.heights[u];
        switch (levels[i].role) {
        case model::LevelRole::Top: widen(h.highest_top, h.lowest_top, levels[i].z); break;
        case model::LevelRole::Base:
        case model::LevelRole::Cut: widen(h.highest_base, h.lowest_base, levels[i].z); break;
        case model::LevelRole::Other: break;
        }
    }
    for (std::size_t u = 0; u < units; ++u) c.level_begin[u + 1] += c.level_begin[u];
    c.levels_by_unit.resize(c.level_begin.back());
    std::vector<std::uint32_t> next(c.level_begin.begin(), c.level_begin.end() - 1);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (unit_of[i] != model::kNoUnit) c.levels_by_unit[next[unit_of[i]]++] = static_cast<std::uint32_t>(i);
    }
    // Heights are written in whole centimetres, so a difference of exactly the tolerance occurs and counts; the
    // half millimetre is for decimal fractions that binary numbers only come near.
    constexpr double kRounding = 0.0005;
    for (Heights& h : c.heights) {
        h.contradictory =
            h.lowest_base && h.highest_top && *h.lowest_base > *h.highest_top + c.record.settings.tolerance - kRounding;
    }
}

} // namespace

CheckContext::CheckContext(const model::Record& r, const HarrisMatrix& m, const CheckOptions& o,
                           std::span<const model::SurfaceEvidence> s, Progress& p)
    : record(r), matrix(m), options(o), surfaces(s), progress(p), index(r) {
    for (const model::Area& area : record.areas) area_names.emplace(area.id, area.name);
    place_relations(*this);
    count_statements(*this);
    place_levels(*this);
}

bool CheckContext::is_void(UnitIndex u) const noexcept {
    return record.units[u].kind == model::UnitKind::Void || record.units[u].status == model::UnitStatus::Void;
}

bool CheckContext::is_mentioned(UnitIndex u) const noexcept {
    return record.units[u].origin == model::UnitOrigin::Mentioned;
}

bool CheckContext::states_order(RelationIndex r) const noexcept {
    return known(r) && model::time_meaning(record.relations[r].kind) == model::TimeMeaning::SubjectLater;
}

std::span<const RelationIndex> CheckContext::relations_of(UnitIndex u) const noexcept {
    return std::span(relations_by_unit).subspan(relation_begin[u], relation_begin[u + 1] - relation_begin[u]);
}

std::span<const std::uint32_t> CheckContext::levels_of(UnitIndex u) const noexcept {
    return std::span(levels_by_unit).subspan(level_begin[u], level_begin[u + 1] - level_begin[u]);
}

std::string CheckContext::full_name(UnitIndex u) const {
    const model::StratigraphicUnit& unit = record.units[u];
    const auto it = area_names.find(unit.area);
    return it == area_names.end() ? unit.number : fmt::format("{}::{}", it->second, unit.number);
}

std::string CheckContext::sentence(RelationIndex r) const {
    const auto end = [&](UnitIndex u) { return u == model::kNoUnit ? std::string{"?"} : name(u); };
    return fmt::format("{} {} {}", end(subject[r]), model::phrase(record.relations[r].kind), end(object[r]));
}

model::NamedRelation CheckContext::named(RelationIndex r) const {
    const model::PhysicalRelation& relation = record.relations[r];
    return {relation.id, relation.subject, relation.kind, relation.object};
}

RelationIndex CheckContext::relation_between(UnitIndex later, UnitIndex earlier) const {
    for (const RelationIndex r : relations_of(later)) {
        if (subject[r] == later && object[r] == earlier && states_order(r)) return r;
    }
    return kNoRelation;
}

model::Diagnostic make_diagnostic(model::Severity severity, std::string_view code, std::string message) {
    model::Diagnostic d;
    d.severity = severity;
    d.code = code;
    d.message = std::move(message);
    return d;
}

std::string metres(double value) { return fmt::format("{:.2f} m", value); }

std::string year_text(model::Year year) { return year < 0 ? fmt::format("{} BCE", -year) : fmt::format("{} CE", year); }

std::string list_names(const std::vector<std::string>& names, std::size_t limit) {
    std::string text;
    const std::size_t shown = names.size() <= limit ? names.size() : limit;
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += names[i];
    }
    if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
    return text;
}

std::string path_text(const CheckContext& context, std::span<const std::uint32_t> orders, std::size_t limit,
                      PathEnds ends) {
    std::vector<std::string> steps;
    UnitIndex before = ends.later; // where the last step ended; the next may begin at its same_as
    for (const std::uint32_t order : orders) {
        const auto because = context.matrix.because(order);
        if (because.empty()) continue;
        const UnitIndex from = context.subject[because.front()];
        std::string step;
        if (before != model::kNoUnit && before != from) {
            step = fmt::format("{} is the same as {}, ", context.name(before), context.name(from));
        }
        steps.push_back(step + context.sentence(because.front()));
        before = context.object[because.front()];
    }
    if (!steps.empty() && ends.earlier != model::kNoUnit && before != ends.earlier) {
        steps.back() += fmt::format(", {} is the same as {}", context.name(before), context.name(ends.earlier));
    }
    std::string text;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i == limit && steps.size() > limit + 1) {
            return text + fmt::format(" and {} steps more", steps.size() - limit);
        }
        if (i > 0) text += ", ";
        text += steps[i];
    }
    return text;
}

std::vector<model::NamedRelation> path_relations(const CheckContext& context, std::span<const std::uint32_t> orders) {
    std::vector<model::NamedRelation> relations;
    for (const std::uint32_t order : orders) {
        const auto because = context.matrix.because(order);
        if (!because.empty()) relations.push_back(context.named(because.front()));
    }
    return relations;
}

} // namespace planum::strat
