// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "strat/layout/drawn_graph.hpp"

namespace planum::strat {

/// The graph as Graphviz DOT for others to lay out: nodes named after their units, shapes by kind,
/// contemporary units on one rank, uncertain orders dashed, cycles red.
[[nodiscard]] std::string write_dot(const DrawnGraph& graph);

/// The graph as DOT for our own child process: nodes `n0`, `n1`, … in the order of the boxes with fixed
/// sizes, isolated ones left out; edges carry their position as comment.
[[nodiscard]] std::string write_layout_dot(const DrawnGraph& graph, std::string_view splines);

/// Text as a quoted DOT string.
[[nodiscard]] std::string dot_quoted(std::string_view text);

} // namespace planum::strat
