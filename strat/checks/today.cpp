// SPDX-License-Identifier: MIT
#include "strat/checks/today.hpp"

#include <algorithm>

namespace planum::strat {

namespace {

using model::StratigraphicUnit;
using model::UnitKind;
using model::UnitStatus;

bool has_sheet(const StratigraphicUnit& unit) {
    return unit.origin == model::UnitOrigin::Recorded && unit.kind != UnitKind::Void && unit.status != UnitStatus::Void;
}

bool is_open(const StratigraphicUnit& unit) {
    return unit.status == UnitStatus::Open || unit.status == UnitStatus::PartlyExcavated;
}

bool has_body(const StratigraphicUnit& unit) {
    return unit.kind != UnitKind::Cut && unit.kind != UnitKind::Interface && unit.kind != UnitKind::Void;
}

// Nodes with something undug anywhere above them, from the top down.
std::vector<char> covered_nodes(const model::Record& record, const HarrisMatrix& m) {
    std::vector<char> covered(m.node_count(), 0);
    const auto undug = [&](NodeIndex node) {
        const auto members = m.members(node);
        return std::any_of(members.begin(), members.end(), [&](UnitIndex u) {
            const StratigraphicUnit& unit = record.units[u];
            return has_body(unit) && unit.status != UnitStatus::Excavated && unit.status != UnitStatus::Void;
        });
    };
    for (std::uint32_t component = 0; component < m.component_count(); ++component) {
        const auto nodes = m.component(component);
        for (const NodeIndex node : nodes) {
            if (nodes.size() > 1) covered[node] = 1;
            if (covered[node] == 0 && !undug(node)) continue;
            for (const std::uint32_t order : m.orders_below(node)) covered[m.orders()[order].earlier] = 1;
        }
    }
    return covered;
}

} // namespace

Today today(const model::Record& record, const HarrisMatrix& matrix) {
    Today result;
    const std::vector<char> covered = covered_nodes(record, matrix);
    const model::RecordIndex index(record);
    std::vector<char> has_level(record.units.size(), 0);
    for (const model::Level& level : record.levels) {
        const UnitIndex u = index.find(level.unit);
        if (u != model::kNoUnit) has_level[u] = 1;
    }
    for (UnitIndex u = 0; u < record.units.size(); ++u) {
        const StratigraphicUnit& unit = record.units[u];
        if (!has_sheet(unit)) continue;
        const NodeIndex node = matrix.node_of(u);
        if (is_open(unit)) {
            result.open.push_back(u);
            if (covered[node] == 0) result.diggable.push_back(u);
        }
        SheetGaps gaps;
        gaps.unit = u;
        gaps.level = has_level[u] == 0;
        gaps.description = unit.description.empty() && unit.interpretation.empty() && unit.title.empty();
        gaps.relation = matrix.orders_below(node).empty() && unit.kind != UnitKind::Natural;
        if (gaps.level || gaps.description || gaps.relation) result.gaps.push_back(gaps);
    }
    return result;
}

} // namespace planum::strat
