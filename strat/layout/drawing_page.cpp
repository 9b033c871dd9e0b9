// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/wrapped_text.hpp"

namespace planum::strat {

namespace {

// What is set in rows below the matrix gets at least this width [pt].
constexpr double kLeastWidth = 330.0;
// From one line to the next [pt].
constexpr double kTitleLine = style::kTitleSize + 4.0;
constexpr double kSubtitleLine = style::kSubtitleSize + 6.0;

// Grows with what is put into it.
struct Extent {
    double left = std::numeric_limits<double>::infinity();
    double top = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const noexcept { return left > right; }

    void add(const DrawPoint& p) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }

    void add(const DrawRect& r) {
        add(DrawPoint{r.x, r.y});
        add(DrawPoint{r.right(), r.bottom()});
    }
};

void shift(DrawRect& rect, double dx, double dy) {
    rect.x += dx;
    rect.y += dy;
}

class PageMaker {
  public:
    PageMaker(MatrixDrawing& drawing, const DrawnGraph& graph, const TextMeasure& text)
        : drawing_(drawing), graph_(graph), text_(text) {}

    void make() {
        Extent matrix;
        for (const DrawnBox& box : drawing_.boxes) {
            if (!box.isolated) matrix.add(box.rect);
        }
        for (const DrawnLine& line : drawing_.lines) {
            for (const DrawPoint& p : line.points) matrix.add(p);
        }
        for (const DrawnFrame& frame : drawing_.frames) matrix.add(frame.rect);
        break_title(matrix.empty() ? 0.0 : band_gutter() + matrix.right - matrix.left);
        const double heading = title_height();
        if (!matrix.empty()) {
            for (const DrawnBand& band : drawing_.bands) matrix.add(DrawPoint{matrix.left, band.rect.y});
            for (const DrawnBand& band : drawing_.bands) matrix.add(DrawPoint{matrix.left, band.rect.bottom()});
            const double gutter = band_gutter();
            move_matrix(style::kPageMargin + gutter - matrix.left, style::kPageMargin + heading - matrix.top);
            right_ = style::kPageMargin + gutter + matrix.right - matrix.left;
            bottom_ = style::kPageMargin + heading + matrix.bottom - matrix.top;
        } else {
            right_ = style::kPageMargin;
            bottom_ = style::kPageMargin + heading;
        }
        place_isolated();
        widen_for_title();
        place_legend();
        stretch_bands();
        name_frames();
        drawing_.width = std::ceil(right_ + style::kPageMargin);
        drawing_.height = std::ceil(bottom_ + style::kPageMargin);
        write_title();
        place_arrows(drawing_);
    }

  private:
    // Into lines no wider than the matrix: a long name of the site widens no page.
    void break_title(double width) {
        constexpr std::size_t kMostLines = 3;
        const double limit = std::max(width, kLeastWidth);
        title_ = wrapped(graph_.title, limit, kMostLines, {style::kTitleSize, FontWeight::Bold}, text_);
        subtitle_ = wrapped(graph_.subtitle, limit, kMostLines, {style::kSubtitleSize, FontWeight::Regular}, text_);
    }

    [[nodiscard]] double title_height() const {
        const auto more = [](std::size_t lines, double height) { return static_cast<double>(lines) * height; };
        return style::kTitleSize + 20.0 + more(std::max<std::size_t>(title_.size(), 1) - 1, kTitleLine) +
               more(subtitle_.size(), kSubtitleLine);
    }

    [[nodiscard]] double width_of(std::string_view s, double size, FontWeight weight = FontWeight::Regular) const {
        return text_.width(s, size, weight);
    }

    void add_text(std::string_view role, const std::string& s, DrawPoint at, double size, FontWeight weight) {
        DrawnText t;
        t.role = role;
        t.text = s;
        t.at = at;
        t.size = size;
        t.bold = weight == FontWeight::Bold;
        t.width = width_of(s, size, weight);
        drawing_.texts.push_back(std::move(t));
    }

    // Headings of bands stand in a column of their own, left of everything.
    [[nodiscard]] double band_gutter() const {
        double widest = 0.0;
        for (const DrawnBand& band : drawing_.bands) {
            widest = std::max(widest, width_of(band.heading, style::kHeadingSize, FontWeight::Bold));
        }
        return drawing_.bands.empty() ? 0.0 : widest + 20.0;
    }

    void move_matrix(double dx, double dy) {
        for (DrawnBox& box : drawing_.boxes) {
            if (!box.isolated) shift(box.rect, dx, dy);
        }
        for (DrawnLine& line : drawing_.lines) {
            for (DrawPoint& p : line.points) p = {p.x + dx, p.y + dy};
        }
        for (DrawPoint& p : drawing_.junctions) p = {p.x + dx, p.y + dy};
        for (DrawnBand& band : drawing_.bands) shift(band.rect, 0.0, dy);
        for (DrawnFrame& frame : drawing_.frames) shift(frame.rect, dx, dy);
    }

