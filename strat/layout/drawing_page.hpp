// SPDX-License-Identifier: MIT
#pragma once

#include "strat/layout/drawn_graph.hpp"

namespace planum::strat {

/// The last step of every engine: takes boxes and lines placed anywhere (isolated boxes still without a
/// place, bands with y and height only) and makes a page of them: isolated units in a corner of their
/// own, title, headings, legend, margins, everything moved so that the page begins at (0, 0).
void finish_page(MatrixDrawing& drawing, const DrawnGraph& graph, const TextMeasure& text);

} // namespace planum::strat
