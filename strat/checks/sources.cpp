// SPDX-License-Identifier: MIT
#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::Severity;

struct Reciprocity {
    std::int64_t both = 0;
    std::vector<RelationIndex> one_sided; ///< whose other unit has a sheet of its own
    std::int64_t relations = 0;
};

// Of one relation: from which sheets each source states it.
void count_relation(const CheckContext& c, RelationIndex r,
                    std::unordered_map<model::SourceId, Reciprocity>& by_source) {
    const auto& statements = c.record.statements;

    struct Sides {
        model::SourceId source;
        bool subject = false;
        bool object = false;
    };

    std::vector<Sides> sides;
    for (std::uint32_t s = c.statement_begin[r]; s < c.statement_begin[r + 1]; ++s) {
        if (statements[s].relation != c.record.relations[r].id) continue;
        if (statements[s].side == model::StatementSide::Neither || statements[s].source.is_nil()) continue;
        auto it =
            std::find_if(sides.begin(), sides.end(), [&](const Sides& x) { return x.source == statements[s].source; });
        if (it == sides.end()) it = sides.insert(sides.end(), Sides{statements[s].source});
        (statements[s].side == model::StatementSide::Subject ? it->subject : it->object) = true;
    }
    for (const Sides& x : sides) {
        Reciprocity& count = by_source[x.source];
        ++count.relations;
        if (x.subject && x.object) {
            ++count.both;
            continue;
        }
        // The sheet that stays silent must exist for silence to mean anything.
        const UnitIndex silent = x.subject ? c.object[r] : c.subject[r];
        if (!c.is_mentioned(silent) && !c.is_void(silent)) count.one_sided.push_back(r);
    }
}

void add_missing_reciprocals(const CheckContext& c, Findings& findings) {
    std::unordered_map<model::SourceId, Reciprocity> by_source;
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (c.known(r) && c.subject[r] != c.object[r]) count_relation(c, r, by_source);
    }
    for (const model::Source& source : c.record.sources) {
        const auto it = by_source.find(source.id);
        if (it == by_source.end() || it->second.one_sided.empty()) continue;
        const Reciprocity& count = it->second;
        if (2 * count.both < count.relations) continue;
        std::vector<std::string> examples;
        for (std::size_t i = 0; i < std::min<std::size_t>(count.one_sided.size(), 3); ++i) {
            examples.push_back(c.sentence(count.one_sided[i]));
        }
        const std::size_t lone = count.one_sided.size();
        auto d = make_diagnostic(
            Severity::Warning, "missing-reciprocal",
            lone == 1 ? fmt::format("{}: one of {} relations stands on one of the two sheets only: {}", source.name,
                                    count.relations, examples.front())
                      : fmt::format("{}: {} of {} relations stand on one of the two sheets only, among them: {}",
                                    source.name, lone, count.relations, list_names(examples, 3)));
        d.evidence["source"] = source.name;
        d.evidence["count"] = static_cast<std::int64_t>(count.one_sided.size());
        d.evidence["of"] = count.relations;
        d.relations.reserve(count.one_sided.size());
        for (const RelationIndex r : count.one_sided) d.relations.push_back(c.named(r));
        findings.push_back(std::move(d));
    }
}

// A source that has no sheets at all, only pairs, leaves nothing dangling.
void add_dangling(const CheckContext& c, Findings& findings) {
    const auto& units = c.record.units;
    const bool any_sheet = std::any_of(units.begin(), units.end(), [](const model::StratigraphicUnit& u) {
        return u.origin == model::UnitOrigin::Recorded;
    });
    if (!any_sheet) return;
    for (UnitIndex u = 0; u < units.size(); ++u) {
        if (!c.is_mentioned(u) || c.is_void(u) || c.relations_of(u).empty()) continue;
        std::vector<std::string> where;
        auto d = make_diagnostic(Severity::Warning, "dangling-unit", {});
        for (const RelationIndex r : c.relations_of(u)) {
            where.push_back(c.sentence(r));
            d.relations.push_back(c.named(r));
        }
        d.message =
            fmt::format("{} is named in a relation ({}) but has no sheet of its own", c.name(u), list_names(where, 2));
        d.units = {units[u].id};
        findings.push_back(std::move(d));
    }
}

void add_unparsed(const CheckContext& c, Findings& findings) {
    std::unordered_map<model::SourceId, std::string_view> names;
    for (const model::Source& source : c.record.sources) names.emplace(source.id, source.name);
    for (const model::ImportNote& note : c.record.import_notes) {
        const auto it = names.find(note.source);
        const std::string file{it == names.end() ? std::string_view{"?"} : it->second};
        const std::string place = note.line > 0 ? fmt::format("{}:{}", file, note.line) : file;
        auto d = make_diagnostic(Severity::Warning, "unparsed", fmt::format("{}: {}", place, note.message));
        d.evidence["file"] = file;
        d.evidence["line"] = note.line;
        d.evidence["note"] = note.code;
        d.evidence["text"] = note.raw_text;
        findings.push_back(std::move(d));
    }
}

void add_isolated(const CheckContext& c, Findings& findings) {
    if (!c.options.with_infos) return;
    for (UnitIndex u = 0; u < c.record.units.size(); ++u) {
        if (c.is_void(u) || c.is_mentioned(u)) continue;
        const NodeIndex node = c.matrix.node_of(u);
        if (!c.matrix.orders_above(node).empty() || !c.matrix.orders_below(node).empty()) continue;
        auto d = make_diagnostic(Severity::Info, "isolated-unit",
                                 fmt::format("{} stands in no order to any other unit", c.name(u)));
        d.units = {c.unit(u).id};
        findings.push_back(std::move(d));
    }
}

} // namespace

void check_sources(const CheckContext& context, Findings& findings) {
    add_missing_reciprocals(context, findings);
    add_dangling(context, findings);
    add_unparsed(context, findings);
    add_isolated(context, findings);
}

} // namespace planum::strat
