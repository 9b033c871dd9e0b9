// SPDX-License-Identifier: MIT
#include "paint/poster_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "paint/legend_strip.hpp"

namespace planum::paint {

using strat::DrawRect;

namespace {

constexpr double kPointsPerMillimetre = 72.0 / 25.4;
constexpr std::size_t kMostSheets = 2000;
constexpr double kLeastWidth = 290.0; // [pt] of a page made to fit: the title block has its place

struct Size {
    double width = 0.0;
    double height = 0.0;
};

// Upright, ISO 216.
Size paper_size(Paper paper) {
    const auto mm = [](double w, double h) { return Size{w * kPointsPerMillimetre, h * kPointsPerMillimetre}; };
    switch (paper) {
    case Paper::Fitted: return {};
    case Paper::A4: return mm(210, 297);
    case Paper::A3: return mm(297, 420);
    case Paper::A2: return mm(420, 594);
    case Paper::A1: return mm(594, 841);
    case Paper::A0: return mm(841, 1189);
    }
    return {};
}

DrawRect content_of(Size page, double margin, double title_block) {
    return {margin, margin, page.width - 2.0 * margin, page.height - 2.0 * margin - title_block};
}

bool meets(const DrawRect& a, const DrawRect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

bool inside(const DrawRect& inner, const DrawRect& outer) {
    return inner.x >= outer.x && inner.right() <= outer.right() && inner.y >= outer.y &&
           inner.bottom() <= outer.bottom();
}

// Whether anything but paper is seen in a part of the drawing.
bool shows_something(const strat::MatrixDrawing& drawing, const DrawRect& part) {
    const auto seen = [&](const DrawRect& r) { return meets(r, part); };
    if (std::any_of(drawing.boxes.begin(), drawing.boxes.end(), [&](const auto& b) { return seen(b.rect); }))
        return true;
    if (std::any_of(drawing.bands.begin(), drawing.bands.end(), [&](const auto& b) { return seen(b.rect); }))
        return true;
    for (const strat::DrawnText& t : drawing.texts) {
        if (seen({t.at.x, t.at.y - t.size, t.width, t.size * 1.3})) return true;
    }
    for (const strat::DrawnLine& line : drawing.lines) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const auto [x0, x1] = std::minmax(line.points[i - 1].x, line.points[i].x);
            const auto [y0, y1] = std::minmax(line.points[i - 1].y, line.points[i].y);
            if (seen({x0 - 0.5, y0 - 0.5, x1 - x0 + 1.0, y1 - y0 + 1.0})) return true;
        }
    }
    return false;
}

PosterPlan plan_one_page(const strat::MatrixDrawing& drawing, const PosterOptions& options, Size page) {
    PosterPlan plan;
    plan.page_width = page.width;
    plan.page_height = page.height;
    plan.title_block = kTitleBlock;
    plan.content = content_of(page, options.margin, plan.title_block);
    plan.scale = std::min({1.0, plan.content.width / drawing.width, plan.content.height / drawing.height});
    plan.rows = 1;
    plan.columns = 1;
    plan.sheets = {{"A1", 0, 0, {0.0, 0.0, drawing.width, drawing.height}}};
    return plan;
}

PosterPlan plan_tiles(const strat::MatrixDrawing& drawing, const PosterOptions& options, Size page) {
    PosterPlan plan;
    plan.page_width = page.width;
    plan.page_height = page.height;
    plan.scale = options.scale;
    plan.title_block = kTitleBlock + lay_legend(drawing, page.width - 2.0 * options.margin).height;
    plan.content = content_of(page, options.margin, plan.title_block);
    const double width = plan.content.width / options.scale;
    const double height = plan.content.height / options.scale;
    const double overlap = options.overlap / options.scale;
    if (width <= overlap * 1.5 || height <= overlap * 1.5) {
        throw Error(ErrorCode::BadInput, fmt::format("an overlap of {:.0f} mm leaves no room on the sheet; use less",
                                                     options.overlap / kPointsPerMillimetre));
    }
    const auto count = [&](double whole, double part) {
        return whole <= part ? 1.0 : std::ceil((whole - overlap) / (part - overlap));
    };
    const double columns = count(drawing.width, width);
    const double rows = count(drawing.height, height);
    if (!(rows * columns <= static_cast<double>(kMostSheets))) {
        throw Error(
            ErrorCode::BadInput,
            fmt::format("the poster would need {:.0f} sheets, more than {}; use larger paper or a smaller scale",
                        rows * columns, kMostSheets));
    }
    plan.rows = static_cast<std::size_t>(rows);
    plan.columns = static_cast<std::size_t>(columns);
    for (std::size_t r = 0; r < plan.rows; ++r) {
        for (std::size_t c = 0; c < plan.columns; ++c) {
            const DrawRect part{static_cast<double>(c) * (width - overlap), static_cast<double>(r) * (height - overlap),
                                width, height};
            plan.sheets.push_back({row_letters(r) + fmt::format("{}", c + 1), r, c, part});
        }
    }
    return plan;
}

} // namespace

