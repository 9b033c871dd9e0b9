// SPDX-License-Identifier: MIT
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/exchange/write_support.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using model::UnitKind;

// A quoted identifier of the DOT language: only the quote needs a backslash, which itself must not end
// the text.
std::string quoted(std::string_view text) {
    std::string out = text::replace_all(text, "\\", "\\\\");
    out = text::replace_all(out, "\"", "\\\"");
    return "\"" + text::replace_all(out, "\n", "\\n") + "\"";
}

std::string_view attributes_of(UnitKind kind) {
    switch (kind) {
    case UnitKind::Cut: return "shape=\"invtrapezium\"";
    case UnitKind::Interface: return "shape=\"box\", style=\"rounded\"";
    case UnitKind::Skeleton: return "shape=\"ellipse\"";
    case UnitKind::Feature: return "shape=\"octagon\"";
    case UnitKind::Unknown:
    case UnitKind::Deposit:
    case UnitKind::Structure:
    case UnitKind::Natural:
    case UnitKind::Void: return "shape=\"box\"";
    }
    return "shape=\"box\"";
}

std::string_view style_of(RelationKind kind) {
    switch (kind) {
    case RelationKind::Covers:
    case RelationKind::Cuts:
    case RelationKind::Fills:
    case RelationKind::Abuts: return "";
    case RelationKind::Later: return ", style=\"dashed\"";
    case RelationKind::SameAs: return ", dir=\"none\", constraint=\"false\", color=\"black:black\"";
    case RelationKind::BondsWith:
    case RelationKind::Contemporary: return ", dir=\"none\", constraint=\"false\", style=\"dashed\"";
    case RelationKind::Borders: return ", dir=\"none\", constraint=\"false\", style=\"dotted\"";
    }
    return "";
}

} // namespace

Written write_dot(const model::Record& record, const WriteOptions& /*options*/) {
    Carries carries;
    carries.kind = [](const model::StratigraphicUnit& unit) { return unit.form == model::UnitForm::None; };
    carries.title = true;
    carries.phases = true;
    carries.contact_kinds = carries.later = carries.same_as = carries.bonds = carries.contemporary = true;
    carries.borders = carries.certainty = true;
    Written written;
    written.lost = losses(record, carries);
    const RecordNames names(record);
    std::string out = fmt::format("digraph {} {{\n  node [shape=\"box\"];\n", quoted(record.settings.name));
    std::map<std::string, std::string, text::NaturalLess> by_phase;
    for (const model::StratigraphicUnit& unit : record.units) {
        by_phase[names.phase(unit.phase)] += fmt::format("  {} [{}, tooltip={}];\n", quoted(names.unit(unit.id)),
                                                         attributes_of(unit.kind), quoted(unit.title));
    }
    std::size_t cluster = 0;
    for (const auto& [phase, nodes] : by_phase) {
        out += phase.empty() ? nodes
                             : fmt::format("  subgraph \"cluster_{}\" {{\n  label={};\n{}  }}\n", cluster++,
                                           quoted(phase), nodes);
    }
    for (const std::size_t i : complete_relations(names)) {
        const model::PhysicalRelation& r = record.relations[i];
        out += fmt::format("  {} -> {} [class=\"{}\"{}{}];\n", quoted(names.unit(r.subject)),
                           quoted(names.unit(r.object)), model::to_word(r.kind), style_of(r.kind),
                           r.certainty == model::Certainty::Uncertain ? ", label=\"?\"" : "");
    }
    out += "}\n";
    written.files.push_back({{}, std::move(out)});
    return written;
}

} // namespace planum::strat
