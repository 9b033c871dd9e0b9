// SPDX-License-Identifier: MIT
#include "app/reports/days_record.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "app/scans/days_surface.hpp"
#include "core/base/error.hpp"

namespace planum::app {

namespace {

using UnitSet = std::unordered_set<model::UnitId>;

bool in_work_on(const model::StratigraphicUnit& unit, const std::string& day) {
    if (unit.excavated_from == day || unit.excavated_on == day || unit.recorded_on == day) return true;
    return !unit.excavated_from.empty() && !unit.excavated_on.empty() && unit.excavated_from <= day &&
           day <= unit.excavated_on;
}

bool made_on(std::string_view time, std::string_view day) { return time.substr(0, day.size()) == day; }

// Every day the record speaks of, for the sentence that says where there is something.
std::set<std::string> days_of(const model::Record& record) {
    std::set<std::string> days;
    const auto add = [&](std::string_view text) {
        if (is_day(text.substr(0, 10))) days.emplace(text.substr(0, 10));
    };
    for (const model::StratigraphicUnit& unit : record.units) {
        for (const std::string* day : {&unit.excavated_from, &unit.excavated_on, &unit.recorded_on}) add(*day);
    }
    for (const model::Surface& surface : record.surfaces) add(surface.first_day);
    for (const model::Scan& scan : record.scans) add(scan.day);
    for (const model::Find& find : record.finds) add(find.found_on);
    for (const model::Document& document : record.documents) add(document.made_on);
    for (const model::RelationStatement& statement : record.statements) {
        if (statement.source.is_nil()) add(statement.stated_at);
    }
    return days;
}

void require_work(const model::Record& record, const std::string& day) {
    const std::set<std::string> days = days_of(record);
    if (days.contains(day)) return;
    const auto after = days.lower_bound(day);
    std::string where = "the record holds no dates at all";
    if (after != days.begin()) {
        where = "the last day before it with something is " + *std::prev(after);
    } else if (after != days.end()) {
        where = "the first day with something is " + *after;
    }
    throw Error(ErrorCode::NotFound, "day " + day + ": nothing was dug, recorded or scanned on it; " + where);
}

/// Units that stay in the record, and the relations that keep them there.
struct Kept {
    UnitSet units;
    std::unordered_set<model::RelationId> relations;

