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

namespace {

struct Parts {
    std::string_view first;
    std::string_view kind;
    std::string_view last;
};

std::vector<std::string_view> words_of(std::string_view sentence) {
    std::vector<std::string_view> words;
    for (const std::string_view word : text::split(sentence, ' ')) {
        if (!word.empty()) words.push_back(word);
    }
    return words;
}

// The text between two words of one sentence, both included, with whatever blanks are inside.
std::string_view from_to(std::string_view first, std::string_view last) {
    return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

// Names of units may hold blanks (`eastern wall of 12`): of all divisions into name, relation and name the first
// whose three parts are all known; else the one with names of one word, for what is said about it.
Parts parts_of(Project& project, const std::vector<std::string_view>& words) {
    const std::size_t n = words.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const std::string_view first = from_to(words.front(), words[i - 1]);
        if (project.index().named(first).empty()) continue;
        for (std::size_t j = i + 1; j < n; ++j) {
            const std::string_view kind = from_to(words[i], words[j - 1]);
            const std::string_view last = from_to(words[j], words.back());
            if (model::relation_from_any_word(kind) && !project.index().named(last).empty()) return {first, kind, last};
        }
    }
    return {words.front(), from_to(words[1], words[n - 2]), words.back()};
}

} // namespace

SaidRelation parse_relation(Project& project, std::string_view sentence) {
    const std::vector<std::string_view> words = words_of(text::trim(sentence));
    if (words.size() < 3) {
        throw Error(ErrorCode::Usage,
                    fmt::format("a relation is UNIT RELATION UNIT, as in 1042 cuts 1017, not {}", sentence));
    }
    const Parts parts = parts_of(project, words);
    const auto meaning = model::relation_from_any_word(parts.kind);
    if (!meaning) {
        throw Error(
            ErrorCode::BadInput,
            fmt::format("{} is no relation; known are covers, cuts, fills, abuts (and covered by, …), bonds_with, "
                        "same_as, borders, later, earlier, contemporary, in English, German, Italian and French",
                        parts.kind));
    }
    const model::UnitIndex a = project.unit_named(parts.first);
    return said_relation(project.record(), a, *meaning, project.unit_named(parts.last));
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
