// SPDX-License-Identifier: MIT
#include "core/geometry/polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace planum::geometry {

namespace {

// Calls visit(a, b) for every edge of every ring.
template<class Visit>
void for_edges(const MultiPolygon& shape, Visit visit) {
    for (const Rings& rings : shape) {
        for (const Line3& ring : rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
        }
    }
}

// Where the edge a–b crosses y, in the same arithmetic whichever way round the edge is given, so that two
// shapes that share a line agree on every place.
double crossing(const Point3& a, const Point3& b, double y) noexcept {
    const Point3& low = a[1] < b[1] ? a : b;
    const Point3& high = a[1] < b[1] ? b : a;
    return low[0] + (y - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
}

bool crosses(const Point3& a, const Point3& b, double y) noexcept { return (a[1] <= y) != (b[1] <= y); }

struct NearestOnEdge {
    double distance2 = std::numeric_limits<double>::infinity();
    double z = 0.0;

    void offer(const Point3& a, const Point3& b, double x, double y) noexcept {
        const double dx = b[0] - a[0];
        const double dy = b[1] - a[1];
        const double length2 = dx * dx + dy * dy;
        const double along = length2 > 0.0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
        const double ex = a[0] + along * dx - x;
        const double ey = a[1] + along * dy - y;
        const double d2 = ex * ex + ey * ey;
        if (d2 >= distance2) return;
        distance2 = d2;
        z = a[2] + along * (b[2] - a[2]);
    }
};

NearestOnEdge nearest_on_outline(const MultiPolygon& shape, double x, double y) noexcept {
    NearestOnEdge nearest;
    for_edges(shape, [&](const Point3& a, const Point3& b) { nearest.offer(a, b, x, y); });
    return nearest;
}

} // namespace

void Extent::add(double x, double y) noexcept {
    low = {std::min(low[0], x), std::min(low[1], y)};
    high = {std::max(high[0], x), std::max(high[1], y)};
}

void Extent::add(const Extent& other) noexcept {
    if (other.is_empty()) return;
    add(other.low[0], other.low[1]);
    add(other.high[0], other.high[1]);
}

bool Extent::meets(const Extent& other, double slack) const noexcept {
    return low[0] <= other.high[0] + slack && other.low[0] <= high[0] + slack && low[1] <= other.high[1] + slack &&
           other.low[1] <= high[1] + slack;
}

Extent extent(const MultiPolygon& shape) noexcept {
    Extent box;
    for (const Rings& rings : shape) {
        if (rings.empty()) continue;
        for (const Point3& p : rings.front()) box.add(p[0], p[1]);
    }
    return box;
}

double signed_area(const Line3& ring) noexcept {
    double sum = 0.0; // about the first point: site coordinates may be millions of metres
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        sum += (ring[i][0] - ring[0][0]) * (ring[i + 1][1] - ring[0][1]) -
               (ring[i + 1][0] - ring[0][0]) * (ring[i][1] - ring[0][1]);
    }
    return 0.5 * sum;
}

double area(const MultiPolygon& shape) noexcept {
    double sum = 0.0;
    for (const Rings& rings : shape) {
        for (std::size_t i = 0; i < rings.size(); ++i) {
            const double ring = std::abs(signed_area(rings[i]));
            sum += i == 0 ? ring : -ring;
        }
    }
    return sum;
}

bool contains(const MultiPolygon& shape, double x, double y) noexcept {
    bool inside = false;
    for_edges(shape, [&](const Point3& a, const Point3& b) {
        if (crosses(a, b, y) && crossing(a, b, y) <= x) inside = !inside;
    });
    return inside;
}

std::vector<std::pair<double, double>> spans_at(const MultiPolygon& shape, double y) {
    std::vector<double> at;
    for_edges(shape, [&](const Point3& a, const Point3& b) {
        if (crosses(a, b, y)) at.push_back(crossing(a, b, y));
    });
    std::sort(at.begin(), at.end());
    std::vector<std::pair<double, double>> spans;
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) spans.emplace_back(at[i], at[i + 1]);
    return spans;
}

double distance_to_outline(const MultiPolygon& shape, double x, double y) noexcept {
    return std::sqrt(nearest_on_outline(shape, x, y).distance2);
}

void take_heights(MultiPolygon& shape, const MultiPolygon& source) {
    for (Rings& rings : shape) {
        for (Line3& ring : rings) {
            for (Point3& p : ring) {
                if (std::isnan(p[2])) p[2] = nearest_on_outline(source, p[0], p[1]).z;
            }
        }
    }
}

Line3 simplified(const Line3& line, double tolerance) {
    if (line.size() < 3) return line;
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double farthest2 = tolerance * tolerance;
        std::size_t at = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            NearestOnEdge chord;
            chord.offer(line[from], line[to], line[i][0], line[i][1]);
            if (chord.distance2 <= farthest2) continue;
            farthest2 = chord.distance2;
            at = i;
        }
        if (at == 0) continue;
        kept[at] = true;
        open.emplace_back(from, at);
        open.emplace_back(at, to);
    }
    Line3 rest;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (kept[i]) rest.push_back(line[i]);
    }
    return rest;
}

} // namespace planum::geometry
