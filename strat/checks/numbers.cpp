// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

#include "core/base/text.hpp"
#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::Severity;

void add_reused(const CheckContext& c, Findings& findings) {
    if (c.record.settings.numbers == model::NumberScope::Area) return;
    std::unordered_map<std::string_view, std::vector<UnitIndex>> by_number;
    for (UnitIndex u = 0; u < c.record.units.size(); ++u) {
        if (!c.is_void(u)) by_number[c.unit(u).number].push_back(u);
    }
    // Walk the units, not the table, so that the order is that of the record.
    for (UnitIndex u = 0; u < c.record.units.size(); ++u) {
        const auto it = by_number.find(c.unit(u).number);
        if (it == by_number.end() || it->second.size() < 2 || it->second.front() != u) continue;
        std::vector<std::string> names;
        auto d = make_diagnostic(Severity::Warning, "number-reused", {});
        for (const UnitIndex same : it->second) {
            names.push_back(c.full_name(same));
            d.units.push_back(c.unit(same).id);
        }
        d.message = fmt::format("number {} is given to {} units ({}), though numbers are unique on this site",
                                c.unit(u).number, names.size(), list_names(names, 6));
        findings.push_back(std::move(d));
    }
}

void add_outside_block(const CheckContext& c, Findings& findings) {
    std::map<model::AreaId, const model::Area*> blocks;
    for (const model::Area& area : c.record.areas) {
        if (!area.first_number.empty() && !area.last_number.empty()) blocks.emplace(area.id, &area);
    }
    if (blocks.empty()) return;
    for (UnitIndex u = 0; u < c.record.units.size(); ++u) {
        const model::StratigraphicUnit& unit = c.unit(u);
        const auto it = blocks.find(unit.area);
        if (it == blocks.end() || c.is_void(u) || c.is_mentioned(u)) continue;
        const model::Area& area = *it->second;
        if (text::natural_order(unit.number, area.first_number) >= 0 &&
            text::natural_order(unit.number, area.last_number) <= 0) {
            continue;
        }
        auto d = make_diagnostic(Severity::Warning, "number-outside-block",
                                 fmt::format("{} stands in area {}, whose numbers run from {} to {}", c.name(u),
                                             area.name, area.first_number, area.last_number));
        d.units = {unit.id};
        findings.push_back(std::move(d));
    }
}

} // namespace

void check_numbers(const CheckContext& context, Findings& findings) {
    add_reused(context, findings);
    add_outside_block(context, findings);
}

} // namespace planum::strat
