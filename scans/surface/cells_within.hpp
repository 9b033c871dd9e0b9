// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/geometry/polygons.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// Calls visit(cell) for every cell of the frame whose middle lies within the outline (site, plan), row by row.
template<class Visit>
void for_cells_within(const GridFrame& frame, const geometry::MultiPolygon& outline, const Visit& visit) {
    // First column, or row, whose middle does not lie before the place.
    const auto first = [&](double at, std::int64_t origin, std::int32_t count) {
        const double cell = std::ceil(at / frame.cell - static_cast<double>(origin) - 0.5);
        return static_cast<std::int32_t>(std::clamp(cell, 0.0, static_cast<double>(count)));
    };
    const geometry::Extent extent = geometry::extent(outline);
    if (extent.is_empty()) return;
    const std::int32_t end = first(extent.high[1], frame.south, frame.rows);
    for (std::int32_t row = first(extent.low[1], frame.south, frame.rows); row < end; ++row) {
        for (const auto& [from, to] : geometry::spans_at(outline, frame.y(row))) {
            const std::int32_t last = first(to, frame.west, frame.columns);
            for (std::int32_t column = first(from, frame.west, frame.columns); column < last; ++column)
                visit(frame.at(row, column));
        }
    }
}

} // namespace planum::scans
