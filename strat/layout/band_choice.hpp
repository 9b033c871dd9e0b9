// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/model/record.hpp"
#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/layout_engine.hpp"

namespace planum::strat {

/// Phases or periods as bands of the graph, latest first, and each box's band. Unasked where most boxes have one and
/// few orders run against them.
void choose_bands(const model::Record& record, const DrawingOptions& options, DrawnGraph& graph);

/// `P2 occupation`: number and title of a phase or group on one line.
[[nodiscard]] std::string heading_with(const std::string& number, const std::string& title);

} // namespace planum::strat
