// SPDX-License-Identifier: MIT
#include "strat/layout/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

std::vector<DrawPoint> rectangle(const DrawRect& r) {
    return {{r.x, r.y}, {r.right(), r.y}, {r.right(), r.bottom()}, {r.x, r.bottom()}};
}

// Corners cut off by `top` and `bottom` [pt].
std::vector<DrawPoint> chamfered(const DrawRect& r, double top, double bottom) {
    std::vector<DrawPoint> p;
    if (top > 0.0) {
        p.insert(p.end(), {{r.x, r.y + top}, {r.x + top, r.y}, {r.right() - top, r.y}, {r.right(), r.y + top}});
    } else {
        p.insert(p.end(), {{r.x, r.y}, {r.right(), r.y}});
    }
    if (bottom > 0.0) {
        p.insert(p.end(), {{r.right(), r.bottom() - bottom},
                           {r.right() - bottom, r.bottom()},
                           {r.x + bottom, r.bottom()},
                           {r.x, r.bottom() - bottom}});
    } else {
        p.insert(p.end(), {{r.right(), r.bottom()}, {r.x, r.bottom()}});
    }
    return p;
}

std::vector<DrawPoint> upright(double x, const DrawRect& r) { return {{x, r.y}, {x, r.bottom()}}; }

std::vector<DrawPoint> level(double y, const DrawRect& r) { return {{r.x, y}, {r.right(), y}}; }

// A ring that ends in an arrow head: what leads back to where it began. At the left of the label.
std::vector<std::vector<DrawPoint>> turning_arrow(const DrawRect& r) {
    constexpr double kRadius = 3.4;
    constexpr double kHead = 2.6;
    constexpr int kSteps = 15;
    constexpr double kFrom = -60.0; // degrees, clockwise from the right
    constexpr double kTurn = 290.0;
    const DrawPoint centre{r.x + style::kInnerMark, r.centre().y};
    std::vector<DrawPoint> ring;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = (kFrom + kTurn * i / kSteps) * std::numbers::pi / 180.0;
        ring.push_back({centre.x + kRadius * std::cos(angle), centre.y + kRadius * std::sin(angle)});
    }
    const DrawPoint tip = ring.back();
    return {ring, {{tip.x - kHead, tip.y - 0.4}, tip, {tip.x - 0.2, tip.y + kHead}}};
}

} // namespace

BoxOutline outline_of(const DrawnBox& box) {
    const DrawRect& r = box.rect;
    constexpr double kCorner = 5.0;
    constexpr double kDouble = 2.6;
    BoxOutline outline;
    outline.polygon = rectangle(r);
    switch (box.shape) {
    case BoxShape::Deposit: break;
    case BoxShape::Cut: // narrows downwards, as a pit does
        outline.polygon = chamfered(r, 0.0, kCorner);
        break;
    case BoxShape::Structure: // walls stand at both sides
        outline.strokes = {upright(r.x + kDouble, r), upright(r.right() - kDouble, r)};
        outline.stroke_width = 1.2;
        break;
    case BoxShape::Interface: outline.polygon = chamfered(r, kCorner, kCorner); break;
    case BoxShape::Feature: // several units under one number
        outline.strokes = {level(r.y + kDouble, r), level(r.bottom() - kDouble, r)};
        break;
    case BoxShape::Skeleton: outline.polygon = chamfered(r, kCorner, 0.0); break;
    case BoxShape::Natural: // the ground itself
        outline.strokes = {level(r.bottom() - kDouble, r)};
        outline.stroke_width = 1.4;
        break;
    case BoxShape::Void: outline.strokes = {{{r.x, r.bottom()}, {r.right(), r.y}}}; break;
    case BoxShape::Unknown: outline.dashed = box.mentioned_only; break;
    case BoxShape::Folded: // a stack of sheets
        outline.strokes = {{{r.x + kDouble, r.y},
                            {r.x + kDouble, r.y + kDouble},
                            {r.right() - kDouble, r.y + kDouble},
                            {r.right() - kDouble, r.y}},
                           {{r.x + kDouble, r.bottom()},
                            {r.x + kDouble, r.bottom() - kDouble},
                            {r.right() - kDouble, r.bottom() - kDouble},
                            {r.right() - kDouble, r.bottom()}}};
        break;
    }
    if (box.inner_cycle) {
        for (std::vector<DrawPoint>& stroke : turning_arrow(r)) outline.strokes.push_back(std::move(stroke));
    }
    return outline;
}

std::vector<AxisStroke> joined_strokes(std::vector<AxisStroke> strokes, double tolerance) {
    std::sort(strokes.begin(), strokes.end());
    std::vector<AxisStroke> out;
    for (std::size_t first = 0; first < strokes.size();) {
        std::size_t last = first + 1;
        while (last < strokes.size() && strokes[last].at - strokes[last - 1].at < tolerance) ++last;
        const double at = strokes[first].at;
        std::sort(strokes.begin() + static_cast<std::ptrdiff_t>(first),
                  strokes.begin() + static_cast<std::ptrdiff_t>(last),
                  [](const AxisStroke& a, const AxisStroke& b) { return a.low < b.low; });
        const std::size_t line = out.size();
        for (; first < last; ++first) {
            const AxisStroke& s = strokes[first];
            if (out.size() > line && s.low <= out.back().high + tolerance) {
                out.back().high = std::max(out.back().high, s.high);
            } else {
                out.push_back({at, s.low, s.high});
            }
        }
    }
    return out;
}

std::string_view to_word(BoxShape shape) noexcept {
    switch (shape) {
    case BoxShape::Deposit: return "deposit";
    case BoxShape::Cut: return "cut";
    case BoxShape::Structure: return "structure";
    case BoxShape::Interface: return "interface";
    case BoxShape::Feature: return "feature";
    case BoxShape::Skeleton: return "skeleton";
    case BoxShape::Natural: return "natural";
    case BoxShape::Void: return "void";
    case BoxShape::Unknown: return "unknown";
    case BoxShape::Folded: return "folded";
    }
    return {};
}

std::string_view to_word(model::EvidenceVerdict verdict) noexcept {
    switch (verdict) {
    case model::EvidenceVerdict::None: return "";
    case model::EvidenceVerdict::Confirmed: return "confirmed";
    case model::EvidenceVerdict::Contradicted: return "contradicted";
    case model::EvidenceVerdict::Untestable: return "untestable";
    }
    return "";
}

std::string_view to_word(Mark mark) noexcept {
    switch (mark) {
    case Mark::None: return {};
    case Mark::Added: return "added";
    case Mark::Removed: return "removed";
    case Mark::Changed: return "changed";
    case Mark::Problem: return "problem";
    }
    return {};
}

} // namespace planum::strat
