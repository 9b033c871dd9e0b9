// SPDX-License-Identifier: MIT
#include "strat/exchange/phaser_record.hpp"

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/unit_fields.hpp"

namespace planum::strat {

namespace {

constexpr int kMaxNesting = 8; // period, phase, group, subgroup, context, dating; a ring of parents ends here

// Groups and subgroups share one list of names here.
int name_space(PhaserClass kind) {
    switch (kind) {
    case PhaserClass::Period: return 0;
    case PhaserClass::Phase: return 1;
    case PhaserClass::Group:
    case PhaserClass::Subgroup: return 2;
    case PhaserClass::Context: return 3;
    case PhaserClass::Dating: return 4;
    }
    return 4;
}

std::string with_tolerance(const PhaserNode& node) {
    if (node.tolerance.empty()) return node.description;
    return node.description + (node.description.empty() ? "" : " ") + "(" + node.tolerance + ")";
}

model::DatingKind dating_kind(std::string_view type) {
    const std::string word = text::fold_case(type);
    if (word.find("coin") != std::string::npos) return model::DatingKind::Coin;
    const bool radiocarbon = word.find("c14") != std::string::npos || word.find("radiocarbon") != std::string::npos ||
                             word.find("14c") != std::string::npos;
    return radiocarbon ? model::DatingKind::Radiocarbon : model::DatingKind::Find;
}

} // namespace

void PhaserRecord::add(PhaserNode node) {
    const PhaserKey key{node.kind, node.id};
    const auto [found, is_new] = at_.try_emplace(key, nodes_.size());
    if (is_new) {
        nodes_.push_back(std::move(node));
        return;
    }
    // The older tables repeat the context in every row of its relations.
    PhaserNode& known = nodes_[found->second];
    const Place place{node.file, node.line, node.id};
    builder_.fill(known.type, node.type, "the type of " + node.id, place);
    builder_.fill(known.description, node.description, "the description of " + node.id, place);
    for (PhaserKey& outer : node.within) known.within.push_back(std::move(outer));
}

const PhaserNode* PhaserRecord::find(const PhaserKey& key) const {
    const auto found = at_.find(key);
    return found == at_.end() ? nullptr : &nodes_[found->second];
}

Imported<ImportedRecord> PhaserRecord::finish() {
    note_sites();
    for (const PhaserNode& node : nodes_) read(node);
    for (const PhaserEdge& edge : edges_) read(edge);
    return builder_.finish();
}

void PhaserRecord::note_sites() {
    std::set<std::string> sites;
    for (const PhaserNode& node : nodes_) {
        if (!node.site.empty()) sites.insert(node.site);
    }
    if (sites.size() == 1) builder_.record.project_name = *sites.begin();
    if (sites.size() < 2) return;
    std::string names;
    for (const std::string& site : sites) names += (names.empty() ? "" : ", ") + site;
    builder_.note({nodes_.front().file, 0, names}, "several-sites",
                  "several site codes; all were read, and equal numbers count as the same unit");
}

PhaserRecord::Years PhaserRecord::years_of(const PhaserNode& node) {
    Years years{year_from_text(node.from), year_from_text(node.to)};
    const std::string raw = fmt::format("{} : {}", node.from, node.to);
    const Place place{node.file, node.line, raw};
    if ((!node.from.empty() && !years.from) || (!node.to.empty() && !years.to)) {
        builder_.note(place, "unparsed", fmt::format("{}: a year is no number; left out", node.id));
    }
    if (years.from && years.to && *years.to < *years.from) {
        builder_.note(place, "swapped-years",
                      fmt::format("{}: the years run backwards; taken the other way round", node.id));
        std::swap(years.from, years.to);
    }
    return years;
}

// The nearest container of a class: named in the row itself, else by what it lies in.
const PhaserNode* PhaserRecord::container(const PhaserNode& node, PhaserClass kind) const {
    const PhaserNode* at = &node;
    for (int depth = 0; depth < kMaxNesting && at != nullptr; ++depth) {
        const PhaserNode* next = nullptr;
        for (const PhaserKey& key : at->within) {
            const PhaserNode* outer = find(key);
            if (outer != nullptr && key.first == kind) return outer;
            if (outer != nullptr && next == nullptr) next = outer;
        }
        at = next;
    }
    return nullptr;
}

std::string PhaserRecord::name_of(const PhaserNode& node) {
    const auto [found, is_new] = names_.try_emplace({node.kind, node.id});
    if (!is_new) return found->second;
    std::string name = node.label.empty() ? node.id : node.label;
    const int space = name_space(node.kind);
    if (!used_names_.emplace(space, name).second) {
        name = node.label.empty() || node.label == node.id ? fmt::format("subgroup {}", node.id)
                                                           : fmt::format("{} ({})", node.label, node.id);
        used_names_.emplace(space, name);
    }
    return found->second = name;
}

UnitName PhaserRecord::unit_name(const std::string& context) {
    const PhaserNode* node = find({PhaserClass::Context, context});
    return builder_.name(node == nullptr ? context : name_of(*node));
}

void PhaserRecord::read(const PhaserNode& node) {
    switch (node.kind) {
    case PhaserClass::Context: read_context(node); return;
    case PhaserClass::Dating: read_dating(node); return;
    case PhaserClass::Period: {
        const Years years = years_of(node);
        model::Period& period = builder_.record.periods.emplace_back();
        period.number = name_of(node);
        period.title = node.description;
        period.description = node.uri;
        period.from = years.from;
        period.to = years.to;
        return;
    }
    case PhaserClass::Phase: {
        const Years years = years_of(node);
        ImportedPhase& phase = builder_.record.phases.emplace_back();
        phase.values.number = name_of(node);
        phase.values.description = with_tolerance(node);
        phase.values.from = years.from;
        phase.values.to = years.to;
        if (const PhaserNode* period = container(node, PhaserClass::Period)) phase.period = name_of(*period);
        return;
    }
    case PhaserClass::Group:
    case PhaserClass::Subgroup: {
        const std::string number = name_of(node);
        const PhaserNode* outer = node.kind == PhaserClass::Subgroup ? container(node, PhaserClass::Group) : nullptr;
        const std::string parent = outer == nullptr ? std::string{} : name_of(*outer);
        ImportedGroup& group = builder_.group(number);
        group.values.type = node.kind == PhaserClass::Group ? "group" : "subgroup";
        group.values.title = node.type;
        group.values.description = node.description;
        group.parent = parent;
        return;
    }
    }
}

void PhaserRecord::read_context(const PhaserNode& node) {
    const UnitName name = unit_name(node.id);
    const Place place{node.file, node.line, node.id};
    if (name.number.empty()) {
        builder_.note(place, "unparsed", "a context without number; left out");
        return;
    }
    ImportedUnit& unit = builder_.unit(name, place);
    set_kind(unit, node.type);
    unit.values.description = node.description;
    if (name.number == "+" && unit.values.title.empty()) unit.values.title = "top of the sequence";
    add_custom_field(unit, "cud", node.cud);
    if (const PhaserNode* phase = container(node, PhaserClass::Phase)) unit.phase = name_of(*phase);
    if (const PhaserNode* period = container(node, PhaserClass::Period)) unit.period = name_of(*period);
    const PhaserNode* group = container(node, PhaserClass::Subgroup);
    if (group == nullptr) group = container(node, PhaserClass::Group);
    if (group != nullptr) builder_.add_member(name_of(*group), name);
    for (const PhaserKey& key : node.within) {
        if (find(key) != nullptr) continue;
        // Named, but its own table was not given.
        switch (key.first) {
        case PhaserClass::Period: unit.period = key.second; break;
        case PhaserClass::Phase: unit.phase = key.second; break;
        case PhaserClass::Group:
        case PhaserClass::Subgroup: builder_.add_member(key.second, name); break;
        case PhaserClass::Context:
        case PhaserClass::Dating: break;
        }
    }
}

void PhaserRecord::read_dating(const PhaserNode& node) {
    const Place place{node.file, node.line, node.id};
    const auto context = std::find_if(node.within.begin(), node.within.end(),
                                      [](const PhaserKey& key) { return key.first == PhaserClass::Context; });
    if (context == node.within.end()) {
        builder_.note(place, "empty-target", fmt::format("dating {} belongs to no context; left out", node.id));
        return;
    }
    const Years years = years_of(node);
    ImportedDating& dating = builder_.record.datings.emplace_back();
    dating.unit = unit_name(context->second);
    dating.values.label = fmt::format("{}{}{}", node.type, node.type.empty() ? "" : " ", name_of(node));
    dating.values.kind = dating_kind(node.type);
    dating.values.from = years.from;
    dating.values.to = years.to;
    dating.values.association = node.association;
    dating.values.notes = with_tolerance(node);
}

void PhaserRecord::read(const PhaserEdge& edge) {
    const std::string raw = fmt::format("{} {} {}", edge.source, edge.relation, edge.target);
    const Place place{edge.file, edge.line, raw};
    const auto kind = model::relation_from_any_word(edge.relation);
    if (!kind) {
        builder_.note(place, "unknown-relation",
                      fmt::format("\"{}\" is no relation; PHASER knows above, below and equal", edge.relation));
        return;
    }
    builder_.relate(unit_name(edge.source), *kind, unit_name(edge.target), place);
}

} // namespace planum::strat
