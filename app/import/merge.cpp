// SPDX-License-Identifier: MIT
#include "app/import/merge.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "app/import/merge_work.hpp"
#include "core/base/text.hpp"

namespace planum::app {

using model::RelationKind;
using model::StatementSide;

std::string phase_key(const std::string& period, const std::string& number) { return period + '\x1F' + number; }

void Merge::index_existing() {
    for (const model::Source& s : current_.sources) sources_[s.name] = {s, false, false};
    for (const model::Period& p : current_.periods) periods_[p.number] = {p, false, false};
    for (const model::Phase& p : current_.phases) phases_[phase_key(number_of(p.period), p.number)] = {p, false, false};
    for (const model::UnitGroup& g : current_.groups) groups_[g.number] = {g, false, false};
    for (const model::Find& f : current_.finds) finds_[f.number] = {f, false, false};
    relations_.reserve(current_.relations.size());
    for (const model::PhysicalRelation& r : current_.relations) {
        relation_at_.emplace(RelationTriple{r.subject, r.kind, r.object}, relations_.size());
        relations_.push_back({r, false, false});
    }
    for (const model::RelationStatement& s : current_.statements) {
        ++stated_before_[{s.relation, s.side, s.source, s.person}];
        auto& [subject, object] = sides_[{s.source, s.relation}];
        subject |= s.side == StatementSide::Subject;
        object |= s.side == StatementSide::Object;
    }
}

void Merge::merge_sources(const ImportSet& set) {
    for (const model::Source& offered : set.sources) {
        auto [it, fresh] = sources_.try_emplace(offered.name, Kept<model::Source>{offered, true, false});
        model::Source& source = it->second.value;
        if (fresh) {
            source.id = model::SourceId{ids_.next()};
            source.imported_at = clock_.now();
        } else if (!it->second.is_new && source.sha256 != offered.sha256) {
            source.sha256 = offered.sha256;
            source.format = offered.format;
            source.imported_at = clock_.now();
            it->second.is_changed = true;
        }
    }
}

model::SourceId Merge::source_id(const std::string& name) const {
    const auto it = sources_.find(name);
    return it == sources_.end() ? model::SourceId{} : it->second.value.id;
}

// A sheet that names no period means the only phase of that number, if there is only one.
model::PhaseId Merge::phase_of(const strat::ImportedUnit& sheet) const {
    if (sheet.phase.empty()) return {};
    if (const auto it = phases_.find(phase_key(sheet.period, sheet.phase)); it != phases_.end()) {
        return it->second.value.id;
    }
    model::PhaseId found;
    for (const auto& [key, kept] : phases_) {
        if (kept.value.number != sheet.phase) continue;
        if (!found.is_nil()) return {};
        found = kept.value.id;
    }
    return found;
}

void Merge::merge_sheets(const ImportSet& set) {
    for (const model::Area& offered : set.record.areas) units_.offer(offered);
    for (const strat::ImportedUnit& sheet : set.record.units) merge_sheet(sheet);
}

void Merge::merge_sheet(const strat::ImportedUnit& sheet) {
    const std::size_t position = units_.of_sheet(sheet.name);
    const model::AreaId area = units_.area(std::string(text::trim(sheet.name.area)));
    UnitTable::Entry& entry = units_.at(position);
    model::StratigraphicUnit& unit = entry.unit;
    const model::StratigraphicUnit& offered = sheet.values;
    const std::string what = "unit " + units_.display(position);
    if (!area.is_nil() && !unit.area.is_nil() && unit.area != area) {
        plan_.warnings.push_back(fmt::format(
            "number {} is used in area {} and in area {} and was taken for one unit; if they are two, import "
            "with --numbers area",
            unit.number, units_.area_name(unit.area), units_.area_name(area)));
    }
    FieldMerge merge = fields(what, entry.is_changed);
    merge.id("area", unit.area, area, [&](model::AreaId id) { return units_.area_name(id); });
    merge.choice("kind", unit.kind, offered.kind, model::UnitKind::Unknown);
    merge.choice("form", unit.form, offered.form, model::UnitForm::None);
    merge.choice("status", unit.status, offered.status, model::UnitStatus::Open);
    merge.text("title", unit.title, offered.title);
    merge.text("description", unit.description, offered.description);
    merge.text("interpretation", unit.interpretation, offered.interpretation);
    merge.text("excavated_from", unit.excavated_from, offered.excavated_from);
    merge.text("excavated_on", unit.excavated_on, offered.excavated_on);
    merge.text("recorded_by", unit.recorded_by, offered.recorded_by);
    merge.text("recorded_on", unit.recorded_on, offered.recorded_on);
    for (const auto& [field, value] : offered.details) {
        if (value.empty()) continue;
        merge.text(field, unit.details[field], value);
    }
    merge.id("phase", unit.phase, phase_of(sheet), name_in(phases_));
    if (const auto it = periods_.find(sheet.period); it != periods_.end()) {
        merge.id("period", unit.period, it->second.value.id, name_in(periods_));
    }
}

void Merge::merge_parents(const ImportSet& set) {
    for (const strat::ImportedUnit& sheet : set.record.units) {
        if (sheet.parent.number.empty()) continue;
        const std::size_t position = units_.of_sheet(sheet.name);
        const std::size_t parent = units_.mentioned(sheet.parent, sheet.name.area);
        if (parent == position) continue;
        const model::UnitId parent_id = units_.at(parent).unit.id;
        UnitTable::Entry& entry = units_.at(position);
        fields("unit " + units_.display(position), entry.is_changed)
            .id("parent", entry.unit.parent, parent_id, unit_name());
    }
}

model::PhysicalRelation& Merge::relation(const strat::StatedRelation& stated, std::size_t subject, std::size_t object) {
    const model::UnitId s = units_.at(subject).unit.id;
    const model::UnitId o = units_.at(object).unit.id;
    const auto [it, fresh] = relation_at_.try_emplace(RelationTriple{s, stated.kind, o}, relations_.size());
    if (fresh) {
        model::PhysicalRelation value;
        value.id = model::RelationId{ids_.next()};
        value.subject = s;
        value.kind = stated.kind;
        value.object = o;
        value.certainty = stated.certainty;
        value.correlation = stated.correlation;
        relations_.push_back({value, true, false});
    }
    return relations_[it->second].value;
}

void Merge::merge_relations(const ImportSet& set) {
    for (const strat::StatedRelation& stated : set.record.relations) {
        std::size_t subject = units_.mentioned(stated.subject, std::string(text::trim(stated.object.area)));
        std::size_t object = units_.mentioned(stated.object, units_.area_name(units_.at(subject).unit.area));
        StatementSide side = stated.side;
        // Symmetric kinds are stored from the number that sorts first.
        if (model::is_symmetric(stated.kind) &&
            text::natural_order(units_.at(object).unit.number, units_.at(subject).unit.number) < 0) {
            std::swap(subject, object);
            if (side != StatementSide::Neither) {
                side = side == StatementSide::Subject ? StatementSide::Object : StatementSide::Subject;
            }
        }
        const model::PhysicalRelation& kept = relation(stated, subject, object);
        const model::SourceId source = source_id(stated.file.empty() ? set.main_source : stated.file);
        auto& [from_subject, from_object] = sides_[{source, kept.id}];
        from_subject |= side == StatementSide::Subject;
        from_object |= side == StatementSide::Object;
        const StatementKey key{kept.id, side, source, stated.person};
        if (++stated_now_[key] <= stated_before_[key]) continue;
        model::RelationStatement statement;
        statement.id = model::StatementId{ids_.next()};
        statement.relation = kept.id;
        statement.side = side;
        statement.source = source;
        statement.line = stated.line;
        statement.person = stated.person;
        statement.raw_text = stated.raw_text;
        statement.stated_at = clock_.now();
        plan_.new_statements.push_back(std::move(statement));
    }
}

// A source states both sides when at least half of its relations are said from both.
void Merge::judge_sides() {
    std::map<model::SourceId, std::pair<std::int64_t, std::int64_t>> counts; // relations, of them both ways
    for (const auto& [key, sides] : sides_) {
        if (!sides.first && !sides.second) continue;
        auto& [all, both] = counts[key.first];
        ++all;
        if (sides.first && sides.second) ++both;
    }
    for (auto& [name, kept] : sources_) {
        const auto it = counts.find(kept.value.id);
        const bool both_sides = it != counts.end() && 2 * it->second.second >= it->second.first;
        if (kept.value.states_both_sides == both_sides) continue;
        kept.value.states_both_sides = both_sides;
        kept.is_changed = true;
    }
}

void Merge::collect() {
    plan_.new_areas = units_.new_areas();
    give(sources_, plan_.new_sources, &plan_.changed_sources);
    give(periods_, plan_.new_periods, &plan_.changed_periods);
    give(phases_, plan_.new_phases, &plan_.changed_phases);
    give(groups_, plan_.new_groups, &plan_.changed_groups);
    give(finds_, plan_.new_finds, &plan_.changed_finds);
    for (const UnitTable::Entry& entry : units_.entries()) {
        if (entry.is_new) {
            plan_.new_units.push_back(entry.unit);
        } else if (entry.is_changed) {
            plan_.changed_units.push_back(entry.unit);
        }
    }
    for (const Kept<model::PhysicalRelation>& kept : relations_) {
        if (kept.is_new) plan_.new_relations.push_back(kept.value);
    }
}

bool MergePlan::is_empty() const noexcept {
    return new_areas.empty() && new_sources.empty() && changed_sources.empty() && new_periods.empty() &&
           changed_periods.empty() && new_phases.empty() && changed_phases.empty() && new_units.empty() &&
           changed_units.empty() && new_groups.empty() && changed_groups.empty() && new_relations.empty() &&
           changed_relations.empty() && new_statements.empty() && new_datings.empty() && new_levels.empty() &&
           new_finds.empty() && changed_finds.empty() && new_samples.empty() && new_documents.empty() &&
           new_notes.empty() && gone_notes.empty();
}

MergePlan plan_merge(const model::Record& current, const std::vector<ImportSet>& sets, const MergeOptions& options,
                     UuidSource& ids, const Clock& clock) {
    return Merge(current, options, ids, clock).run(sets);
}

} // namespace planum::app
