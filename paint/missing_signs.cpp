// SPDX-License-Identifier: MIT
#include "paint/missing_signs.hpp"

#include <QChar>
#include <QGlyphRun>
#include <QString>
#include <QTextLayout>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "paint/drawing_painter.hpp"
#include "paint/qt_runtime.hpp"

namespace planum::paint {

namespace {

// Below it are the Latin letters, which our own font has all of.
constexpr char32_t kFirstDoubtful = 0x250;

// Joiners and selectors have no sign of their own.
bool is_seen(char32_t c) {
    const bool selects = (c >= 0xFE00 && c <= 0xFE0F) || (c >= 0xE0100 && c <= 0xE01EF);
    switch (QChar::category(c)) {
    case QChar::Other_Format:
    case QChar::Other_Control:
    case QChar::Separator_Space:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph: return false;
    default: return !selects;
    }
}

// Laid out as it will be, with all fonts that Qt falls back on: glyph 0 is the empty square.
bool has_glyph(char32_t c) {
    QTextLayout layout(QString::fromUcs4(&c, 1), drawing_font(strat::FontWeight::Regular));
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    for (const QGlyphRun& run : layout.glyphRuns()) {
        if (run.glyphIndexes().contains(0U)) return false;
    }
    return true;
}

} // namespace

std::vector<std::string> missing_signs(std::string_view utf8) {
    ensure_qt_runtime();
    std::set<char32_t> doubtful;
    const QString text = QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
    for (const uint c : text.toUcs4()) {
        if (c >= kFirstDoubtful && is_seen(c)) doubtful.insert(c);
    }
    std::vector<std::string> missing;
    for (const char32_t c : doubtful) {
        if (!has_glyph(c)) missing.push_back(QString::fromUcs4(&c, 1).toStdString());
    }
    return missing;
}

std::vector<std::string> missing_signs(const strat::MatrixDrawing& drawing) {
    std::string all;
    for (const strat::DrawnBox& box : drawing.boxes) {
        for (const std::string& line : box.lines) all += line + "\n";
    }
    for (const strat::DrawnText& text : drawing.texts) all += text.text + "\n";
    return missing_signs(all);
}

std::string missing_signs_remark(std::string_view file, const std::vector<std::string>& signs) {
    constexpr std::size_t kMost = 12;
    if (signs.empty()) return {};
    std::string words;
    for (std::size_t i = 0; i < std::min(signs.size(), kMost); ++i) words += (i > 0 ? " " : "") + signs[i];
    if (signs.size() > kMost) words += fmt::format(" and {} more", signs.size() - kMost);
    return fmt::format("{}: no font on this machine has {}; empty squares stand in {} place", file, words,
                       signs.size() == 1 ? "its" : "their");
}

} // namespace planum::paint
