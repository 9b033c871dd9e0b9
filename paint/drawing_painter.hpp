// SPDX-License-Identifier: MIT
#pragma once

#include <QFont>

#include "strat/layout/drawing.hpp"
#include "strat/layout/text_measure.hpp"

class QPainter;

namespace planum::paint {

/// Text is set at this size and scaled, so that widths do not depend on the device's resolution.
inline constexpr int kFontPixels = 100;

[[nodiscard]] QFont drawing_font(strat::FontWeight weight);

/// Paints the drawing in its own points, clipped to nothing: the caller has set scale, origin and clip.
/// Needs ensure_qt_runtime().
void paint_drawing(QPainter& painter, const strat::MatrixDrawing& drawing);

/// A sample of the legend, where it stands in the drawing.
void paint_sample(QPainter& painter, const strat::LegendSample& sample);

/// One line of text with its base line at `at`; `width` > 0 squeezes or stretches it to that width [pt].
struct PaintedText {
    std::string_view text;
    strat::DrawPoint at;
    double size = 9.0; ///< [pt]
    double width = 0.0;
    strat::TextAnchor anchor = strat::TextAnchor::Start;
    strat::FontWeight weight = strat::FontWeight::Regular;
    unsigned colour = 0x1d1c1a;
};

void paint_text(QPainter& painter, const PaintedText& text);

} // namespace planum::paint
