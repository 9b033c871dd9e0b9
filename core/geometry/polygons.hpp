// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/gpb.hpp"

namespace planum::geometry {

/// Rectangle of a plan [m]. Empty while low > high.
struct Extent {
    std::array<double, 2> low = {1e300, 1e300};
    std::array<double, 2> high = {-1e300, -1e300};

    [[nodiscard]] bool is_empty() const noexcept { return low[0] > high[0] || low[1] > high[1]; }

    void add(double x, double y) noexcept;
    void add(const Extent& other) noexcept;
    [[nodiscard]] bool meets(const Extent& other, double slack = 0.0) const noexcept;
};

[[nodiscard]] Extent extent(const MultiPolygon& shape) noexcept;

/// Area in plan [m²]: outer rings less holes, whatever way round they run.
[[nodiscard]] double area(const MultiPolygon& shape) noexcept;

/// Signed area of one ring in plan [m²], positive when it runs counter-clockwise.
[[nodiscard]] double signed_area(const Line3& ring) noexcept;

/// Whether a place of the plan lies inside: even-odd over all rings, so holes are outside. Places on a line
/// belong to one side only, the same for all shapes that share the line.
[[nodiscard]] bool contains(const MultiPolygon& shape, double x, double y) noexcept;

/// The pieces of the line y = `y` inside the shape, as pairs of x from west to east; for filling rasters. A
/// place (x, y) is contained exactly when from <= x < to of one of them.
[[nodiscard]] std::vector<std::pair<double, double>> spans_at(const MultiPolygon& shape, double y);

/// Distance in plan from a place to the nearest line of the shape [m]; infinite for an empty shape.
[[nodiscard]] double distance_to_outline(const MultiPolygon& shape, double x, double y) noexcept;

/// Gives points of `shape` that have no height (NaN) the height of the nearest place on the lines of
/// `source`, along the line; 0 where there is none.
void take_heights(MultiPolygon& shape, const MultiPolygon& source);

/// The line without points that lie closer than `tolerance` [m] to what remains, in plan (Douglas and Peucker 1973);
/// both ends stay.
[[nodiscard]] Line3 simplified(const Line3& line, double tolerance);

} // namespace planum::geometry
