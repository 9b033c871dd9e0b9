// SPDX-License-Identifier: MIT
#include "strat/exchange/write_support.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace planum::strat {

namespace {

using model::RelationKind;
using model::StratigraphicUnit;

template<class Key>
std::string find_in(const std::unordered_map<Key, std::string>& map, Key id) {
    const auto it = map.find(id);
    return it == map.end() ? std::string{} : it->second;
}

template<class Values, class Predicate>
std::size_t count(const Values& values, Predicate predicate) {
    return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), predicate));
}

void add_unit_losses(const model::Record& record, const Carries& carries, std::vector<std::string>& lost) {
    const auto& units = record.units;
    const auto add = [&](bool carried, std::string_view sentence, auto has) {
        if (!carried) add_loss(lost, count(units, has), sentence);
    };
    add(false, "units of a kind that the format does not know", [&](const StratigraphicUnit& u) {
        const bool plain = u.kind == model::UnitKind::Unknown && u.form == model::UnitForm::None;
        return !plain && (carries.kind == nullptr || !carries.kind(u));
    });
    add(carries.all_areas, "units whose area is written only where a number is not unique",
        [](const StratigraphicUnit& u) { return !u.area.is_nil(); });
    add(carries.status, "units without their status",
        [](const StratigraphicUnit& u) { return u.status != model::UnitStatus::Open; });
    add(carries.mentioned, "units without a sheet, written like those with one",
        [](const StratigraphicUnit& u) { return u.origin == model::UnitOrigin::Mentioned; });
    add(carries.title, "titles not written", [](const StratigraphicUnit& u) { return !u.title.empty(); });
    add(carries.description, "descriptions not written",
        [](const StratigraphicUnit& u) { return !u.description.empty(); });
    add(carries.interpretation, "interpretations not written",
        [](const StratigraphicUnit& u) { return !u.interpretation.empty(); });
    add(carries.excavation, "units without their days, recorder or parent", [](const StratigraphicUnit& u) {
        return !u.excavated_from.empty() || !u.excavated_on.empty() || !u.recorded_by.empty() ||
               !u.recorded_on.empty() || !u.parent.is_nil();
    });
    add(carries.details, "units without their further fields",
        [](const StratigraphicUnit& u) { return !u.details.empty(); });
    add(carries.phases, "units without their phase", [](const StratigraphicUnit& u) { return !u.phase.is_nil(); });
    add(carries.periods, "units without their period", [](const StratigraphicUnit& u) { return !u.period.is_nil(); });
}

void add_relation_losses(const model::Record& record, const Carries& carries, std::vector<std::string>& lost) {
    const auto of_kind = [&](RelationKind kind) {
        return count(record.relations, [&](const auto& r) { return r.kind == kind; });
    };
    if (!carries.contact_kinds) {
        add_loss(lost, of_kind(RelationKind::Cuts) + of_kind(RelationKind::Fills) + of_kind(RelationKind::Abuts),
                 "relations cuts, fills and abuts written as above");
    }
    if (!carries.later) add_loss(lost, of_kind(RelationKind::Later), "relations later written as above");
    if (!carries.same_as) add_loss(lost, of_kind(RelationKind::SameAs), "relations same_as not written");
    if (!carries.contemporary) {
        add_loss(lost, of_kind(RelationKind::Contemporary), "relations contemporary not written");
    }
    if (!carries.bonds) {
        add_loss(lost, of_kind(RelationKind::BondsWith),
                 carries.contemporary ? "relations bonds_with written as contemporary"
                                      : "relations bonds_with not written");
    }
    if (!carries.borders) add_loss(lost, of_kind(RelationKind::Borders), "relations borders not written");
    if (!carries.certainty) {
        add_loss(lost, count(record.relations, [](const auto& r) { return r.certainty != model::Certainty::Certain; }),
                 "relations not marked as uncertain");
        add_loss(lost, count(record.relations, [](const auto& r) { return r.correlation; }),
                 "relations same_as not marked as correlations");
    }
    if (!carries.statements) {
        add_loss(lost, count(record.statements, [](const auto& s) { return !s.person.empty(); }),
                 "statements without the person who made them");
    }
}

} // namespace

