// SPDX-License-Identifier: MIT
#include "app/suggestions/suggestions.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/evidence/section_evidence.hpp"
#include "app/scans/days_surface.hpp"
#include "app/suggestions/reasons.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/base/text.hpp"
#include "scans/surface/questions.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

using model::Suggestion;
using model::SuggestionState;
using model::SuggestionType;

namespace {

constexpr std::size_t kIdDigits = 12;

// With the area wherever there is one, so that another area with the same numbers changes no id.
std::string full_name(const model::Record& record, const model::RecordIndex& index, model::UnitId id) {
    const model::StratigraphicUnit& unit = record.units[index.find(id)];
    for (const model::Area& area : record.areas) {
        if (area.id == unit.area) return area.name + "::" + unit.number;
    }
    return unit.number;
}

std::string id_of(const model::Record& record, const model::RecordIndex& index, const Suggestion& s) {
    const std::string what = s.type == SuggestionType::Question ? "question" : std::string(to_word(s.kind));
    return sha256(fmt::format("suggestion\n{}\n{}\n{}", what, full_name(record, index, s.unit),
                              full_name(record, index, s.other)))
        .substr(0, kIdDigits);
}

const model::Decision* last_decision(const model::Record& record, const std::string& id) {
    const model::Decision* last = nullptr;
    for (const model::Decision& decision : record.decisions) {
        if (decision.kind != "suggestion" || decision.subject_id != id) continue;
        if (last == nullptr || decision.made_at >= last->made_at) last = &decision;
    }
    return last;
}

// What surfaces are sure of is sure; levels less, thin units and areas near the limit least.
double confidence_of(const scans::Conclusion& c) {
    if (c.is_question) return 0.0;
    int percent = c.source == model::EvidenceSource::Levels ? 85 : 95;
    if (c.thin) percent -= 25;
    if (c.area < 0.1) percent -= 15;
    return percent / 100.0;
}

// Whether the record itself orders the two, over whatever path.
class RecordedOrder {
  public:
    explicit RecordedOrder(const model::Record& record) : index_(record), matrix_(strat::HarrisMatrix::build(record)) {
        below_.resize(matrix_.node_count());
        for (const auto& order : matrix_.orders()) below_[order.later].push_back(order.earlier);
    }

    [[nodiscard]] bool is_above(model::UnitId a, model::UnitId b) const {
        return reached_from(matrix_.node_of(index_.find(a)))[matrix_.node_of(index_.find(b))] != 0;
    }

    /// All orders between these units, by number, over whatever path.
    [[nodiscard]] std::vector<scans::KnownOrder> among(std::span<const scans::KnownUnit> units) const {
        std::vector<strat::NodeIndex> nodes;
        for (const scans::KnownUnit& unit : units) nodes.push_back(matrix_.node_of(index_.find(unit.id)));
        std::vector<scans::KnownOrder> known;
        for (std::size_t u = 0; u < nodes.size(); ++u) {
            const std::vector<char> reached = reached_from(nodes[u]);
            for (std::size_t v = 0; v < nodes.size(); ++v) {
                if (u != v && reached[nodes[v]] != 0)
                    known.push_back({static_cast<scans::UnitNumber>(u), static_cast<scans::UnitNumber>(v)});
            }
        }
        return known;
    }

  private:
    // Itself and all that is earlier, by node.
    [[nodiscard]] std::vector<char> reached_from(strat::NodeIndex from) const {
        std::vector<char> seen(below_.size(), 0);
        std::vector<strat::NodeIndex> waiting = {from};
        while (!waiting.empty()) {
            const strat::NodeIndex at = waiting.back();
            waiting.pop_back();
            if (std::exchange(seen[at], 1) != 0) continue;
            waiting.insert(waiting.end(), below_[at].begin(), below_[at].end());
        }
        return seen;
    }

