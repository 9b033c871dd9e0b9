// SPDX-License-Identifier: MIT
#include "paint/legend_strip.hpp"

#include <QPainter>

#include "paint/drawing_painter.hpp"

namespace planum::paint {

using namespace strat;

namespace {

constexpr double kScale = 0.75; // of the drawing's own legend
constexpr double kSample = 26.0 * kScale;
constexpr double kRow = 13.0 * kScale + 3.5;
constexpr double kGap = 4.0;      // between sample and words
constexpr double kBetween = 14.0; // from the words to the next sample
constexpr double kBaseLine = 7.4; // of the words, below the row's upper edge

} // namespace

LegendStrip lay_legend(const MatrixDrawing& drawing, double width) {
    LegendStrip strip;
    DrawPoint pen;
    for (std::size_t t = 0; t < drawing.texts.size() && strip.entries.size() < drawing.legend.size(); ++t) {
        if (drawing.texts[t].role != "legend") continue;
        const double room = kSample + kGap + drawing.texts[t].width * kScale;
        if (pen.x > 0.0 && pen.x + room > width) pen = {0.0, pen.y + kRow};
        strip.entries.push_back({strip.entries.size(), t, pen});
        pen.x += room + kBetween;
    }
    if (!strip.entries.empty()) strip.height = pen.y + kRow;
    return strip;
}

void paint_legend(QPainter& painter, const MatrixDrawing& drawing, const LegendStrip& strip, DrawPoint at) {
    for (const LegendStrip::Entry& entry : strip.entries) {
        const LegendSample& sample = drawing.legend[entry.sample];
        painter.save();
        painter.translate(at.x + entry.at.x, at.y + entry.at.y);
        painter.scale(kScale, kScale);
        painter.translate(-sample.box.rect.x, -sample.box.rect.y);
        paint_sample(painter, sample);
        painter.restore();
        const DrawnText& words = drawing.texts[entry.text];
        PaintedText text;
        text.text = words.text;
        text.at = {at.x + entry.at.x + kSample + kGap, at.y + entry.at.y + kBaseLine};
        text.size = words.size * kScale;
        text.width = words.width * kScale;
        paint_text(painter, text);
    }
}

} // namespace planum::paint