RecordNames::RecordNames(const model::Record& record) : record_(&record), index_(record) {
    for (const model::Period& period : record.periods) periods_.emplace(period.id, period.number);
    std::map<std::string, std::size_t> uses;
    for (const model::Phase& phase : record.phases) ++uses[phase.number];
    for (const model::Phase& phase : record.phases) {
        const std::string period = find_in(periods_, phase.period);
        const bool plain = uses[phase.number] < 2 || period.empty();
        phases_.emplace(phase.id, plain ? phase.number : period + "." + phase.number);
        period_of_phase_.emplace(phase.id, phase.period);
    }
    for (const model::UnitGroup& group : record.groups) groups_.emplace(group.id, group.number);
    for (const model::Area& area : record.areas) areas_.emplace(area.id, area.name);
    for (const model::Find& find : record.finds) finds_.emplace(find.id, find.number);
}

std::string RecordNames::phase(model::PhaseId id) const { return find_in(phases_, id); }

std::string RecordNames::period(model::PeriodId id) const { return find_in(periods_, id); }

std::string RecordNames::group(model::GroupId id) const { return find_in(groups_, id); }

std::string RecordNames::area(model::AreaId id) const { return find_in(areas_, id); }

std::string RecordNames::find(model::FindId id) const { return find_in(finds_, id); }

model::PeriodId RecordNames::period_of(model::PhaseId id) const {
    const auto it = period_of_phase_.find(id);
    return it == period_of_phase_.end() ? model::PeriodId{} : it->second;
}

std::vector<std::size_t> complete_relations(const RecordNames& names) {
    std::vector<std::size_t> complete;
    const auto& relations = names.record().relations;
    for (std::size_t i = 0; i < relations.size(); ++i) {
        if (names.has(relations[i].subject) && names.has(relations[i].object)) complete.push_back(i);
    }
    return complete;
}

std::string UniqueNames::take(std::string wanted) {
    if (taken_.insert(wanted).second) return wanted;
    for (std::size_t i = 2;; ++i) {
        std::string candidate = fmt::format("{}_{}", wanted, i);
        if (taken_.insert(candidate).second) return candidate;
    }
}

void add_loss(std::vector<std::string>& lost, std::size_t count, std::string_view sentence) {
    if (count > 0) lost.push_back(fmt::format("{}: {}", sentence, count));
}

Carries carries_everything() {
    Carries all;
    all.kind = [](const model::StratigraphicUnit&) { return true; };
    all.all_areas = all.status = all.title = all.description = all.interpretation = all.excavation = all.details =
        all.mentioned = all.phases = all.periods = all.chronology_years = all.groups = all.contact_kinds = all.later =
            all.same_as = all.bonds = all.contemporary = all.borders = all.certainty = all.statements = all.datings =
                all.levels = all.finds = all.samples = all.documents = true;
    return all;
}

std::vector<std::string> losses(const model::Record& record, const Carries& carries) {
    std::vector<std::string> lost;
    add_unit_losses(record, carries, lost);
    add_relation_losses(record, carries, lost);
    if (!carries.chronology_years) {
        const auto dated = [](const auto& c) { return c.from || c.to || c.rank; };
        add_loss(lost, count(record.phases, dated) + count(record.periods, dated),
                 "phases and periods whose years or rank are not written");
    }
    if (!carries.groups) add_loss(lost, record.groups.size(), "groups of units not written");
    if (!carries.datings) add_loss(lost, record.datings.size(), "datings not written");
    if (!carries.levels) add_loss(lost, record.levels.size(), "levels not written");
    if (!carries.finds) add_loss(lost, record.finds.size(), "finds not written");
    if (!carries.samples) add_loss(lost, record.samples.size(), "samples not written");
    if (!carries.documents) add_loss(lost, record.documents.size(), "documents not written");
    add_loss(lost, record.surfaces.size() + record.sections.size() + record.regions.size(),
             "surfaces, sections and outlines not written");
    add_loss(lost, record.scans.size(), "scans not written");
    add_loss(lost, record.decisions.size() + record.interpretations.size(),
             "decisions and interpretations not written");
    return lost;
}

} // namespace planum::strat