    model::RecordIndex index_;
    strat::HarrisMatrix matrix_;
    std::vector<std::vector<strat::NodeIndex>> below_;
};

// The record has the relation; where only the order is proposed, any path will do, unless another one says the
// opposite: in a cycle everything lies above everything, and what surfaces show is needed most.
bool is_recorded(const model::Record& record, const RecordedOrder& recorded, const Suggestion& s) {
    const bool stated =
        std::any_of(record.relations.begin(), record.relations.end(), [&](const model::PhysicalRelation& r) {
            return r.subject == s.unit && r.object == s.other && r.kind == s.kind;
        });
    if (stated || s.kind != model::RelationKind::Later) return stated;
    return recorded.is_above(s.unit, s.other) && !recorded.is_above(s.other, s.unit);
}

SuggestionState state_of(const model::Record& record, const RecordedOrder& recorded, const Suggestion& s) {
    const model::Decision* decision = last_decision(record, s.id);
    // Half as much again is new evidence.
    const bool holds = decision != nullptr && s.area <= 1.5 * decision->area;
    if (holds && decision->verdict == "rejected") return SuggestionState::Rejected;
    if (s.type == SuggestionType::Relation && is_recorded(record, recorded, s)) {
        return decision != nullptr && decision->verdict == "accepted" ? SuggestionState::Accepted
                                                                      : SuggestionState::Recorded;
    }
    return SuggestionState::Open;
}

Suggestion suggestion_of(const model::Record& record, const model::RecordIndex& index, const RecordedOrder& recorded,
                         const AreaEvidence& area, const scans::Conclusion& c) {
    Suggestion s;
    s.type = c.is_question ? SuggestionType::Question : SuggestionType::Relation;
    s.unit = area.units[static_cast<std::size_t>(c.unit)].id;
    s.other = area.units[static_cast<std::size_t>(c.other)].id;
    s.kind = c.kind;
    s.direct = c.direct;
    s.source = c.source;
    s.confidence = confidence_of(c);
    s.area = c.area;
    s.thickness = c.thickness;
    s.surfaces = {area.surfaces[c.from], area.surfaces[c.to]};
    s.reason = reason_of(record, index, area, c);
    s.id = id_of(record, index, s);
    s.state = state_of(record, recorded, s);
    if (s.type == SuggestionType::Relation && s.state == SuggestionState::Open && recorded.is_above(s.other, s.unit)) {
        const std::string unit = index.name(s.unit);
        const std::string other = index.name(s.other);
        s.reason += recorded.is_above(s.unit, s.other)
                        ? fmt::format("; the record has {} above {} and {} above {}: one of the two is wrong", unit,
                                      other, other, unit)
                        : fmt::format("; the record puts {} above {}: one of the two is wrong", other, unit);
    }
    return s;
}

// Of a section: a relation, or a question that the record does not answer.
std::optional<Suggestion> suggestion_of(const model::Record& record, const model::RecordIndex& index,
                                        const RecordedOrder& recorded, const SectionEvidence& evidence) {
    Suggestion s;
    s.type = evidence.verdict.why == scans::SectionVerdict::Why::LiesOn ? SuggestionType::Relation
                                                                        : SuggestionType::Question;
    s.unit = evidence.upper;
    s.other = evidence.lower;
    s.kind = evidence.verdict.kind;
    s.direct = evidence.verdict.direct;
    s.source = model::EvidenceSource::Section;
    s.confidence = s.type == SuggestionType::Relation ? 0.95 : 0.0;
    s.area = kSectionStrip * evidence.contact.length;
    s.reason = reason_of(record, index, evidence);
    s.id = id_of(record, index, s);
    s.state = state_of(record, recorded, s);
    if (s.type == SuggestionType::Question &&
        (recorded.is_above(s.unit, s.other) || recorded.is_above(s.other, s.unit))) {
        return std::nullopt;
    }
    return s;
}

// What levels say of a pair that a section shows does not count.
void add_sections(const model::Record& record, const model::RecordIndex& index, std::vector<Suggestion>& all) {
    const std::vector<SectionEvidence> sections = section_evidence(record);
    if (sections.empty()) return;
    const RecordedOrder recorded(record);
    std::vector<SectionEvidence> speaking = proven_by_sections(sections);
    for (const SectionEvidence& one : sections) {
        if (one.verdict.why == scans::SectionVerdict::Why::ReachesBelow) speaking.push_back(one);
    }
    const auto same_pair = [](const Suggestion& s, const SectionEvidence& one) {
        return (s.unit == one.upper && s.other == one.lower) || (s.unit == one.lower && s.other == one.upper);
    };
    for (const SectionEvidence& one : speaking) {
        const bool proves = one.verdict.why == scans::SectionVerdict::Why::LiesOn;
        std::erase_if(all, [&](const Suggestion& s) {
            return proves && same_pair(s, one) && s.state == SuggestionState::Open &&
                   (s.source == model::EvidenceSource::Levels || s.type == SuggestionType::Question);
        });
        const bool said = std::any_of(all.begin(), all.end(), [&](const Suggestion& s) { return same_pair(s, one); });
        if (said) continue;
        if (auto s = suggestion_of(record, index, recorded, one)) all.push_back(std::move(*s));
    }
}

std::vector<Suggestion> open_ones(Project& project, std::span<const std::string> ids, Progress& progress) {
    const std::vector<Suggestion> all = list_suggestions(project, progress).suggestions;
    std::vector<Suggestion> chosen;
    for (const std::string& id : ids) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Suggestion& s) {
            return s.id == id && s.state == SuggestionState::Open;
        });
        if (found == all.end()) {
            throw Error(ErrorCode::NotFound,
                        fmt::format("no open suggestion has the id {}; planum suggest lists them", id));
        }
        chosen.push_back(*found);
    }
    return chosen;
}

