// SPDX-License-Identifier: MIT
#include "app/regions/region_match.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "app/regions/outline.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

using geometry::MultiPolygon;

constexpr double kSameLine = 5e-4;  ///< points closer than this were not redrawn [m]
constexpr double kSameRegion = 0.5; ///< share of the smaller that lies on the other: one region, drawn anew

bool same_points(const model::Ring& a, const model::Ring& b, std::ptrdiff_t dimensions) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& p, const auto& q) {
        return std::equal(p.begin(), p.begin() + dimensions, q.begin(),
                          [](double x, double y) { return std::abs(x - y) < kSameLine; });
    });
}

} // namespace

bool same_lines(const model::Region& a, const model::Region& b) {
    const std::ptrdiff_t dimensions = a.has_heights && b.has_heights ? 3 : 2;
    const auto same = [&](const model::Ring& one, const model::Ring& other) {
        return same_points(one, other, dimensions);
    };
    return std::equal(a.outline.begin(), a.outline.end(), b.outline.begin(), b.outline.end(),
                      [&](const model::Polygon& one, const model::Polygon& other) {
                          return same(one.outer, other.outer) &&
                                 std::equal(one.holes.begin(), one.holes.end(), other.holes.begin(), other.holes.end(),
                                            same);
                      });
}

bool is_drawn_anew(const model::Record& record, const model::Region& region, const model::Region& other) {
    const model::Section* section = section_of(record, region);
    const auto flat = [&](const model::Region& one) {
        const MultiPolygon shape = shape_of(one.outline);
        return geometry::make_sound(section == nullptr ? shape : onto_plane(shape, *section)).shape;
    };
    try {
        const MultiPolygon newer = flat(region);
        const MultiPolygon older = flat(other);
        if (!geometry::extent(newer).meets(geometry::extent(older))) return false;
        const double both = geometry::area(geometry::intersection(newer, older));
        return both > kSameRegion * std::min(geometry::area(newer), geometry::area(older));
    } catch (const Error&) {
        return false; // what was drawn over in another program may be no valid outline
    }
}

} // namespace planum::app
