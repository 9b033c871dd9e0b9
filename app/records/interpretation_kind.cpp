// SPDX-License-Identifier: MIT
#include "app/records/field_table.hpp"

#include <algorithm>

#include "app/checks/daily_check.hpp"
#include "app/records/relation_entry.hpp"

namespace planum::app {

using model::Interpretation;
using model::PhysicalRelation;

namespace {

std::string sentence(const PhysicalRelation& relation, Project& project) {
    return fmt::format("{} {} {}", project.index().name(relation.subject), to_word(relation.kind),
                       project.index().name(relation.object));
}

bool says(const PhysicalRelation& relation, const SaidRelation& said) {
    return relation.subject == said.subject && relation.kind == said.kind && relation.object == said.object;
}

// `1 covers 2; 3 cuts 4`
std::vector<SaidRelation> sentences(Project& project, const std::string& text) {
    std::vector<SaidRelation> all;
    for (const std::string_view part : text::split(text, ';')) {
        if (!text::trim(part).empty()) all.push_back(parse_relation(project, text::trim(part)));
    }
    return all;
}

const Interpretation* with_id(const model::Record& record, model::InterpretationId id) {
    const auto it = std::find_if(record.interpretations.begin(), record.interpretations.end(),
                                 [&](const Interpretation& other) { return other.id == id; });
    return it == record.interpretations.end() ? nullptr : &*it;
}

/// The relations of the reading that this one starts from.
std::vector<PhysicalRelation> inherited(Project& project, const Interpretation& reading) {
    const Interpretation* parent = with_id(project.record(), reading.parent);
    return interpreted(project.record(), parent == nullptr ? std::string{} : parent->name).relations;
}

void add_to(Interpretation& reading, const std::string& text, Project& project) {
    const std::vector<PhysicalRelation> there = inherited(project, reading);
    for (const SaidRelation& said : sentences(project, text)) {
        const auto is_it = [&](const PhysicalRelation& relation) { return says(relation, said); };
        if (std::any_of(reading.added.begin(), reading.added.end(), is_it)) continue;
        if (const auto it = std::find_if(there.begin(), there.end(), is_it); it != there.end()) {
            // What the parent says already was dropped here or needs no adding.
            std::erase(reading.dropped, it->id);
            continue;
        }
        PhysicalRelation relation;
        relation.id = model::RelationId{project.uuids().next()};
        relation.subject = said.subject;
        relation.kind = said.kind;
        relation.object = said.object;
        reading.added.push_back(relation);
    }
}

void drop_from(Interpretation& reading, const std::string& text, Project& project) {
    const std::vector<PhysicalRelation> there = inherited(project, reading);
    for (const SaidRelation& said : sentences(project, text)) {
        const auto is_it = [&](const PhysicalRelation& relation) { return says(relation, said); };
        if (std::erase_if(reading.added, is_it) > 0) continue;
        const auto it = std::find_if(there.begin(), there.end(), is_it);
        if (it == there.end()) {
            throw Error(ErrorCode::NotFound, fmt::format("drops: no relation {} {} {} in what the interpretation is of",
                                                         project.index().name(said.subject), to_word(said.kind),
                                                         project.index().name(said.object)));
        }
        if (std::find(reading.dropped.begin(), reading.dropped.end(), it->id) == reading.dropped.end()) {
            reading.dropped.push_back(it->id);
        }
    }
}

std::string added(const Interpretation& reading, Project& project) {
    std::vector<std::string> all;
    all.reserve(reading.added.size());
    for (const PhysicalRelation& relation : reading.added) all.push_back(sentence(relation, project));
    return text::join(all, "; ");
}

std::string dropped(const Interpretation& reading, Project& project) {
    std::vector<std::string> all;
    for (const PhysicalRelation& relation : inherited(project, reading)) {
        const auto& ids = reading.dropped;
        if (std::find(ids.begin(), ids.end(), relation.id) != ids.end()) all.push_back(sentence(relation, project));
    }
    return text::join(all, "; ");
}

void set_parent(Interpretation& reading, const std::string& name, Project& project) {
    reading.parent = {};
    if (name.empty()) return;
    const auto& all = project.record().interpretations;
    const auto it = std::find_if(all.begin(), all.end(), [&](const auto& other) { return other.name == name; });
    if (it == all.end()) {
        throw Error(ErrorCode::NotFound, fmt::format("parent: there is no interpretation {}; add it first", name));
    }
    for (const Interpretation* ancestor : lineage(project.record(), name)) {
        if (ancestor->id == reading.id) {
            throw Error(ErrorCode::BadInput, fmt::format("parent: {} is read from {} itself", name, reading.name));
        }
    }
    reading.parent = it->id;
}

std::vector<Field<Interpretation>> interpretation_fields() {
    using I = Interpretation;
    std::vector<Field<I>> fields;
    fields.push_back({{"parent", "the interpretation it starts from (default: the field record)"},
                      [](const I& reading, Project& project) {
                          const I* parent = with_id(project.record(), reading.parent);
                          return parent == nullptr ? std::string{} : parent->name;
                      },
                      set_parent});
    fields.push_back(
        {{"adds", "relations it adds, as in \"1 covers 2; 3 cuts 4\"; set adds to those there"}, added, add_to});
    fields.push_back(
        {{"drops", "relations it leaves out; set adds to those there; \"adds\" brings one back"}, dropped, drop_from});
    fields.push_back(text_field<I>("author", "who reads it so (default: you)", &I::author));
    return fields;
}

class InterpretationKind final : public NamedKind<Interpretation> {
  public:
    InterpretationKind()
        : NamedKind("interpretation", &model::Record::interpretations, &Interpretation::name, interpretation_fields()) {
    }

    void remove(Project& project, const std::string& name) const override {
        const model::InterpretationId id = find(project, name).id;
        for (const Interpretation& other : project.record().interpretations) {
            if (other.parent != id) continue;
            throw Error(ErrorCode::Conflict, fmt::format("interpretation {}: {} starts from it; give that another "
                                                         "parent or delete it first",
                                                         name, other.name));
        }
        NamedKind::remove(project, name);
    }

  protected:
    [[nodiscard]] Interpretation make(Project& project, const std::string& name) const override {
        Interpretation reading = NamedKind::make(project, name);
        reading.author = project.author();
        reading.made_at = project.clock().now();
        return reading;
    }
};

} // namespace

void add_interpretation_kind(std::vector<std::unique_ptr<RecordKind>>& kinds) {
    kinds.push_back(std::make_unique<InterpretationKind>());
}

} // namespace planum::app