    // In rows below the matrix, as wide as it is or nearly square, whichever is wider.
    void place_isolated() {
        std::vector<DrawnBox*> isolated;
        double area = 0.0;
        for (DrawnBox& box : drawing_.boxes) {
            if (!box.isolated) continue;
            isolated.push_back(&box);
            area += (box.rect.width + 8.0) * (box.rect.height + 8.0);
        }
        if (isolated.empty()) return;
        const double left = style::kPageMargin;
        const double limit = std::max({right_, left + 1.5 * std::sqrt(area), left + kLeastWidth});
        double y = bottom_ + (isolated.size() < drawing_.boxes.size() ? 30.0 : 0.0) + style::kHeadingSize;
        add_text("heading", with_number(graph_.words.isolated, isolated.size()), {left, y}, style::kHeadingSize,
                 FontWeight::Bold);
        y += 9.0;
        double x = left;
        double row_height = 0.0;
        for (DrawnBox* box : isolated) {
            if (x > left && x + box->rect.width > limit) {
                x = left;
                y += row_height + 8.0;
                row_height = 0.0;
            }
            box->rect.x = x;
            box->rect.y = y;
            x += box->rect.width + 8.0;
            row_height = std::max(row_height, box->rect.height);
            right_ = std::max(right_, box->rect.right());
        }
        bottom_ = y + row_height;
    }

    void widen_for_title() {
        for (const std::string& line : title_) {
            right_ = std::max(right_, style::kPageMargin + width_of(line, style::kTitleSize, FontWeight::Bold));
        }
        for (const std::string& line : subtitle_) {
            right_ = std::max(right_, style::kPageMargin + width_of(line, style::kSubtitleSize));
        }
    }

    // Writes one entry and returns its width.
    void legend_entry(LegendSample sample, const std::string& words, DrawPoint& pen) {
        constexpr double kSample = 26.0;
        constexpr double kHeight = 13.0;
        const double width = kSample + 6.0 + width_of(words, style::kTextSize) + 20.0;
        const double limit = std::max(right_, style::kPageMargin + kLeastWidth);
        if (pen.x > style::kPageMargin && pen.x + width - 20.0 > limit) {
            pen.x = style::kPageMargin;
            pen.y += kHeight + 8.0;
        }
        sample.box.rect = {pen.x, pen.y, kSample, kHeight};
        const double middle = pen.y + kHeight / 2.0;
        sample.line.points = {{pen.x, middle}, {pen.x + kSample, middle}};
        if (sample.line.upwards) { // with its head, so not level
            const double bend = pen.x + kSample / 2.0;
            sample.line.points = {
                {pen.x, pen.y + kHeight}, {bend, pen.y + kHeight}, {bend, pen.y}, {pen.x + kSample, pen.y}};
            sample.line.arrow = {bend, middle};
        }
        add_text("legend", words, {pen.x + kSample + 6.0, pen.y + 9.8}, style::kTextSize, FontWeight::Regular);
        drawing_.legend.push_back(std::move(sample));
        right_ = std::max(right_, pen.x + width - 20.0);
        pen.x += width;
    }

    void place_legend() {
        if (drawing_.boxes.empty()) return;
        DrawPoint pen{style::kPageMargin, bottom_ + 28.0};
        legend_of_boxes(pen);
        legend_of_lines(pen);
        if (!drawing_.legend.empty()) bottom_ = pen.y + 13.0;
    }

    void legend_of_boxes(DrawPoint& pen) {
        constexpr int kShapes = static_cast<int>(BoxShape::Folded) + 1;
        const auto any = [&](auto what) { return std::any_of(drawing_.boxes.begin(), drawing_.boxes.end(), what); };
        for (int s = 0; s < kShapes; ++s) {
            const auto shape = static_cast<BoxShape>(s);
            if (!any([&](const DrawnBox& b) { return b.shape == shape && !b.mentioned_only; })) continue;
            LegendSample sample;
            sample.box.shape = shape;
            legend_entry(sample, graph_.words.shapes.at(static_cast<std::size_t>(s)), pen);
        }
        LegendSample sample;
        sample.box.mentioned_only = true;
        if (any([](const DrawnBox& b) { return b.mentioned_only; })) {
            legend_entry(sample, graph_.words.mentioned_only, pen);
        }
        sample = {};
        sample.box.has_finds = true;
        if (any([](const DrawnBox& b) { return b.has_finds; })) legend_entry(sample, graph_.words.with_finds, pen);
        sample = {};
        sample.box.in_cycle = true;
        sample.box.inner_cycle = true;
        if (any([](const DrawnBox& b) { return b.inner_cycle; })) {
            legend_entry(sample, graph_.words.inner_cycle, pen);
        }
        for (const Mark mark : {Mark::Added, Mark::Removed, Mark::Changed, Mark::Problem}) {
            sample = {};
            sample.box.mark = mark;
            // A box in a cycle is red, also where it is a problem.
            if (any([&](const DrawnBox& b) { return b.mark == mark && (mark != Mark::Problem || !b.in_cycle); }))
                legend_entry(sample, graph_.words.marks.at(static_cast<std::size_t>(mark)), pen);
        }
    }

