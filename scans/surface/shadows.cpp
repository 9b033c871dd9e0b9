// SPDX-License-Identifier: MIT
#include "scans/surface/shadows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planum::scans {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

} // namespace

double usual_share(const GridFrame& frame, const std::vector<float>& top) {
    constexpr std::int32_t kReach = 5;
    std::vector<double> shares;
    const std::size_t step = std::max<std::size_t>(1, frame.cells() / 20000);
    for (std::size_t cell = 0; cell < frame.cells(); cell += step) {
        if (std::isnan(top[cell])) continue;
        const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame.columns));
        const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame.columns));
        if (row < kReach || column < kReach || row + kReach >= frame.rows || column + kReach >= frame.columns) continue;
        int seen = 0;
        for (std::int32_t r = row - kReach; r <= row + kReach; ++r) {
            for (std::int32_t c = column - kReach; c <= column + kReach; ++c)
                seen += std::isnan(top[frame.at(r, c)]) ? 0 : 1;
        }
        constexpr double kCells = (2.0 * kReach + 1.0) * (2.0 * kReach + 1.0);
        shares.push_back(seen / kCells);
    }
    if (shares.empty()) return 1.0;
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::nth_element(shares.begin(), middle, shares.end());
    return *middle;
}

void widen(const GridFrame& frame, ScanSight& seen) {
    seen.spacing = frame.cell / std::sqrt(usual_share(frame, seen.top));
    const auto reach = static_cast<std::int32_t>(std::lround(1.5 * (seen.spacing / frame.cell - 1.0)));
    seen.widened = reach * frame.cell;
    if (reach <= 0) return;
    constexpr std::int32_t kSparsest = 6;
    if (reach > kSparsest) { // between points so far apart nothing is an edge
        seen.top.assign(seen.top.size(), kUnknown);
        return;
    }
    const ScanSight points = seen;
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (!std::isnan(points.top[cell])) continue;
            double nearest = 1e30;
            for (std::int32_t r = std::max(0, row - reach); r <= std::min(frame.rows - 1, row + reach); ++r) {
                for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame.columns - 1, column + reach);
                     ++c) {
                    const std::size_t other = frame.at(r, c);
                    const double distance = std::hypot(r - row, c - column);
                    if (std::isnan(points.top[other]) || distance >= nearest || distance > reach) continue;
                    nearest = distance;
                    seen.top[cell] = points.top[other];
                    seen.bottom[cell] = points.bottom[other];
                }
            }
        }
    }
}

Shadows::Shadows(const GridFrame& frame, const ScanSight& seen, const std::vector<bool>& near_sides,
                 const Eigen::Vector3d& station, const SightRules& rules)
    : frame_(frame), seen_(seen), near_sides_(near_sides), station_(station), rules_(rules) {}

bool Shadows::are_of_one_station() const {
    constexpr std::size_t kSamples = 5000;
    const std::size_t step = std::max<std::size_t>(1, frame_.cells() / kSamples / 4);
    std::size_t judged = 0;
    std::size_t hidden = 0;
    for (std::size_t cell = 0; cell < frame_.cells(); cell += step) {
        if (std::isnan(seen_.top[cell])) continue;
        const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame_.columns));
        const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame_.columns));
        const auto line = highest_line(row, column);
        if (!line) continue;
        ++judged;
        if (static_cast<double>(seen_.top[cell]) < *line - rules_.least_drop) ++hidden;
    }
    return static_cast<double>(hidden) <= rules_.hidden * static_cast<double>(judged);
}

std::optional<SightLine> Shadows::over(std::int32_t row, std::int32_t column) const {
    const Way way = way_to(row, column);
    if (!(way.distance >= 2.0 * frame_.cell)) return std::nullopt;
    const auto behind = first_seen(row, column, {rules_.farthest, way.east, way.north}, Sides::Stop);
    if (!behind) return std::nullopt;
    const double most = std::min(rules_.farthest, way.distance - frame_.cell);
    const auto before = first_seen(row, column, {most, -way.east, -way.north}, Sides::Pass);
    if (!before) return std::nullopt;
    const auto edge = static_cast<double>(seen_.top[before->cell]);
    if (static_cast<double>(seen_.bottom[behind->cell]) > edge - rules_.least_drop) return std::nullopt;
    // On average the edge lies half the way between points beyond the last of them.
    const double from_edge = before->distance + seen_.widened - 0.5 * (seen_.spacing - frame_.cell);
    if (from_edge <= 0.0) return std::nullopt; // may belong to the edge
    const double tangent = (edge - station_.z()) / (way.distance - from_edge);
    return SightLine{station_.z() + tangent * way.distance, -tangent};
}

bool Shadows::goes_on_at(double height, std::int32_t row, std::int32_t column) const {
    const Way way = way_to(row, column);
    int alike = 0;
    for (double gone = frame_.cell; gone < rules_.farthest; gone += frame_.cell) {
        const auto cell = cell_at(row, column, gone * way.east, gone * way.north);
        if (!cell) return false;
        if (std::isnan(seen_.top[*cell])) continue;
        const double above = static_cast<double>(seen_.top[*cell]) - height;
        const double below = height - static_cast<double>(seen_.bottom[*cell]);
        if (std::abs(above) > rules_.rough || std::abs(below) > rules_.rough) return false;
        if (++alike == 2) return true;
    }
    return false;
}

Shadows::Way Shadows::way_to(std::int32_t row, std::int32_t column) const {
    const double east = frame_.x(column) - station_.x();
    const double north = frame_.y(row) - station_.y();
    const double distance = std::hypot(east, north);
    return {distance, east / distance, north / distance};
}

/// The highest line of sight over a cell of those past all that was seen nearer.
std::optional<double> Shadows::highest_line(std::int32_t row, std::int32_t column) const {
    const Way way = way_to(row, column);
    std::optional<double> tangent;
    for (double back = 2.0 * frame_.cell; back < std::min(rules_.farthest, way.distance - frame_.cell);
         back += frame_.cell) {
        const auto cell = cell_at(row, column, -back * way.east, -back * way.north);
        if (!cell) break;
        if (std::isnan(seen_.bottom[*cell])) continue;
        const double rise = (static_cast<double>(seen_.bottom[*cell]) - station_.z()) / (way.distance - back);
        if (!tangent || rise > *tangent) tangent = rise;
    }
    if (!tangent) return std::nullopt;
    return station_.z() + *tangent * way.distance;
}

std::optional<std::size_t> Shadows::cell_at(std::int32_t row, std::int32_t column, double east, double north) const {
    const auto c = column + static_cast<std::int32_t>(std::lround(east / frame_.cell));
    const auto r = row + static_cast<std::int32_t>(std::lround(north / frame_.cell));
    if (r < 0 || c < 0 || r >= frame_.rows || c >= frame_.columns) return std::nullopt;
    return frame_.at(r, c);
}

std::optional<Shadows::Met> Shadows::first_seen(std::int32_t row, std::int32_t column, const Way& way,
                                                Sides sides) const {
    for (double gone = frame_.cell; gone < way.distance; gone += frame_.cell) {
        const auto cell = cell_at(row, column, gone * way.east, gone * way.north);
        if (!cell) return std::nullopt;
        if (!std::isnan(seen_.top[*cell])) return Met{*cell, gone};
        if (sides == Sides::Stop && near_sides_[*cell]) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace planum::scans
