// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/demo/simulator_composer.hpp"

namespace planum::app::demo {

namespace {

constexpr double kGone = 0.3; ///< as in simulator_composer.cpp [m]

} // namespace

CutShape SiteComposer::foundation(double x, double y, double axis_x, double axis_y, double half_length) {
    CutShape trench;
    trench.plan = Plan::Linear;
    trench.x = x;
    trench.y = y;
    trench.axis_x = axis_x;
    trench.axis_y = axis_y;
    trench.half_length = half_length;
    trench.radius = 0.34;
    trench.wobble = {0.03, draw_.unit(), 0.0};
    trench.mouth = soil_.at(x, y);
    trench.base = trench.mouth - draw_.between(0.3, 0.42);
    for (double t = -half_length; t <= half_length; t += 0.3) {
        taken_.push_back({x + t * axis_x, y + t * axis_y, 0.35, -1, true});
    }
    return trench;
}

WallShape SiteComposer::wall_on(const CutShape& trench) {
    WallShape wall;
    wall.x = trench.x;
    wall.y = trench.y;
    wall.axis_x = trench.axis_x;
    wall.axis_y = trench.axis_y;
    wall.half_length = trench.half_length - 0.06;
    wall.half_width = draw_.between(0.2, 0.25);
    wall.footing_half = trench.radius + 0.1; // to the sides of the trench
    wall.base = trench.base - 0.02;
    wall.footing_top = trench.mouth - 0.02;
    wall.top = std::min(trench.mouth + draw_.between(0.25, 0.5), turf_height(site_, seed_, trench.x, trench.y) - 0.25);
    wall.seed = draw_.next();
    return wall;
}

void SiteComposer::wall(bool pair, int phase) {
    const double width = site_.trench.high.x - site_.trench.low.x;
    const double depth = site_.trench.high.y - site_.trench.low.y;
    const double angle = draw_.between(-0.12, 0.12);
    const double axis_x = std::cos(angle);
    const double axis_y = std::sin(angle);
    const double half_length = std::min(2.4, 0.27 * width);
    const double x = site_.trench.low.x + draw_.between(0.35, 0.6) * width;
    const double y = site_.trench.low.y + (pair ? draw_.between(0.25, 0.4) : draw_.between(0.66, 0.76)) * depth;
    const CutShape trench = foundation(x, y, axis_x, axis_y, half_length);
    const UnitNo cut = add_cut(trench, "foundation trench", phase);
    WallShape first = wall_on(trench);
    if (!pair) {
        add_wall(first, cut, phase);
        return;
    }
    // A corner: the second wall starts where the first one ends, and both were built in one go.
    const double half = std::min(1.6, 0.2 * depth);
    const double end_x = x + axis_x * (half_length - 0.3) - axis_y * (half + 0.3);
    const double end_y = y + axis_y * (half_length - 0.3) + axis_x * (half + 0.3);
    CutShape other = foundation(end_x, end_y, -axis_y, axis_x, half);
    other.base = trench.base;
    const UnitNo other_cut = add_cut(other, "foundation trench", phase);
    WallShape second = wall_on(other);
    first.footing_half = 0.27; // leaves room for the fill of its trench
    second.top = first.top;
    second.half_length += 0.1;
    const UnitNo a = add_wall(first, cut, phase);
    const UnitNo b = add_wall(second, other_cut, phase);
    units_[static_cast<std::size_t>(a)].bonded = b;
    units_[static_cast<std::size_t>(b)].bonded = a;
    add_fills(trench, cut, 1, phase);
    units_.back().title = "fill of the foundation trench";
}

void SiteComposer::floor(int phase) {
    // Beside the wall built last, if there is one; a rectangle with blurred edges.
    double x = 0.5 * (site_.trench.low.x + site_.trench.high.x);
    double y = site_.trench.low.y + 0.35 * (site_.trench.high.y - site_.trench.low.y);
    double axis_x = 1.0;
    double axis_y = 0.0;
    double away = 0.0;
    for (const FormationEvent& event : events_) {
        if (event.type != FormationEvent::Type::Structure) continue;
        x = event.wall.x;
        y = event.wall.y;
        axis_x = event.wall.axis_x;
        axis_y = event.wall.axis_y;
        away = event.wall.half_width;
    }
    const double half_long = draw_.between(0.85, 1.1);
    const double half_wide = draw_.between(0.5, 0.7);
    // On the side of the wall where the trench has more room.
    const double middle = 0.5 * (site_.trench.low.y + site_.trench.high.y);
    const double side = (middle - y) * axis_x >= 0.0 ? 1.0 : -1.0;
    x -= side * axis_y * (away + half_wide - 0.05);
    y += side * axis_x * (away + half_wide - 0.05);
    const std::uint64_t key = draw_.next();
    const double thickness = draw_.between(0.028, 0.04);
    HeightTable top({{x - 1.5, y - 1.5, 0.0}, {x + 1.5, y + 1.5, 0.0}}, site_.table_step);
    top.fill([&](double px, double py) {
        const double along = std::abs((px - x) * axis_x + (py - y) * axis_y);
        const double across = std::abs((py - y) * axis_x - (px - x) * axis_y);
        const double edge = 0.08 * noise(key, px / 0.4, py / 0.4);
        const bool inside = along < half_long + edge && across < half_wide + edge;
        const double ground = soil_.at(px, py);
        return inside ? ground + thickness + 0.003 * noise(mix(key, 1), px / 0.3, py / 0.3) : ground - kGone;
    });
    settle(top);
    FormedUnit unit;
    unit.title = "thin floor of beaten lime";
    unit.phase = phase;
    unit.thin = true;
    add_deposit(std::move(top), std::move(unit));
}

void SiteComposer::mound(int phase) {
    constexpr std::array kMounds = {"heap of rubble and mortar", "dump of clay", "bank of redeposited gravel"};
    const double width = site_.trench.high.x - site_.trench.low.x;
    const double depth = site_.trench.high.y - site_.trench.low.y;
    const double x = site_.trench.low.x + draw_.between(0.25, 0.75) * width;
    const double y = site_.trench.low.y + draw_.between(0.3, 0.7) * depth;
    const double a = draw_.between(0.2, 0.28) * std::min(width, 8.0);
    const double b = draw_.between(0.2, 0.28) * std::min(depth, 8.0);
    const double height = draw_.between(0.22, 0.34);
    const std::uint64_t key = draw_.next();
    HeightTable top({{x - 1.6 * a, y - 1.6 * b, 0.0}, {x + 1.6 * a, y + 1.6 * b, 0.0}}, site_.table_step);
    top.fill([&](double px, double py) {
        const double u = (px - x) / a;
        const double v = (py - y) / b;
        const double r2 = (u * u + v * v) * (1.0 + 0.25 * noise(key, px / 0.8, py / 0.8));
        const double ground = soil_.at(px, py);
        const double rise = r2 < 1.0 ? height * (1.0 - r2) : -kGone;
        const double rough = 0.012 * noise(mix(key, 1), px / 0.15, py / 0.15);
        return std::min(ground + rise + (r2 < 1.0 ? rough : 0.0), turf_height(site_, seed_, px, py) - 0.1);
    });
    settle(top);
    FormedUnit unit;
    unit.title = kMounds[static_cast<std::size_t>(draw_.below(static_cast<int>(kMounds.size())))];
    unit.phase = phase;
    add_deposit(std::move(top), std::move(unit));
}

} // namespace planum::app::demo
