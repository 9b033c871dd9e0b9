// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;

// Ground that stays standing while the rest goes down is dug out of sequence on purpose.
bool dug_in_parts(const model::StratigraphicUnit& unit) {
    if (unit.status == model::UnitStatus::PartlyExcavated) return true;
    const auto percent = unit.details.find("percent_excavated");
    if (percent != unit.details.end()) {
        const auto value = text::parse_double(percent->second);
        if (value && *value < 100.0) return true;
    }
    const std::string title = text::fold_case(unit.title);
    for (const std::string_view word : {"baulk", "balk", "profilsteg", "testimone", "berme"}) {
        if (title.find(word) != std::string::npos) return true;
    }
    return false;
}

} // namespace

bool dug_before(const model::StratigraphicUnit& earlier, const model::StratigraphicUnit& later) {
    const std::string& finished = earlier.excavated_on;
    const std::string& begun = later.excavated_from.empty() ? later.excavated_on : later.excavated_from;
    // ISO dates compare as text; anything shorter than a day proves nothing.
    return finished.size() >= 10 && begun.size() >= 10 && finished.substr(0, 10) < begun.substr(0, 10);
}

void check_digging(const CheckContext& c, Findings& findings) {
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        const RelationKind kind = c.record.relations[r].kind;
        if (kind != RelationKind::Covers && kind != RelationKind::Cuts && kind != RelationKind::Fills) continue;
        if (!c.known(r) || c.subject[r] == c.object[r]) continue;
        const model::StratigraphicUnit& above = c.unit(c.subject[r]);
        const model::StratigraphicUnit& below = c.unit(c.object[r]);
        if (!dug_before(below, above) || dug_in_parts(above) || dug_in_parts(below)) continue;
        const std::string& begun = above.excavated_from.empty() ? above.excavated_on : above.excavated_from;
        auto d = make_diagnostic(model::Severity::Warning, "dug-too-early",
                                 fmt::format("{}, but {} was dug out on {}, before {} was dug on {}: the relation, a "
                                             "date or the sequence of digging is wrong",
                                             c.sentence(r), c.name(c.object[r]), below.excavated_on.substr(0, 10),
                                             c.name(c.subject[r]), begun.substr(0, 10)));
        d.units = {above.id, below.id};
        d.relations = {c.named(r)};
        d.evidence["above_dug"] = begun.substr(0, 10);
        d.evidence["below_dug"] = below.excavated_on.substr(0, 10);
        findings.push_back(std::move(d));
    }
}

} // namespace planum::strat
