// SPDX-License-Identifier: MIT
#include "paint/font_measure.hpp"

#include <QFontMetricsF>
#include <QList>
#include <QString>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "paint/drawing_painter.hpp"
#include "paint/qt_runtime.hpp"

namespace planum::paint {

namespace {

// East Asian wide letters and pictures (Unicode Standard Annex 11), which fill the square in every font. Ours has none:
// what it says of them is the width of its sign for a missing one.
bool is_wide(char32_t c) {
    constexpr std::array<std::pair<char32_t, char32_t>, 9> kRanges = {{{0x1100, 0x115F},
                                                                       {0x2E80, 0xA4CF},
                                                                       {0xAC00, 0xD7A3},
                                                                       {0xF900, 0xFAFF},
                                                                       {0xFE30, 0xFE6F},
                                                                       {0xFF00, 0xFF60},
                                                                       {0xFFE0, 0xFFE6},
                                                                       {0x1F300, 0x1FAFF},
                                                                       {0x20000, 0x3FFFD}}};
    return std::any_of(kRanges.begin(), kRanges.end(),
                       [&](const auto& range) { return c >= range.first && c <= range.second; });
}

} // namespace

FontTextMeasure::FontTextMeasure() { ensure_qt_runtime(); }

double FontTextMeasure::width(std::string_view utf8, double size, strat::FontWeight weight) const {
    // One metrics object a thread: making one asks the font database each time.
    thread_local const QFontMetricsF regular(drawing_font(strat::FontWeight::Regular));
    thread_local const QFontMetricsF bold(drawing_font(strat::FontWeight::Bold));
    const QString text = QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
    const QFontMetricsF& metrics = weight == strat::FontWeight::Bold ? bold : regular;
    const QList<uint> letters = text.toUcs4();
    QList<uint> narrow;
    std::copy_if(letters.begin(), letters.end(), std::back_inserter(narrow), [](uint c) { return !is_wide(c); });
    const auto wide = static_cast<double>(letters.size() - narrow.size());
    if (wide == 0.0) return metrics.horizontalAdvance(text) * size / kFontPixels;
    const QString rest = QString::fromUcs4(reinterpret_cast<const char32_t*>(narrow.constData()), narrow.size());
    return metrics.horizontalAdvance(rest) * size / kFontPixels + wide * size;
}

} // namespace planum::paint
