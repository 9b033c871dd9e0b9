// SPDX-License-Identifier: MIT
#include "paint/font_measure.hpp"

#include <QFontMetricsF>
#include <QString>

#include "paint/drawing_painter.hpp"
#include "paint/qt_runtime.hpp"

namespace planum::paint {

FontTextMeasure::FontTextMeasure() { ensure_qt_runtime(); }

double FontTextMeasure::width(std::string_view utf8, double size, strat::FontWeight weight) const {
    // One metrics object a thread: making one asks the font database each time.
    thread_local const QFontMetricsF regular(drawing_font(strat::FontWeight::Regular));
    thread_local const QFontMetricsF bold(drawing_font(strat::FontWeight::Bold));
    const QString text = QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
    const QFontMetricsF& metrics = weight == strat::FontWeight::Bold ? bold : regular;
    return metrics.horizontalAdvance(text) * size / kFontPixels;
}

} // namespace planum::paint