    void legend_of_lines(DrawPoint& pen) {
        const auto any = [&](auto what) { return std::any_of(drawing_.lines.begin(), drawing_.lines.end(), what); };
        LegendSample sample;
        sample.kind = LegendSample::Kind::Line;
        if (any([](const DrawnLine& l) { return l.uncertain; })) {
            sample.line.uncertain = true;
            legend_entry(sample, graph_.words.uncertain, pen);
        }
        sample.line = {};
        if (any([](const DrawnLine& l) { return l.through; })) {
            sample.line.through = true;
            legend_entry(sample, graph_.words.through, pen);
        }
        sample.line = {};
        if (any([](const DrawnLine& l) { return l.in_cycle; })) {
            sample.line.in_cycle = true;
            legend_entry(sample, graph_.words.in_cycle, pen);
        }
        sample.line = {};
        if (any([](const DrawnLine& l) { return l.upwards && !l.in_cycle && l.mark == Mark::None; })) {
            sample.line.upwards = true;
            legend_entry(sample, graph_.words.against_bands, pen);
        }
        for (const Mark mark : {Mark::Added, Mark::Removed, Mark::Changed}) {
            sample.line = {};
            sample.line.mark = mark;
            if (any([&](const DrawnLine& l) { return l.mark == mark && !l.in_cycle; }))
                legend_entry(sample, graph_.words.marked_orders.at(static_cast<std::size_t>(mark)), pen);
            sample.line.in_cycle = true;
            if (any([&](const DrawnLine& l) { return l.mark == mark && l.in_cycle; })) {
                legend_entry(
                    sample,
                    graph_.words.marked_orders.at(static_cast<std::size_t>(mark)) + ", " + graph_.words.in_cycle, pen);
            }
        }
    }

    void stretch_bands() {
        for (std::size_t i = 0; i < drawing_.bands.size(); ++i) {
            DrawnBand& band = drawing_.bands[i];
            band.rect.x = style::kPageMargin - 8.0;
            band.rect.width = right_ + 8.0 - band.rect.x;
            band.shaded = i % 2 == 0;
            add_text("band", band.heading, {style::kPageMargin, band.rect.y + style::kHeadingSize + 5.0},
                     style::kHeadingSize, FontWeight::Bold);
        }
    }

    void name_frames() {
        for (const DrawnFrame& frame : drawing_.frames) {
            add_text("frame", frame.heading,
                     {frame.rect.x + style::kFramePad, frame.rect.y + style::kFramePad + style::kSmallText},
                     style::kSmallText, FontWeight::Regular);
        }
    }

    void write_title() {
        double y = style::kPageMargin + style::kTitleSize * 0.8;
        for (const std::string& line : title_) {
            add_text("title", line, {style::kPageMargin, y}, style::kTitleSize, FontWeight::Bold);
            y += kTitleLine;
        }
        y += kSubtitleLine - kTitleLine;
        for (const std::string& line : subtitle_) {
            add_text("subtitle", line, {style::kPageMargin, y}, style::kSubtitleSize, FontWeight::Regular);
            y += kSubtitleLine;
        }
    }

    MatrixDrawing& drawing_;
    const DrawnGraph& graph_;
    const TextMeasure& text_;
    std::vector<std::string> title_; // line by line
    std::vector<std::string> subtitle_;
    double right_ = 0.0; // of everything placed so far [pt]
    double bottom_ = 0.0;
};

} // namespace

void finish_page(MatrixDrawing& drawing, const DrawnGraph& graph, const TextMeasure& text) {
    PageMaker(drawing, graph, text).make();
}

PreviousDrawing places_of(const MatrixDrawing& drawing) {
    PreviousDrawing places;
    for (const DrawnBox& box : drawing.boxes) {
        if (box.isolated) continue;
        for (const model::UnitId unit : box.units) places.units.push_back({unit, box.rect.centre()});
    }
    for (const DrawnLine& line : drawing.lines) {
        const DrawnBox& later = drawing.boxes[line.later];
        const DrawnBox& earlier = drawing.boxes[line.earlier];
        if (!later.units.empty() && !earlier.units.empty())
            places.lines.push_back({later.units.front(), earlier.units.front(), line.points});
    }
    return places;
}

} // namespace planum::strat
