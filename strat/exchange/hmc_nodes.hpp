// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "strat/exchange/record_builder.hpp"

namespace planum::strat {

/// A node of a Harris Matrix Composer project, from its XML or its CSV.
struct HmcNode {
    std::string id;
    std::string type; ///< DEPOSIT, SURFACE, TOP_SURFACE, UNEXCAVATED, GEOLOGY, PHASE_GROUP, PERIOD_GROUP
    std::string name;
    std::string description;
    std::string parent; ///< id of the group around it
    bool valid = true;  ///< false: HMC found it tied incompletely
    std::int64_t line = 0;
};

[[nodiscard]] bool is_hmc_group(std::string_view type) noexcept;

/// Units, phases, periods and groups from nodes. A period group is a period, a phase group a phase of
/// the period around it; a group inside one of its own rank is a group of units below it.
void add_hmc_nodes(RecordBuilder& builder, const std::vector<HmcNode>& nodes, std::string_view file);

/// The type HMC knows for a unit.
[[nodiscard]] std::string_view hmc_type_of(const model::StratigraphicUnit& unit) noexcept;

} // namespace planum::strat