std::string row_letters(std::size_t row) {
    std::string letters;
    for (std::size_t n = row + 1; n > 0; n = (n - 1) / 26) {
        letters.insert(letters.begin(), static_cast<char>('A' + (n - 1) % 26));
    }
    return letters;
}

PosterPlan plan_poster(const strat::MatrixDrawing& drawing, const PosterOptions& options) {
    if (!(drawing.width > 0.0 && drawing.height > 0.0)) throw Error(ErrorCode::BadInput, "the drawing has no size");
    if (!(options.scale > 0.0 && std::isfinite(options.scale))) {
        throw Error(ErrorCode::BadInput, "the scale of a poster must be a positive number");
    }
    if (options.paper == Paper::Fitted) {
        const Size page{std::max(drawing.width, kLeastWidth) + 2.0 * options.margin,
                        drawing.height + 2.0 * options.margin + kTitleBlock};
        return plan_one_page(drawing, options, page);
    }
    const Size upright = paper_size(options.paper);
    const Size across{upright.height, upright.width};
    if (options.paging == Paging::OnePage) {
        PosterPlan a = plan_one_page(drawing, options, upright);
        PosterPlan b = plan_one_page(drawing, options, across);
        return b.scale > a.scale ? b : a;
    }
    PosterPlan a = plan_tiles(drawing, options, upright);
    PosterPlan b = plan_tiles(drawing, options, across);
    PosterPlan plan = b.sheets.size() < a.sheets.size() ? std::move(b) : std::move(a);
    if (plan.sheets.size() == 1) { // shows the drawing's own key
        plan.title_block = kTitleBlock;
        plan.content = content_of({plan.page_width, plan.page_height}, options.margin, plan.title_block);
        plan.sheets.front().part = {0.0, 0.0, plan.content.width / plan.scale, plan.content.height / plan.scale};
    }
    std::erase_if(plan.sheets, [&](const Sheet& sheet) { return !shows_something(drawing, sheet.part); });
    return plan;
}

std::vector<SheetEntry> sheet_index(const strat::MatrixDrawing& drawing, const PosterPlan& plan) {
    std::vector<SheetEntry> entries;
    for (const strat::DrawnBox& box : drawing.boxes) {
        const auto whole = std::find_if(plan.sheets.begin(), plan.sheets.end(),
                                        [&](const Sheet& s) { return inside(box.rect, s.part); });
        const auto some = std::find_if(plan.sheets.begin(), plan.sheets.end(),
                                       [&](const Sheet& s) { return meets(box.rect, s.part); });
        const auto found = whole != plan.sheets.end() ? whole : some;
        if (found == plan.sheets.end() || box.lines.empty()) continue;
        // A merged box is looked up under each of its numbers.
        for (const std::string& line :
             box.shape == strat::BoxShape::Folded ? std::vector{box.lines.front()} : box.names) {
            entries.push_back({line, found->name});
        }
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const SheetEntry& a, const SheetEntry& b) { return text::natural_order(a.unit, b.unit) < 0; });
    return entries;
}

} // namespace planum::paint
