// SPDX-License-Identifier: MIT
#include "strat/layout/inner_contradictions.hpp"

#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/layout/box_label.hpp"

namespace planum::strat {

namespace {

// Of a box with many, the first few say what is wrong.
constexpr std::size_t kMostNamed = 3;

std::vector<RelationIndex> removed_relations(const LayoutRequest& request) {
    std::set<std::pair<model::UnitId, model::UnitId>> removed;
    for (const OrderMark& m : request.options.order_marks) {
        if (m.mark == Mark::Removed) removed.insert({m.later, m.earlier});
    }
    std::vector<RelationIndex> relations;
    if (removed.empty()) return relations;
    for (std::size_t r = 0; r < request.record.relations.size(); ++r) {
        const model::PhysicalRelation& relation = request.record.relations[r];
        if (removed.contains({relation.subject, relation.object})) relations.push_back(static_cast<RelationIndex>(r));
    }
    return relations;
}

std::string said(const std::vector<std::string>& statements) {
    std::string words;
    for (std::size_t i = 0; i < statements.size() && i < kMostNamed; ++i) {
        words += (i > 0 ? ", " : "") + statements[i];
    }
    if (statements.size() > kMostNamed) words += fmt::format(" and {} more", statements.size() - kMostNamed);
    return words;
}

} // namespace

void mark_inner_contradictions(DrawnGraph& graph, const LayoutRequest& request, const Selection& selection) {
    const model::Record& record = request.record;
    const std::vector<RelationIndex> removed = removed_relations(request);
    std::optional<HarrisMatrix> without_removed;
    if (!removed.empty()) without_removed.emplace(HarrisMatrix::build(record, {.without = removed}));
    const HarrisMatrix& standing = without_removed ? *without_removed : request.matrix;

    const model::RecordIndex index(record);
    std::vector<std::vector<std::string>> statements(graph.boxes.size());
    auto next_removed = removed.begin();
    for (std::size_t r = 0; r < record.relations.size(); ++r) {
        if (next_removed != removed.end() && *next_removed == r) {
            ++next_removed;
            continue;
        }
        const model::PhysicalRelation& relation = record.relations[r];
        if (model::time_meaning(relation.kind) != model::TimeMeaning::SubjectLater) continue;
        const UnitIndex subject = index.find(relation.subject);
        const UnitIndex object = index.find(relation.object);
        if (subject == model::kNoUnit || object == model::kNoUnit) continue;
        const std::uint32_t box = selection.box_of[request.matrix.node_of(subject)];
        if (box == Selection::kLeftOut || box != selection.box_of[request.matrix.node_of(object)]) continue;
        const auto component = [&](UnitIndex unit) { return standing.component_of(standing.node_of(unit)); };
        if (component(subject) != component(object)) continue; // folded units one above the other
        statements[box].push_back(
            fmt::format("{} {} {}", index.name(subject), model::phrase(relation.kind), index.name(object)));
    }

    std::string sentence;
    for (std::size_t b = 0; b < graph.boxes.size(); ++b) {
        DrawnBox& box = graph.boxes[b].box;
        if (!statements[b].empty()) {
            box.title += "; contradiction: " + said(statements[b]);
            sentence += fmt::format("{}{}: {}", sentence.empty() ? " Contradictions inside a box: " : "; ",
                                    box.shape == BoxShape::Folded ? graph.boxes[b].name : text::join(box.names, " = "),
                                    said(statements[b]));
        } else if (!box.in_cycle) {
            for (const UnitIndex unit : graph.boxes[b].units) {
                const std::uint32_t component = standing.component_of(standing.node_of(unit));
                box.inner_cycle = box.inner_cycle || standing.component(component).size() > 1;
            }
            if (!box.inner_cycle) continue;
            box.title += "; in a cycle with units that are not drawn";
        } else {
            continue;
        }
        box.in_cycle = true;
        box.inner_cycle = true;
        size_box(box, request.text);
    }
    if (!sentence.empty()) graph.description += sentence + ".";
}

} // namespace planum::strat
