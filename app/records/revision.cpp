// SPDX-License-Identifier: MIT
#include "app/records/revision.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

using model::PhysicalRelation;

namespace {

PhysicalRelation living(Project& project, model::RelationId id) {
    for (const PhysicalRelation& relation : project.record().relations) {
        if (relation.id == id) return relation;
    }
    throw Error(ErrorCode::NotFound, "the relation is not in the record any more");
}

std::string sentence(Project& project, const PhysicalRelation& relation) {
    return fmt::format("{} {} {}", project.index().name(relation.subject), to_word(relation.kind),
                       project.index().name(relation.object));
}

std::string reason(std::string_view because) {
    const std::string_view trimmed = text::trim(because);
    if (trimmed.empty()) throw Error(ErrorCode::Usage, "a correction needs a reason");
    return std::string(trimmed);
}

// Inside a change: who corrected what, how and why.
void note_decision(Project& project, const std::string& subject, const char* verdict, const std::string& because) {
    model::Decision decision;
    decision.subject_id = subject;
    decision.kind = "revision";
    decision.verdict = verdict;
    decision.because = because;
    decision.author = project.author();
    decision.made_at = project.clock().now();
    project.file().insert(decision);
}

// Inside a change: the statement, and the relation where there is none of that form yet.
void state(Project& project, const std::vector<PhysicalRelation>& existing, PhysicalRelation relation,
           model::StatementSide side, const std::string& as_written) {
    model::RelationStatement statement;
    statement.side = side;
    statement.person = project.author();
    statement.raw_text = as_written;
    statement.stated_at = project.clock().now();
    for (const PhysicalRelation& other : existing) {
        if (other.subject == relation.subject && other.kind == relation.kind && other.object == relation.object) {
            statement.relation = other.id;
        }
    }
    if (statement.relation.is_nil()) {
        relation.id = {};
        statement.relation = project.file().insert(relation);
    }
    project.file().insert(statement);
}

} // namespace

void withdraw_relation(Project& project, model::RelationId id, std::string_view because) {
    const std::string why = reason(because);
    const std::string what = sentence(project, living(project, id));
    project.change(fmt::format("Withdraw {}: {}", what, why), [&] {
        project.file().remove(id);
        note_decision(project, id.to_string(), "withdrawn", why);
    });
}

void mark_uncertain(Project& project, model::RelationId id, std::string_view because) {
    const std::string why = reason(because);
    PhysicalRelation relation = living(project, id);
    relation.certainty = model::Certainty::Uncertain;
    project.change(fmt::format("Mark {} uncertain: {}", sentence(project, relation), why), [&] {
        project.file().update(relation);
        note_decision(project, id.to_string(), "uncertain", why);
    });
}

void replace_relation(Project& project, model::RelationId id, const SaidRelation& instead, std::string_view because) {
    const std::string why = reason(because);
    const PhysicalRelation old = living(project, id);
    PhysicalRelation fresh = old;
    fresh.subject = instead.subject;
    fresh.kind = instead.kind;
    fresh.object = instead.object;
    if (fresh.subject == old.subject && fresh.kind == old.kind && fresh.object == old.object) {
        throw Error(ErrorCode::Usage, "that is the relation as it stands");
    }
    const std::string written = fmt::format("{}, instead of {}", sentence(project, fresh), sentence(project, old));
    const std::vector<PhysicalRelation> existing = project.record().relations;
    project.change(fmt::format("Correct to {}: {}", written, why), [&] {
        project.file().remove(id);
        state(project, existing, fresh, instead.side, written);
        note_decision(project, id.to_string(), "replaced", why);
    });
}

model::UnitId split_unit(Project& project, model::UnitId unit, std::string_view number,
                         const std::vector<model::RelationId>& moved, std::string_view because) {
    const std::string why = reason(because);
    const model::UnitIndex at = project.index().find(unit);
    if (at == model::kNoUnit) throw Error(ErrorCode::NotFound, "the unit is not in the record any more");
    model::StratigraphicUnit half = project.record().units[at];
    half.id = {};
    half.number = std::string(text::trim(number));
    if (half.number.empty()) throw Error(ErrorCode::BadInput, "the new unit needs a number");
    std::vector<PhysicalRelation> taken;
    taken.reserve(moved.size());
    for (const model::RelationId id : moved) taken.push_back(living(project, id));
    const std::vector<PhysicalRelation> existing = project.record().relations;
    const std::string old_name = project.index().name(unit);
    project.change(fmt::format("Split unit {}, new {}: {}", old_name, half.number, why), [&] {
        half.id = project.file().insert(half);
        for (const PhysicalRelation& relation : taken) {
            PhysicalRelation fresh = relation;
            if (fresh.subject == unit) fresh.subject = half.id;
            if (fresh.object == unit) fresh.object = half.id;
            project.file().remove(relation.id);
            state(project, existing, fresh, model::StatementSide::Neither,
                  fmt::format("taken over from unit {} when it was split", old_name));
            note_decision(project, relation.id.to_string(), "replaced", why);
        }
        note_decision(project, unit.to_string(), "split", why);
    });
    return half.id;
}

} // namespace planum::app
