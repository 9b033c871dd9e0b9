// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/import/merge_work.hpp"
#include "core/base/text.hpp"

namespace planum::app {

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
        auto [it, fresh] = phases_.try_emplace(key_of(offered), Kept<model::Phase>{offered.values, true, false});
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

// A list of units names phases without their periods: it means the only one of that number, if there is only one.
std::string Merge::key_of(const strat::ImportedPhase& offered) const {
    const std::string own = phase_key(offered.period, offered.values.number);
    if (!offered.period.empty() || phases_.contains(own)) return own;
    const auto same = [&](const auto& known) { return known.second.value.number == offered.values.number; };
    const auto first = std::find_if(phases_.begin(), phases_.end(), same);
    if (first == phases_.end() || std::find_if(std::next(first), phases_.end(), same) != phases_.end()) return own;
    return first->first;
}

std::string Merge::number_of(model::PeriodId period) const {
    for (const model::Period& p : current_.periods) {
        if (p.id == period) return p.number;
    }
    return {};
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

namespace {

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

} // namespace

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

} // namespace planum::app
