// SPDX-License-Identifier: MIT
#include "app/import/merge.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "app/import/field_merge.hpp"
#include "app/import/unit_table.hpp"
#include "core/base/text.hpp"

namespace planum::app {

using model::RelationKind;
using model::StatementSide;

namespace {

// A relation as a set sees it: two units and a kind.
using Triple = std::tuple<model::UnitId, RelationKind, model::UnitId>;

// What makes two statements the same one, so that they are counted and not repeated.
using StatementKey = std::tuple<model::RelationId, StatementSide, model::SourceId, std::string>;

// Phase numbers restart in each period.
std::string phase_key(const std::string& period, const std::string& number) { return period + '\x1F' + number; }

class Merge {
  public:
    Merge(const model::Record& current, const MergeOptions& options, UuidSource& ids, const Clock& clock)
        : current_(current), options_(options), ids_(ids), clock_(clock), units_(current, options.numbers, ids) {}

    MergePlan run(const std::vector<ImportSet>& sets) {
        index_existing();
        for (const ImportSet& set : sets) merge_sources(set);
        for (const ImportSet& set : sets) merge_chronology(set);
        for (const ImportSet& set : sets) merge_sheets(set);
        for (const ImportSet& set : sets) merge_parents(set);
        for (const ImportSet& set : sets) merge_relations(set);
        for (const ImportSet& set : sets) merge_groups(set);
        for (const ImportSet& set : sets) merge_measured(set);
        for (const ImportSet& set : sets) merge_notes(set);
        judge_sides();
        collect();
        return std::move(plan_);
    }

  private:
    void index_existing();
    void merge_sources(const ImportSet& set);
    void merge_chronology(const ImportSet& set);
    void merge_sheets(const ImportSet& set);
    void merge_sheet(const strat::ImportedUnit& sheet);
    void merge_parents(const ImportSet& set);
    void merge_relations(const ImportSet& set);
    void merge_groups(const ImportSet& set);
    void merge_measured(const ImportSet& set);
    void merge_finds(const ImportSet& set);
    void merge_notes(const ImportSet& set);
    void judge_sides();
    void collect();

    model::SourceId source_id(const std::string& name) const;
    [[nodiscard]] std::string number_of(model::PeriodId period) const;
    [[nodiscard]] model::PhaseId phase_of(const strat::ImportedUnit& sheet) const;
    model::PhysicalRelation& relation(const strat::StatedRelation& stated, std::size_t subject, std::size_t object);
    [[nodiscard]] model::UnitId unit_of(const strat::UnitName& name);

    // A value kept by natural key, remembering what happened to it.
    template<class T>
    struct Kept {
        T value;
        bool is_new = false;
        bool is_changed = false;
    };

    template<class T>
    using KeptByNumber = std::map<std::string, Kept<T>>;

    FieldMerge fields(const std::string& what, bool& changed) {
        return {what, options_.update, changed, plan_.conflicts};
    }

    // The number by which people know something, found by its id.
    template<class T>
    static auto name_in(const KeptByNumber<T>& things) {
        return [&things](decltype(T::id) id) {
            for (const auto& [key, kept] : things) {
                if (kept.value.id == id) return kept.value.number;
            }
            return std::string{};
        };
    }

    auto unit_name() {
        return [this](model::UnitId id) { return units_.display_of(id); };
    }

    template<class T>
    static void give(KeptByNumber<T>& from, std::vector<T>& fresh, std::vector<T>* changed) {
        for (auto& [number, kept] : from) {
            if (kept.is_new) {
                fresh.push_back(std::move(kept.value));
            } else if (kept.is_changed && changed != nullptr) {
                changed->push_back(std::move(kept.value));
            }
        }
    }

    const model::Record& current_;
    const MergeOptions& options_;
    UuidSource& ids_;
    const Clock& clock_;
    UnitTable units_;
    MergePlan plan_;

