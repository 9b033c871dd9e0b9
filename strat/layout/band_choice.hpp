// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/model/record.hpp"
#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/layout_engine.hpp"

namespace planum::strat {

/// Phases or periods as bands of the graph, latest first, and each box's band. Unasked where most boxes have one and
/// few orders run against them.
void choose_bands(const model::Record& record, const DrawingOptions& options, DrawnGraph& graph);

/// What all units of a merged box belong to that belong to anything; -1 where they differ, or none does. `keys`: by
/// unit.
[[nodiscard]] std::int32_t shared_key(const std::vector<std::int32_t>& keys, const std::vector<UnitIndex>& units);

/// `P2 occupation`: number and title of a phase or group on one line.
[[nodiscard]] std::string heading_with(const std::string& number, const std::string& title);

} // namespace planum::strat
