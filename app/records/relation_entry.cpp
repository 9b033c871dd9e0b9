// SPDX-License-Identifier: MIT
#include "app/records/relation_entry.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/checks/incremental.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

using model::StatementSide;

SaidRelation parse_relation(Project& project, std::string_view sentence) {
    std::vector<std::string> words;
    for (const std::string_view word : text::split(text::trim(sentence), ' ')) {
        if (!word.empty()) words.emplace_back(word);
    }
    if (words.size() < 3) {
        throw Error(ErrorCode::Usage,
                    fmt::format("a relation is UNIT RELATION UNIT, as in 1042 cuts 1017, not {}", sentence));
    }
    const std::string first = words.front();
    const std::string last = words.back();
    words.erase(words.begin());
    words.pop_back();
    const std::string said_kind = text::join(words, " ");
    const auto meaning = model::relation_from_any_word(said_kind);
    if (!meaning) {
        throw Error(
            ErrorCode::BadInput,
            fmt::format("{} is no relation; known are covers, cuts, fills, abuts (and covered by, …), bonds_with, "
                        "same_as, borders, later, earlier, contemporary, in English, German, Italian and French",
                        said_kind));
    }
    const model::UnitIndex a = project.unit_named(first);
    return said_relation(project.record(), a, *meaning, project.unit_named(last));
}

SaidRelation said_relation(const model::Record& record, model::UnitIndex a, model::DirectedKind kind,
                           model::UnitIndex b) {
    SaidRelation said;
    said.kind = kind.kind;
    if (kind.inverse) {
        std::swap(a, b);
        said.side = StatementSide::Object;
    }
    if (model::is_symmetric(said.kind) && text::natural_order(record.units[b].number, record.units[a].number) < 0) {
        std::swap(a, b);
        said.side = StatementSide::Object;
    }
    said.subject = record.units[a].id;
    said.object = record.units[b].id;
    return said;
}

std::string add_relation(Project& project, const RelationEntry& entry, std::string_view as_written) {
    const SaidRelation& said = entry.said;
    model::RelationStatement statement;
    statement.side = said.side;
    statement.person = project.author();
    statement.raw_text = std::string(as_written);
    statement.stated_at = project.clock().now();
    for (const model::PhysicalRelation& relation : project.record().relations) {
        if (relation.subject == said.subject && relation.kind == said.kind && relation.object == said.object) {
            statement.relation = relation.id;
        }
    }
    std::string name = fmt::format("{} {} {}", project.index().name(said.subject), to_word(said.kind),
                                   project.index().name(said.object));
    project.change("Add relation " + name, [&] {
        if (statement.relation.is_nil()) {
            model::PhysicalRelation relation;
            relation.subject = said.subject;
            relation.kind = said.kind;
            relation.object = said.object;
            relation.certainty = entry.certainty;
            relation.correlation = entry.correlation;
            statement.relation = project.file().insert(relation);
        }
        project.file().insert(statement);
    });
    return name;
}

namespace {

std::vector<model::UnitId> cycle_closed(const model::Record& record, const model::RecordIndex& index,
                                        const strat::HarrisMatrix& matrix, const SaidRelation& relation) {
    const auto prediction =
        strat::predict(matrix, {index.find(relation.subject), relation.kind, index.find(relation.object)});
    if (prediction.consequence == strat::Consequence::None) return {};
    std::vector<model::UnitId> cycle = {relation.subject};
    for (const std::uint32_t order : prediction.path) {
        const model::UnitId unit = record.units[matrix.members(matrix.orders()[order].later).front()].id;
        if (unit != cycle.back()) cycle.push_back(unit);
    }
    return cycle;
}

} // namespace

std::vector<model::UnitId> would_close_cycle(Project& project, const SaidRelation& relation) {
    const auto matrix = strat::HarrisMatrix::build(project.record());
    return cycle_closed(project.record(), project.index(), matrix, relation);
}

std::vector<model::UnitId> would_close_cycle(const Snapshot& snapshot, const SaidRelation& relation) {
    return cycle_closed(snapshot.record(), snapshot.index(), snapshot.matrix(), relation);
}

} // namespace planum::app