    KeptByNumber<model::Source> sources_;
    KeptByNumber<model::Period> periods_;
    KeptByNumber<model::Phase> phases_;
    KeptByNumber<model::UnitGroup> groups_;
    KeptByNumber<model::Find> finds_;
    std::map<Triple, std::size_t> relation_at_;
    std::vector<Kept<model::PhysicalRelation>> relations_;
    std::map<StatementKey, std::int64_t> stated_before_;
    std::map<StatementKey, std::int64_t> stated_now_;
    // Sources on which a relation is stated from the subject's and the object's side.
    std::map<std::pair<model::SourceId, model::RelationId>, std::pair<bool, bool>> sides_;
};

void Merge::index_existing() {
    for (const model::Source& s : current_.sources) sources_[s.name] = {s, false, false};
    for (const model::Period& p : current_.periods) periods_[p.number] = {p, false, false};
    for (const model::Phase& p : current_.phases) phases_[phase_key(number_of(p.period), p.number)] = {p, false, false};
    for (const model::UnitGroup& g : current_.groups) groups_[g.number] = {g, false, false};
    for (const model::Find& f : current_.finds) finds_[f.number] = {f, false, false};
    relations_.reserve(current_.relations.size());
    for (const model::PhysicalRelation& r : current_.relations) {
        relation_at_.emplace(Triple{r.subject, r.kind, r.object}, relations_.size());
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

void Merge::merge_chronology(const ImportSet& set) {
    for (const model::Period& offered : set.record.periods) {
        auto [it, fresh] = periods_.try_emplace(offered.number, Kept<model::Period>{offered, true, false});
        Kept<model::Period>& kept = it->second;
        if (fresh) {
            kept.value.id = model::PeriodId{ids_.next()};
            continue;
        }
        FieldMerge merge = fields("period " + offered.number, kept.is_changed);
        merge.text("title", kept.value.title, offered.title);
        merge.text("description", kept.value.description, offered.description);
        merge.optional("from", kept.value.from, offered.from);
        merge.optional("to", kept.value.to, offered.to);
        merge.optional("rank", kept.value.rank, offered.rank);
    }
    for (const strat::ImportedPhase& offered : set.record.phases) {
        auto [it, fresh] = phases_.try_emplace(phase_key(offered.period, offered.values.number),
                                               Kept<model::Phase>{offered.values, true, false});
        Kept<model::Phase>& kept = it->second;
        model::PeriodId period;
        if (const auto p = periods_.find(offered.period); p != periods_.end()) period = p->second.value.id;
        if (fresh) {
            kept.value.id = model::PhaseId{ids_.next()};
            kept.value.period = period;
            continue;
        }
        FieldMerge merge = fields("phase " + offered.values.number, kept.is_changed);
        merge.text("title", kept.value.title, offered.values.title);
        merge.text("description", kept.value.description, offered.values.description);
        merge.id("period", kept.value.period, period, name_in(periods_));
        merge.optional("from", kept.value.from, offered.values.from);
        merge.optional("to", kept.value.to, offered.values.to);
        merge.optional("rank", kept.value.rank, offered.values.rank);
    }
}

std::string Merge::number_of(model::PeriodId period) const {
    for (const model::Period& p : current_.periods) {
        if (p.id == period) return p.number;
    }
    return {};
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
    const auto [it, fresh] = relation_at_.try_emplace(Triple{s, stated.kind, o}, relations_.size());
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

void Merge::merge_groups(const ImportSet& set) {
    for (const strat::ImportedGroup& offered : set.record.groups) {
        auto [it, fresh] =
            groups_.try_emplace(offered.values.number, Kept<model::UnitGroup>{offered.values, true, false});
        Kept<model::UnitGroup>& kept = it->second;
        if (fresh) {
            kept.value.id = model::GroupId{ids_.next()};
        } else {
            FieldMerge merge = fields("group " + offered.values.number, kept.is_changed);
            merge.text("type", kept.value.type, offered.values.type);
            merge.text("title", kept.value.title, offered.values.title);
            merge.text("description", kept.value.description, offered.values.description);
        }
        std::set<model::UnitId> members(kept.value.members.begin(), kept.value.members.end());
        for (const strat::UnitName& name : offered.members) {
            const model::UnitId member = unit_of(name);
            if (!members.insert(member).second) continue;
            kept.value.members.push_back(member);
            kept.is_changed = true;
        }
    }
    for (const strat::ImportedGroup& offered : set.record.groups) {
        const auto parent = groups_.find(offered.parent);
        if (parent == groups_.end() || offered.parent == offered.values.number) continue;
        Kept<model::UnitGroup>& kept = groups_.at(offered.values.number);
        fields("group " + offered.values.number, kept.is_changed)
            .id("parent", kept.value.parent, parent->second.value.id, name_in(groups_));
    }
}

model::UnitId Merge::unit_of(const strat::UnitName& name) {
    if (text::trim(name.number).empty()) return {};
    return units_.at(units_.mentioned(name, std::string(text::trim(name.area)))).unit.id;
}

void Merge::merge_finds(const ImportSet& set) {
    for (const strat::ImportedFind& offered : set.record.finds) {
        const model::UnitId unit = unit_of(offered.unit);
        auto [it, fresh] = finds_.try_emplace(offered.values.number, Kept<model::Find>{offered.values, true, false});
        Kept<model::Find>& kept = it->second;
        if (fresh) {
            kept.value.id = model::FindId{ids_.next()};
            kept.value.unit = unit;
            continue;
        }
        FieldMerge merge = fields("find " + offered.values.number, kept.is_changed);
        merge.id("unit", kept.value.unit, unit, unit_name());
        merge.optional("x", kept.value.x, offered.values.x);
        merge.optional("y", kept.value.y, offered.values.y);
        merge.optional("z", kept.value.z, offered.values.z);
        merge.text("type", kept.value.type, offered.values.type);
        merge.text("material", kept.value.material, offered.values.material);
        merge.optional("count", kept.value.count, offered.values.count);
        merge.optional("weight", kept.value.weight, offered.values.weight);
        merge.text("condition", kept.value.condition, offered.values.condition);
        merge.text("box", kept.value.box, offered.values.box);
        merge.text("found_on", kept.value.found_on, offered.values.found_on);
        merge.text("description", kept.value.description, offered.values.description);
    }
}

// Things without a number of their own are the same when everything they say is.
template<class T, class Key>
class SeenBefore {
  public:
    SeenBefore(const std::vector<T>& before, Key key) : key_(key) {
        for (const T& value : before) seen_.insert(key_(value));
    }

    bool add(const T& value) { return seen_.insert(key_(value)).second; }

  private:
    Key key_;
    std::set<std::invoke_result_t<Key, const T&>> seen_;
};

void Merge::merge_measured(const ImportSet& set) {
    merge_finds(set);
    const auto dating_key = [](const model::Dating& d) {
        return std::make_tuple(d.unit, d.find, d.label, d.kind, d.from, d.to, d.bp, d.bp_error);
    };
    const auto level_key = [](const model::Level& l) { return std::make_tuple(l.unit, l.role, l.x, l.y, l.z); };
    const auto sample_key = [](const model::Sample& s) { return std::make_tuple(s.number, s.unit); };
    const auto document_key = [](const model::Document& d) { return std::make_tuple(d.type, d.number, d.unit); };
    // What earlier sets of this import added counts as seen, too.
    const auto with = [](auto current, const auto& added) {
        current.insert(current.end(), added.begin(), added.end());
        return current;
    };
    SeenBefore datings(with(current_.datings, plan_.new_datings), dating_key);
    for (const strat::ImportedDating& offered : set.record.datings) {
        model::Dating value = offered.values;
        value.unit = unit_of(offered.unit);
        if (const auto find = finds_.find(offered.find); find != finds_.end()) value.find = find->second.value.id;
        if (!datings.add(value)) continue;
        value.id = model::DatingId{ids_.next()};
        plan_.new_datings.push_back(std::move(value));
    }
    SeenBefore levels(with(current_.levels, plan_.new_levels), level_key);
    for (const strat::ImportedLevel& offered : set.record.levels) {
        model::Level value = offered.values;
        value.unit = unit_of(offered.unit);
        if (value.unit.is_nil() || !levels.add(value)) continue;
        value.id = model::LevelId{ids_.next()};
        plan_.new_levels.push_back(std::move(value));
    }
    SeenBefore samples(with(current_.samples, plan_.new_samples), sample_key);
    for (const strat::ImportedSample& offered : set.record.samples) {
        model::Sample value = offered.values;
        value.unit = unit_of(offered.unit);
        if (!samples.add(value)) continue;
        value.id = model::SampleId{ids_.next()};
        plan_.new_samples.push_back(std::move(value));
    }
    SeenBefore documents(with(current_.documents, plan_.new_documents), document_key);
    for (const strat::ImportedDocument& offered : set.record.documents) {
        model::Document value = offered.values;
        value.unit = unit_of(offered.unit);
        if (!documents.add(value)) continue;
        value.id = model::DocumentId{ids_.next()};
        plan_.new_documents.push_back(std::move(value));
    }
}

// The notes of a source are those of its last reading: what it says no longer goes.
void Merge::merge_notes(const ImportSet& set) {
    using NoteKey = std::tuple<std::int64_t, std::string, std::string, std::string>;
    std::map<model::SourceId, std::map<NoteKey, std::int64_t>> now;
    for (const model::Source& source : set.sources) now[source_id(source.name)];
    std::map<model::SourceId, std::vector<const strat::ReadNote*>> by_source;
    for (const strat::ReadNote& note : set.notes) {
        model::SourceId source = source_id(note.file);
        if (source.is_nil()) source = source_id(set.main_source);
        by_source[source].push_back(&note);
        ++now[source][{note.line, note.code, note.raw_text, note.message}];
    }
    for (const model::ImportNote& before : current_.import_notes) {
        const auto source = now.find(before.source);
        if (source == now.end()) continue;
        std::int64_t& left = source->second[{before.line, before.code, before.raw_text, before.message}];
        if (left > 0) {
            --left; // still said: keep the row
        } else {
            plan_.gone_notes.push_back(before.id);
        }
    }
    for (const auto& [source, notes] : by_source) {
        for (const strat::ReadNote* note : notes) {
            std::int64_t& left = now[source][{note->line, note->code, note->raw_text, note->message}];
            if (left <= 0) continue;
            --left;
            model::ImportNote value;
            value.id = model::ImportNoteId{ids_.next()};
            value.source = source;
            value.line = note->line;
            value.code = note->code;
            value.raw_text = note->raw_text;
            value.message = note->message;
            plan_.new_notes.push_back(std::move(value));
        }
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

} // namespace

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
