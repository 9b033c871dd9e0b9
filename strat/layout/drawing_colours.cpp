// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <vector>

namespace planum::strat {

namespace {

// All bars of a drawing, sorted by height.
class Bars {
  public:
    explicit Bars(const MatrixDrawing& drawing) {
        for (const DrawnLine& line : drawing.lines) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const auto [left, right] = std::minmax(line.points[i - 1].x, line.points[i].x);
                if (line.points[i - 1].y == line.points[i].y) bars_.push_back({line.points[i].y, left, right});
            }
        }
        std::sort(bars_.begin(), bars_.end());
    }

    [[nodiscard]] bool cross_near(const DrawPoint& at, double reach) const {
        const auto first =
            std::partition_point(bars_.begin(), bars_.end(), [&](const Bar& bar) { return bar.y <= at.y - reach; });
        const auto last =
            std::partition_point(first, bars_.end(), [&](const Bar& bar) { return bar.y < at.y + reach; });
        return std::any_of(first, last, [&](const Bar& bar) { return bar.left < at.x && bar.right > at.x; });
    }

  private:
    struct Bar {
        double y;
        double left;
        double right;

        friend auto operator<=>(const Bar&, const Bar&) = default;
    };

    std::vector<Bar> bars_;
};

Colour fill_of(BoxShape shape) noexcept {
    switch (shape) {
    case BoxShape::Deposit: return 0xf7f0de;
    case BoxShape::Cut: return 0xffffff;
    case BoxShape::Structure: return 0xeadfd8;
    case BoxShape::Interface: return 0xeaf1f6;
    case BoxShape::Feature: return 0xe8f0e4;
    case BoxShape::Skeleton: return 0xf6e9ee;
    case BoxShape::Natural: return 0xe0d6bf;
    case BoxShape::Void: return 0xf3f3f3;
    case BoxShape::Unknown: return 0xffffff;
    case BoxShape::Folded: return 0xebeef2;
    }
    return kPaper;
}

Colour colour_of(Mark mark) noexcept {
    switch (mark) {
    case Mark::None: return kLineInk;
    case Mark::Added: return 0x24793b;
    case Mark::Removed: return 0x8d8778;
    case Mark::Changed: return 0x1f5fa8;
    case Mark::Problem: return 0xc65d00;
    }
    return kLineInk;
}

// Added, removed and changed must differ without colour, too.
Dash dash_of(Mark mark) noexcept {
    switch (mark) {
    case Mark::Removed: return Dash::DashDotted;
    case Mark::Changed: return Dash::LongDashed;
    case Mark::None:
    case Mark::Added:
    case Mark::Problem: break;
    }
    return Dash::Solid;
}

} // namespace

std::span<const double> pattern_of(Dash dash) noexcept {
    static constexpr std::array kDashed = {4.0, 2.5};
    static constexpr std::array kDotted = {1.0, 2.0};
    static constexpr std::array kLongDashed = {9.0, 2.0};
    static constexpr std::array kDashDotted = {6.0, 2.5, 1.0, 2.5};
    switch (dash) {
    case Dash::Solid: return {};
    case Dash::Dashed: return kDashed;
    case Dash::Dotted: return kDotted;
    case Dash::LongDashed: return kLongDashed;
    case Dash::DashDotted: return kDashDotted;
    }
    return {};
}

BoxStyle style_of(const DrawnBox& box) noexcept {
    BoxStyle style;
    style.fill = fill_of(box.shape);
    if (box.mentioned_only) style.stroke.dash = Dash::Dashed;
    if (box.mark != Mark::None) {
        style.stroke.colour = colour_of(box.mark);
        style.stroke.width = 1.6;
        if (dash_of(box.mark) != Dash::Solid) style.stroke.dash = dash_of(box.mark);
    }
    if (box.in_cycle) {
        style.stroke.colour = kAlarm;
        style.stroke.width = 1.4;
        style.text = kAlarm;
    }
    return style;
}

StrokeStyle style_of(model::EvidenceVerdict verdict) noexcept {
    switch (verdict) {
    case model::EvidenceVerdict::Confirmed: return {0x1b7f4b, 1.6, Dash::Solid};
    case model::EvidenceVerdict::Contradicted: return {kAlarm, 2.4, Dash::Dashed};
    case model::EvidenceVerdict::Untestable:
    case model::EvidenceVerdict::None: break;
    }
    return {0x8d8a83, 0.7, Dash::Dotted};
}

StrokeStyle style_of(const DrawnLine& line) noexcept {
    if (line.verdict != model::EvidenceVerdict::None) return style_of(line.verdict);
    StrokeStyle style;
    if (line.mark != Mark::None) {
        style.colour = colour_of(line.mark);
        style.width = 1.4;
        style.dash = dash_of(line.mark);
    }
    if (line.in_cycle || (line.upwards && line.mark == Mark::None)) {
        style.colour = line.in_cycle ? kAlarm : kAgainst;
        style.width = line.mark == Mark::None ? 1.1 : 2.2; // wide: what brought the cycle, or changed in it
    }
    if (line.uncertain) style.dash = Dash::Dashed;
    if (line.through) style.dash = Dash::Dotted;
    if (line.mark == Mark::Removed) style.dash = dash_of(line.mark);
    return style;
}

std::vector<DrawPoint> finds_mark(const DrawRect& box) {
    constexpr double kSize = 5.0;
    return {{box.right() - kSize, box.y}, {box.right(), box.y}, {box.right(), box.y + kSize}};
}

void place_arrows(MatrixDrawing& drawing) {
    const auto upwards = [](const DrawnLine& line) { return line.upwards; };
    if (std::none_of(drawing.lines.begin(), drawing.lines.end(), upwards)) return;
    const Bars bars(drawing);
    for (DrawnLine& line : drawing.lines) {
        if (!line.upwards) continue;
        double longest = 0.0;
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const DrawPoint& a = line.points[i - 1];
            const DrawPoint& b = line.points[i];
            const double up = a.y - b.y;
            if (up <= longest || std::abs(a.x - b.x) > up) continue;
            longest = up;
            line.arrow = {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
        }
        if (longest <= 0.0) continue;
        // Away from bars that cross, as near to the middle as can be: a head on a crossing reads as one on the bar.
        constexpr double kClear = 6.0;
        constexpr double kStep = 2.0;
        const double middle = line.arrow.y;
        for (double away = 0.0; away < longest / 2.0 - kClear; away += kStep) {
            const bool above = bars.cross_near({line.arrow.x, middle - away}, kClear);
            const bool below = bars.cross_near({line.arrow.x, middle + away}, kClear);
            if (above && below) continue;
            line.arrow.y = above ? middle + away : middle - away;
            break;
        }
    }
}

std::vector<DrawPoint> arrow_head(const DrawnLine& line) {
    if (!line.upwards) return {};
    constexpr double kHalf = 2.6;
    const DrawPoint& at = line.arrow;
    return {{at.x, at.y - kHalf}, {at.x + kHalf, at.y + kHalf}, {at.x - kHalf, at.y + kHalf}};
}

} // namespace planum::strat