model::Decision decision_on(Project& project, const Suggestion& s, std::string verdict, std::string because) {
    model::Decision decision;
    decision.subject_id = s.id;
    decision.kind = "suggestion";
    decision.verdict = std::move(verdict);
    decision.because = std::move(because);
    decision.area = s.area;
    decision.author = project.author();
    decision.made_at = project.clock().now();
    return decision;
}

model::PhysicalRelation relation_of(const Suggestion& s) {
    model::PhysicalRelation relation;
    relation.subject = s.unit;
    relation.kind = s.kind;
    relation.object = s.other;
    return relation;
}

} // namespace

std::vector<Suggestion> suggestions_from(Project& project, const std::vector<AreaEvidence>& evidence) {
    const model::Record& record = project.record();
    std::vector<Suggestion> all;
    if (evidence.empty() && record.sections.empty()) return all;
    const RecordedOrder recorded(record);
    for (const AreaEvidence& area : evidence) {
        std::vector<scans::Conclusion> conclusions = area.conclusions;
        scans::keep_useful_questions(conclusions, area.units.size(), recorded.among(area.units));
        for (const scans::Conclusion& c : conclusions)
            all.push_back(suggestion_of(record, project.index(), recorded, area, c));
    }
    add_sections(record, project.index(), all);
    const auto rank = [](const Suggestion& s) {
        return std::tuple(s.state != SuggestionState::Open, s.type == SuggestionType::Question, -s.area);
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Suggestion& a, const Suggestion& b) { return rank(a) < rank(b); });
    return all;
}

SuggestionList list_suggestions(Project& project, Progress& progress) {
    SuggestionList list;
    const std::vector<AreaEvidence> evidence = gather_evidence(project, progress);
    list.suggestions = suggestions_from(project, evidence);
    const model::Record& record = project.record();
    for (const AreaEvidence& area : evidence) {
        const std::size_t seen = area.surfaces.size() - std::min(area.surfaces.size(), area.unseen.size());
        list.compared += seen - std::min<std::size_t>(seen, 1);
        list.without_kind += static_cast<std::size_t>(
            std::count_if(area.units.begin(), area.units.end(),
                          [](const scans::KnownUnit& unit) { return unit.kind == model::UnitKind::Unknown; }));
        for (const UnseenSurface& unseen : area.unseen) {
            const auto surface = std::find_if(record.surfaces.begin(), record.surfaces.end(),
                                              [&](const model::Surface& one) { return one.id == unseen.surface; });
            list.unused.push_back({surface_name(record, *surface), unseen.why});
        }
    }
    return list;
}

