// SPDX-License-Identifier: MIT
#include "scans/surface/label_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/geometry/polygons.hpp"
#include "scans/surface/cells_within.hpp"

namespace planum::scans {

namespace {

using geometry::Point3;

// First column whose middle is not west of x.
std::int32_t column_from(const GridFrame& frame, double x) {
    const double column = std::ceil(x / frame.cell - static_cast<double>(frame.west) - 0.5);
    return static_cast<std::int32_t>(std::clamp(column, 0.0, static_cast<double>(frame.columns)));
}

std::int32_t row_from(const GridFrame& frame, double y) {
    const double row = std::ceil(y / frame.cell - static_cast<double>(frame.south) - 0.5);
    return static_cast<std::int32_t>(std::clamp(row, 0.0, static_cast<double>(frame.rows)));
}

double distance_to_piece(const Point3& a, const Point3& b, double x, double y) {
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double length2 = dx * dx + dy * dy;
    const double along = length2 > 0.0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(x - a[0] - along * dx, y - a[1] - along * dy);
}

// Exact distances, one piece of line at a time, over the cells it can be nearest to.
void measure(LabelGrid& grid, const Point3& a, const Point3& b) {
    const GridFrame& frame = grid.frame;
    const double far = static_cast<double>(kFarFromOutlines);
    const std::int32_t row_end = row_from(frame, std::max(a[1], b[1]) + far);
    const std::int32_t column_begin = column_from(frame, std::min(a[0], b[0]) - far);
    const std::int32_t column_end = column_from(frame, std::max(a[0], b[0]) + far);
    for (std::int32_t row = row_from(frame, std::min(a[1], b[1]) - far); row < row_end; ++row) {
        for (std::int32_t column = column_begin; column < column_end; ++column) {
            float& now = grid.outline_distance[frame.at(row, column)];
            now = std::min(now, static_cast<float>(distance_to_piece(a, b, frame.x(column), frame.y(row))));
        }
    }
}

geometry::Line3 line_of(const model::Ring& ring) { return {ring.begin(), ring.end()}; }

} // namespace

geometry::MultiPolygon shape_of(const model::Region& region) {
    geometry::MultiPolygon shape;
    for (const model::Polygon& polygon : region.outline) {
        geometry::Rings rings = {line_of(polygon.outer)};
        std::transform(polygon.holes.begin(), polygon.holes.end(), std::back_inserter(rings), line_of);
        shape.push_back(std::move(rings));
    }
    return shape;
}

LabelGrid label_cells(const GridFrame& frame, std::span<const model::Region> regions) {
    LabelGrid grid;
    grid.frame = frame;
    grid.region.assign(frame.cells(), kNoRegion);
    grid.outline_distance.assign(frame.cells(), kFarFromOutlines);
    std::vector<geometry::MultiPolygon> shapes(regions.size());
    std::vector<double> areas(regions.size(), 0.0);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (!regions[i].section.is_nil()) continue;
        shapes[i] = shape_of(regions[i]);
        areas[i] = geometry::area(shapes[i]);
    }
    std::vector<std::size_t> order(regions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
    for (const std::size_t i : order) {
        for_cells_within(frame, shapes[i], [&](std::size_t cell) { grid.region[cell] = static_cast<std::int32_t>(i); });
        for (const geometry::Rings& rings : shapes[i]) {
            for (const geometry::Line3& ring : rings) {
                for (std::size_t p = 0; p < ring.size(); ++p) measure(grid, ring[p], ring[(p + 1) % ring.size()]);
            }
        }
    }
    return grid;
}

} // namespace planum::scans