    void relation(const model::PhysicalRelation& relation) {
        relations.insert(relation.id);
        units.insert(relation.subject);
        units.insert(relation.object);
    }
};

std::vector<std::uint32_t> orders_of(const model::Record& whole, const strat::HarrisMatrix& matrix,
                                     const UnitSet& of_day) {
    const auto touches = [&](strat::NodeIndex node) {
        const auto members = matrix.members(node);
        return std::any_of(members.begin(), members.end(),
                           [&](model::UnitIndex unit) { return of_day.contains(whole.units[unit].id); });
    };
    std::vector<std::uint32_t> orders;
    for (const std::uint32_t at : matrix.reduced()) {
        const strat::Order& order = matrix.orders()[at];
        if (touches(order.later) || touches(order.earlier)) orders.push_back(at);
    }
    return orders;
}

void keep_of_orders(const model::Record& whole, const strat::HarrisMatrix& matrix,
                    const std::vector<std::uint32_t>& orders, Kept& kept) {
    for (const std::uint32_t at : orders) {
        const strat::Order& order = matrix.orders()[at];
        for (const strat::NodeIndex node : {order.later, order.earlier}) {
            for (const model::UnitIndex unit : matrix.members(node)) kept.units.insert(whole.units[unit].id);
        }
        for (const strat::RelationIndex relation : matrix.because(at)) kept.relation(whole.relations[relation]);
    }
}

void keep_of_problems(const std::vector<model::Diagnostic>& problems, Kept& kept) {
    const auto name = [&](const model::NamedRelation& named) {
        if (!named.relation.is_nil()) kept.relations.insert(named.relation);
        kept.units.insert(named.unit);
        kept.units.insert(named.other);
    };

    struct OfSuspect {
        const decltype(name)& add;
        Kept& kept;

        void operator()(const model::SuspectRelation& s) const { add(s.relation); }

        void operator()(const model::SuspectSameAs& s) const { add(s.same_as); }

        void operator()(const model::SuspectNumber& s) const { add(s.relation); }

        void operator()(const model::SuspectUnit& s) const { kept.units.insert(s.unit); }
    };

    for (const model::Diagnostic& problem : problems) {
        for (const model::UnitId unit : problem.units) kept.units.insert(unit);
        for (const model::NamedRelation& named : problem.relations) name(named);
        for (const model::Suspect& suspect : problem.suspects) std::visit(OfSuspect{name, kept}, suspect.what);
    }
}

// A sub-unit without its feature would say less than the sheet does.
void keep_parents(const model::Record& whole, UnitSet& units) {
    std::unordered_map<model::UnitId, model::UnitId> parents;
    for (const model::StratigraphicUnit& unit : whole.units) parents.emplace(unit.id, unit.parent);
    for (const model::UnitId start : std::vector<model::UnitId>(units.begin(), units.end())) {
        auto at = parents.find(start);
        while (at != parents.end() && !at->second.is_nil() && units.insert(at->second).second) {
            at = parents.find(at->second);
        }
    }
}

template<class Values, class Wanted>
void keep_if(Values& values, const Wanted& wanted) {
    std::erase_if(values, [&](const auto& value) { return !wanted(value); });
}

void keep_measured(model::Record& record, const UnitSet& of_day, const std::string& day) {
    keep_if(record.levels, [&](const auto& level) { return of_day.contains(level.unit); });
    keep_if(record.finds, [&](const auto& find) { return of_day.contains(find.unit) || find.found_on == day; });
    keep_if(record.samples, [&](const auto& sample) { return of_day.contains(sample.unit); });
    keep_if(record.datings, [&](const auto& dating) { return of_day.contains(dating.unit); });
    keep_if(record.documents,
            [&](const auto& document) { return of_day.contains(document.unit) || made_on(document.made_on, day); });
}

void keep_places(model::Record& record, const UnitSet& of_day, const std::string& day) {
    std::unordered_set<model::SurfaceId> surfaces;
    keep_if(record.surfaces, [&](const auto& surface) { return holds_day(surface, day); });
    for (const model::Surface& surface : record.surfaces) surfaces.insert(surface.id);
    keep_if(record.scans, [&](const auto& scan) { return scan.day == day; });
    keep_if(record.regions, [&](const auto& region) {
        return surfaces.contains(region.surface) || (!region.section.is_nil() && of_day.contains(region.unit));
    });
    std::unordered_set<model::SectionId> drawn;
    for (const model::Region& region : record.regions) drawn.insert(region.section);
    keep_if(record.sections, [&](const auto& section) { return section.day == day || drawn.contains(section.id); });
}

void keep_sources(model::Record& record, const std::string& day) {
    std::unordered_set<model::SourceId> named;
    for (const model::RelationStatement& statement : record.statements) named.insert(statement.source);
    std::unordered_set<model::SourceId> read_that_day;
    for (const model::Source& source : record.sources) {
        if (made_on(source.imported_at, day)) read_that_day.insert(source.id);
    }
    keep_if(record.sources,
            [&](const auto& source) { return named.contains(source.id) || read_that_day.contains(source.id); });
    keep_if(record.import_notes, [&](const auto& note) { return read_that_day.contains(note.source); });
}

} // namespace

std::unordered_set<model::UnitId> units_of_day(const model::Record& record, const std::string& day) {
    UnitSet units;
    for (const model::StratigraphicUnit& unit : record.units) {
        if (in_work_on(unit, day)) units.insert(unit.id);
    }
    std::unordered_set<model::SurfaceId> surfaces;
    for (const model::Surface& surface : record.surfaces) {
        if (holds_day(surface, day)) surfaces.insert(surface.id);
    }
    for (const model::Region& region : record.regions) {
        if (surfaces.contains(region.surface)) units.insert(region.unit);
    }
    for (const model::Find& find : record.finds) {
        if (find.found_on == day) units.insert(find.unit);
    }
    for (const model::Document& document : record.documents) {
        if (made_on(document.made_on, day)) units.insert(document.unit);
    }
    std::unordered_set<model::RelationId> entered;
    for (const model::RelationStatement& statement : record.statements) {
        if (statement.source.is_nil() && made_on(statement.stated_at, day)) entered.insert(statement.relation);
    }
    for (const model::PhysicalRelation& relation : record.relations) {
        if (!entered.contains(relation.id)) continue;
        units.insert(relation.subject);
        units.insert(relation.object);
    }
    units.erase(model::UnitId{});
    return units;
}

void keep_problems_of_day(std::vector<model::Diagnostic>& problems, const UnitSet& units, const std::string& day) {
    const auto of_day = [&](const model::Diagnostic& problem) {
        if (!problem.units.empty() || !problem.relations.empty()) {
            const auto named = [&](model::UnitId unit) { return units.contains(unit); };
            return std::any_of(problem.units.begin(), problem.units.end(), named) ||
                   std::any_of(problem.relations.begin(), problem.relations.end(),
                               [&](const auto& relation) { return named(relation.unit) || named(relation.other); });
        }
        return std::any_of(problem.evidence.begin(), problem.evidence.end(), [&](const auto& entry) {
            const auto* said = std::get_if<std::string>(&entry.second);
            return said != nullptr && made_on(*said, day);
        });
    };
    std::erase_if(problems, [&](const model::Diagnostic& problem) { return !of_day(problem); });
}

DaysRecord days_record(const model::Record& whole, const strat::HarrisMatrix& matrix, const std::string& day,
                       const std::vector<model::Diagnostic>& problems) {
    require_work(whole, day);
    DaysRecord result;
    result.units = units_of_day(whole, day);
    result.orders = orders_of(whole, matrix, result.units);
    Kept kept;
    kept.units = result.units;
    for (const model::PhysicalRelation& relation : whole.relations) {
        if (result.units.contains(relation.subject) || result.units.contains(relation.object)) kept.relation(relation);
    }
    keep_of_orders(whole, matrix, result.orders, kept);
    keep_of_problems(problems, kept);
    for (const model::PhysicalRelation& relation : whole.relations) {
        if (kept.relations.contains(relation.id)) kept.relation(relation);
    }
    keep_parents(whole, kept.units);

    model::Record& record = result.record;
    record = whole;
    keep_if(record.units, [&](const auto& unit) { return kept.units.contains(unit.id); });
    keep_if(record.relations, [&](const auto& relation) { return kept.relations.contains(relation.id); });
    keep_if(record.statements, [&](const auto& said) { return kept.relations.contains(said.relation); });
    keep_if(record.decisions, [&](const auto& decision) {
        return made_on(decision.made_at, day) ||
               std::any_of(problems.begin(), problems.end(),
                           [&](const auto& problem) { return problem.id == decision.subject_id; });
    });
    for (model::UnitGroup& group : record.groups) {
        keep_if(group.members, [&](model::UnitId unit) { return kept.units.contains(unit); });
    }
    keep_measured(record, result.units, day);
    keep_places(record, result.units, day);
    keep_sources(record, day);
    return result;
}

} // namespace planum::app