bool concerns_day(const model::Record& record, const Suggestion& suggestion, std::string_view day) {
    return std::any_of(record.surfaces.begin(), record.surfaces.end(), [&](const model::Surface& surface) {
        return std::find(suggestion.surfaces.begin(), suggestion.surfaces.end(), surface.id) !=
                   suggestion.surfaces.end() &&
               holds_day(surface, day);
    });
}

void accept_suggestions(Project& project, std::span<const std::string> ids, Progress& progress) {
    const std::vector<Suggestion> chosen = open_ones(project, ids, progress);
    for (const Suggestion& s : chosen) {
        if (s.type == SuggestionType::Question) {
            throw Error(ErrorCode::Conflict, fmt::format("{} is a question; state what you saw with planum relation "
                                                         "add, or --reject it",
                                                         s.id));
        }
    }
    project.change(fmt::format("Accept {} from surfaces", chosen.size() == 1 ? "a relation" : "relations"), [&] {
        for (const Suggestion& s : chosen) {
            model::RelationStatement statement;
            statement.relation = project.file().insert(relation_of(s));
            statement.side = model::StatementSide::Neither;
            statement.person = project.author();
            statement.raw_text = s.reason;
            statement.stated_at = project.clock().now();
            project.file().insert(statement);
            project.file().insert(decision_on(project, s, "accepted", s.reason));
        }
    });
}

void reject_suggestions(Project& project, std::span<const std::string> ids, std::string_view because,
                        Progress& progress) {
    const std::string reason{text::trim(because)};
    if (reason.empty()) throw Error(ErrorCode::Usage, "a suggestion is rejected with a reason: --because TEXT");
    const std::vector<Suggestion> chosen = open_ones(project, ids, progress);
    project.change(fmt::format("Reject {}", chosen.size() == 1 ? "a suggestion" : "suggestions"), [&] {
        for (const Suggestion& s : chosen) project.file().insert(decision_on(project, s, "rejected", reason));
    });
}

std::size_t compile_interpretation(Project& project, const std::string& name, Progress& progress) {
    const auto& existing = project.record().interpretations;
    if (std::any_of(existing.begin(), existing.end(), [&](const auto& i) { return i.name == name; })) {
        throw Error(ErrorCode::Conflict, fmt::format("there is an interpretation {} already; choose another name, "
                                                     "or delete it with planum interpretation delete",
                                                     name));
    }
    model::Interpretation compiled;
    compiled.name = name;
    compiled.author = project.author();
    compiled.made_at = project.clock().now();
    const model::Record& record = project.record();
    std::set<model::RelationId> kept;
    for (const Suggestion& s : list_suggestions(project, progress).suggestions) {
        if (s.type != SuggestionType::Relation || s.state == SuggestionState::Rejected) continue;
        const auto known =
            std::find_if(record.relations.begin(), record.relations.end(), [&](const model::PhysicalRelation& r) {
                return r.subject == s.unit && r.kind == s.kind && r.object == s.other;
            });
        if (known != record.relations.end()) {
            kept.insert(known->id);
            continue;
        }
        compiled.added.push_back(relation_of(s));
        compiled.added.back().id = {project.uuids().next()};
    }
    const std::size_t count = compiled.added.size() + kept.size();
    if (count == 0) {
        throw Error(ErrorCode::Conflict, "the surfaces propose nothing; outlines on two surfaces of an area with "
                                         "registered scans are needed");
    }
    for (const model::PhysicalRelation& relation : record.relations) {
        if (!kept.contains(relation.id)) compiled.dropped.push_back(relation.id);
    }
    project.change("Make interpretation " + name, [&] { project.file().insert(compiled); });
    return count;
}

} // namespace planum::app
