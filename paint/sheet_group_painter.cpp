// SPDX-License-Identifier: MIT
#include "paint/sheet_group_painter.hpp"

#include <QPainter>

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "paint/drawing_painter.hpp"
#include "paint/font_measure.hpp"
#include "paint/map_page.hpp"
#include "paint/map_painter.hpp"
#include "paint/paper.hpp"
#include "paint/qt_runtime.hpp"
#include "strat/layout/drawing_colours.hpp"

namespace planum::paint {

using namespace strat;

namespace {

constexpr double kTitleSize = 16.0; // [pt]
constexpr double kPartSize = 11.0;
constexpr double kTextSize = 9.0;
constexpr double kTextLine = 12.5;
constexpr double kSide = kMapMargin + 14.0; // as the words of the sheets
constexpr double kTop = 44.0;               // base line of the title

struct PlacedSheet {
    const geometry::ScaledSheet* sheet = nullptr;
    MapPage page;
    double top = 0.0; // [pt]
};

struct GroupPage {
    double width = 0.0; // [pt]
    double height = 0.0;
    std::vector<std::string> text; // lines
    std::vector<PlacedSheet> sheets;
};

std::vector<std::string> broken_lines(const std::string& text, double width) {
    const FontTextMeasure measure;
    std::vector<std::string> lines;
    for (const std::string_view word : text::split(text, ' ')) {
        const std::string longer = lines.empty() ? std::string(word) : lines.back() + ' ' + std::string(word);
        if (!lines.empty() && measure.width(longer, kTextSize, FontWeight::Regular) <= width) {
            lines.back() = longer;
        } else {
            lines.emplace_back(word);
        }
    }
    return lines;
}

GroupPage lay_out(const geometry::SheetGroup& group) {
    if (group.sheets.empty()) throw Error(ErrorCode::BadInput, "there is nothing to show");
    GroupPage page;
    for (const geometry::ScaledSheet& sheet : group.sheets)
        page.width = std::max(page.width, lay_out_map(sheet.sheet, sheet.scale).width);
    page.text = broken_lines(group.text, page.width - 2.0 * kSide);
    double top = kTop + kTextLine * static_cast<double>(page.text.size()) + 2.0 - kMapMargin / 2.0;
    for (const geometry::ScaledSheet& sheet : group.sheets) {
        page.sheets.push_back({&sheet, lay_out_map(sheet.sheet, sheet.scale, page.width), top});
        page.sheets.back().page.title_size = kPartSize;
        page.sheets.back().page.frame.moveLeft(kSide); // below its title, where another sheet is wider
        top += page.sheets.back().page.height - kMapMargin;
    }
    page.height = top + kMapMargin / 2.0;
    return page;
}

void paint_group(QPainter& painter, const geometry::SheetGroup& group, const GroupPage& page) {
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const auto words = [&](const std::string& text, DrawPoint at, double size, TextAnchor anchor, FontWeight weight,
                           Colour colour) {
        paint_text(painter, {text, at, size, 0.0, anchor, weight, colour});
    };
    words(group.title, {kSide, kTop - 4.0}, kTitleSize, TextAnchor::Start, FontWeight::Bold, kInk);
    words(group.site, {page.width - kSide, kTop - 4.0}, kTextSize, TextAnchor::End, FontWeight::Regular, kFaintInk);
    double base = kTop + kTextLine;
    for (const std::string& line : page.text) {
        words(line, {kSide, base}, kTextSize, TextAnchor::Start, FontWeight::Regular, kInk);
        base += kTextLine;
    }
    for (const PlacedSheet& placed : page.sheets) {
        painter.save();
        painter.translate(0.0, placed.top);
        paint_map(painter, placed.sheet->sheet, placed.page, placed.sheet->scale);
        painter.restore();
    }
}

} // namespace

std::string render_sheet_group_png(const geometry::SheetGroup& group, double dpi) {
    constexpr double kMostPixels = 120e6;
    ensure_qt_runtime();
    const GroupPage page = lay_out(group);
    if (page.width * page.height * dpi * dpi / (72.0 * 72.0) > kMostPixels)
        throw Error(ErrorCode::BadInput, fmt::format("a picture at {:.0f} dots an inch is too large", dpi));
    return png_page(page.width, page.height, dpi, [&](QPainter& painter) { paint_group(painter, group, page); });
}

std::string render_sheet_group_pdf(const geometry::SheetGroup& group, Progress& progress) {
    ensure_qt_runtime();
    progress.step("writing the PDF");
    const GroupPage page = lay_out(group);
    const PaperChoice paper = choose_paper(page.width, page.height);
    return pdf_page(paper, group.title, [&](QPainter& painter) {
        painter.translate((paper.width - page.width) / 2.0, std::min(30.0, (paper.height - page.height) / 2.0));
        paint_group(painter, group, page);
    });
}

} // namespace planum::paint
