// SPDX-License-Identifier: MIT
#include "strat/exchange/hmc_nodes.hpp"

#include <array>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace planum::strat {

namespace {

using model::UnitKind;

constexpr std::string_view kPhaseGroup = "PHASE_GROUP";
constexpr std::string_view kPeriodGroup = "PERIOD_GROUP";
constexpr std::string_view kTopSurface = "top surface"; // in the field "position"

using NodesById = std::unordered_map<std::string, const HmcNode*>;

const HmcNode* find(const NodesById& nodes, const std::string& id) {
    const auto it = nodes.find(id);
    return it == nodes.end() ? nullptr : it->second;
}

// The nearest group of a type around a node. Files may nest in a circle, so steps are counted.
const HmcNode* around(const NodesById& nodes, const HmcNode& node, std::string_view type) {
    const HmcNode* at = find(nodes, node.parent);
    for (std::size_t steps = 0; at != nullptr && steps < 64; ++steps) {
        if (at->type == type) return at;
        at = find(nodes, at->parent);
    }
    return nullptr;
}

void set_kind(model::StratigraphicUnit& unit, const HmcNode& node, RecordBuilder& builder, const Place& place) {
    const std::string& type = node.type;
    if (type == "DEPOSIT") {
        unit.kind = UnitKind::Deposit;
    } else if (type == "SURFACE") {
        unit.kind = UnitKind::Interface;
    } else if (type == "TOP_SURFACE") {
        unit.kind = UnitKind::Interface;
        unit.details["position"] = kTopSurface;
    } else if (type == "UNEXCAVATED") {
        unit.status = model::UnitStatus::NotExcavated;
    } else if (type == "GEOLOGY") {
        unit.kind = UnitKind::Natural;
    } else {
        builder.note(place, "unknown-type", fmt::format("the type {} of {} is not known", type, node.id));
    }
}

void add_group(RecordBuilder& builder, const NodesById& nodes, const HmcNode& node) {
    const HmcNode* period = around(nodes, node, kPeriodGroup);
    const HmcNode* phase = around(nodes, node, kPhaseGroup);
    const bool is_period = node.type == kPeriodGroup;
    if ((is_period && (period != nullptr || phase != nullptr)) || (!is_period && phase != nullptr)) {
        ImportedGroup& group = builder.group(node.id);
        group.values.type = is_period ? "period" : "phase";
        group.values.title = node.name;
        group.values.description = node.description;
        return;
    }
    if (is_period) {
        model::Period values;
        values.number = node.id;
        values.title = node.name;
        values.description = node.description;
        builder.record.periods.push_back(std::move(values));
        return;
    }
    ImportedPhase values;
    values.values.number = node.id;
    values.values.title = node.name;
    values.values.description = node.description;
    if (period != nullptr) values.period = period->id;
    builder.record.phases.push_back(std::move(values));
}

// The outermost phase and period count; inner groups of the same rank are groups.
const HmcNode* outermost(const NodesById& nodes, const HmcNode& node, std::string_view type) {
    const HmcNode* found = nullptr;
    const HmcNode* at = around(nodes, node, type);
    for (std::size_t steps = 0; at != nullptr && steps < 64; ++steps) {
        found = at;
        at = around(nodes, *at, type);
    }
    return found;
}

void add_unit(RecordBuilder& builder, const NodesById& nodes, const HmcNode& node, const Place& place) {
    const UnitName name = builder.name(node.id);
    ImportedUnit& unit = builder.unit(name, place);
    builder.fill(unit.values.title, node.name, "the name of " + node.id, place);
    builder.fill(unit.values.description, node.description, "the description of " + node.id, place);
    set_kind(unit.values, node, builder, place);
    const HmcNode* period = outermost(nodes, node, kPeriodGroup);
    const HmcNode* phase = outermost(nodes, node, kPhaseGroup);
    // A period inside a phase is a group, see add_group.
    if (period != nullptr && around(nodes, *period, kPhaseGroup) == nullptr) unit.period = period->id;
    if (phase != nullptr) unit.phase = phase->id;
    const HmcNode* parent = find(nodes, node.parent);
    if (parent != nullptr && parent != period && parent != phase) builder.add_member(parent->id, name);
}

} // namespace

bool is_hmc_group(std::string_view type) noexcept { return type == kPhaseGroup || type == kPeriodGroup; }

void add_hmc_nodes(RecordBuilder& builder, const std::vector<HmcNode>& nodes, std::string_view file) {
    NodesById groups;
    for (const HmcNode& node : nodes) {
        if (is_hmc_group(node.type)) groups.emplace(node.id, &node);
    }
    std::size_t incomplete = 0;
    for (const HmcNode& node : nodes) {
        const Place place{file, node.line, node.id};
        if (node.id.empty()) {
            builder.note(place, "unparsed", "a node without an id was left out");
            continue;
        }
        const HmcNode* known = find(groups, node.id);
        if (known == &node) {
            add_group(builder, groups, node);
            continue;
        }
        if (is_hmc_group(node.type)) {
            builder.note(place, "repeated", fmt::format("the group {} comes twice; the first counts", node.id));
            continue;
        }
        incomplete += node.valid ? 0U : 1U;
        add_unit(builder, groups, node, place);
    }
    if (incomplete > 0) {
        builder.note({file, 0, {}}, "marked-incomplete",
                     fmt::format("the Harris Matrix Composer marks {} units as tied incompletely", incomplete));
    }
}

std::string_view hmc_type_of(const model::StratigraphicUnit& unit) noexcept {
    if (unit.kind == UnitKind::Natural) return "GEOLOGY";
    if (unit.kind == UnitKind::Unknown && unit.status == model::UnitStatus::NotExcavated) return "UNEXCAVATED";
    if (unit.kind == UnitKind::Interface) {
        const auto position = unit.details.find("position");
        return position != unit.details.end() && position->second == kTopSurface ? "TOP_SURFACE" : "SURFACE";
    }
    return unit.kind == UnitKind::Cut ? "SURFACE" : "DEPOSIT";
}

} // namespace planum::strat
