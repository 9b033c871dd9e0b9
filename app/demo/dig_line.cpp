// SPDX-License-Identifier: MIT
#include "app/demo/dig_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace planum::app::demo {

namespace {

constexpr double kTolerance = 0.35; ///< of the simplification [cells]

LinePoint middle_of(Corner a, Corner b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

double distance_to(const LinePoint& p, const LinePoint& a, const LinePoint& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    if (length < 1e-12) return std::hypot(p.x - a.x, p.y - a.y);
    return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

// Douglas and Peucker 1973, without recursion. Keeps both ends.
std::vector<LinePoint> fewer_points(const std::vector<LinePoint>& line) {
    std::vector<bool> keep(line.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double farthest = kTolerance;
        std::size_t at = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double distance = distance_to(line[i], line[from], line[to]);
            if (distance > farthest) {
                farthest = distance;
                at = i;
            }
        }
        if (at == 0) continue;
        keep[at] = true;
        open.emplace_back(from, at);
        open.emplace_back(at, to);
    }
    std::vector<LinePoint> kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (keep[i]) kept.push_back(line[i]);
    }
    return kept;
}

void smooth(std::vector<LinePoint>& line) {
    for (int pass = 0; pass < 2; ++pass) {
        std::vector<LinePoint> next = line;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            next[i] = {0.25 * (line[i - 1].x + 2.0 * line[i].x + line[i + 1].x),
                       0.25 * (line[i - 1].y + 2.0 * line[i].y + line[i + 1].y)};
        }
        line = std::move(next);
    }
}

} // namespace

std::vector<LinePoint> simplified_piece(std::vector<Corner> piece) {
    std::vector<Corner> reversed(piece.rbegin(), piece.rend());
    const bool turned = reversed < piece;
    if (turned) piece = std::move(reversed);
    std::vector<LinePoint> line = {{static_cast<double>(piece.front().x), static_cast<double>(piece.front().y)}};
    for (std::size_t i = 1; i < piece.size(); ++i) line.push_back(middle_of(piece[i - 1], piece[i]));
    line.push_back({static_cast<double>(piece.back().x), static_cast<double>(piece.back().y)});
    smooth(line);
    line = fewer_points(line);
    if (turned) std::reverse(line.begin(), line.end());
    return line;
}

std::vector<LinePoint> simplified_loop(std::vector<Corner> ring) {
    // Begin at the lowest corner and go the way of the lower neighbour, whichever side it is drawn from.
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    const bool turned = ring.back() < ring[1];
    if (turned) std::reverse(ring.begin() + 1, ring.end());
    std::vector<LinePoint> line;
    for (std::size_t i = 0; i < ring.size(); ++i) line.push_back(middle_of(ring[i], ring[(i + 1) % ring.size()]));
    line.push_back(line.front());
    smooth(line);
    // Two halves, so that the simplification has ends to hold on to.
    const auto half = static_cast<std::ptrdiff_t>(line.size() / 2);
    std::vector<LinePoint> first = fewer_points({line.begin(), line.begin() + half + 1});
    const std::vector<LinePoint> second = fewer_points({line.begin() + half, line.end()});
    first.insert(first.end(), second.begin() + 1, second.end());
    first.pop_back();
    if (turned) std::reverse(first.begin(), first.end());
    return first;
}

} // namespace planum::app::demo
