// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "strat/layout/drawing.hpp"

class QPainter;

namespace planum::paint {

/// A drawing's legend set once more in small rows, for the foot of every sheet of a poster: the drawing's own stands on
/// its last sheets only.
struct LegendStrip {
    struct Entry {
        std::size_t sample = 0; ///< position in MatrixDrawing::legend
        std::size_t text = 0;   ///< position of its words in MatrixDrawing::texts
        strat::DrawPoint at;    ///< upper left corner, from that of the strip [pt]
    };

    std::vector<Entry> entries;
    double height = 0.0; ///< [pt]; 0 without a legend
};

/// In rows of at most `width` [pt]. Needs no display and no fonts: the words were measured for the drawing.
[[nodiscard]] LegendStrip lay_legend(const strat::MatrixDrawing& drawing, double width);

void paint_legend(QPainter& painter, const strat::MatrixDrawing& drawing, const LegendStrip& strip,
                  strat::DrawPoint at);

} // namespace planum::paint
