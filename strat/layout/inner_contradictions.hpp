// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/graph_selection.hpp"

namespace planum::strat {

/// Marks the boxes that hold a contradiction which no line of the drawing can show, as both ends of the order
/// would be one box: a unit above itself, an order between units merged by same_as, a cycle inside a folded
/// box, or one whose other units are not drawn. Orders marked as removed contradict nothing. To be called when
/// the graph's orders are made; sizes of boxes are set anew where the mark needs room.
void mark_inner_contradictions(DrawnGraph& graph, const LayoutRequest& request, const Selection& selection);

} // namespace planum::strat
