// SPDX-License-Identifier: MIT
#include "app/regions/region_layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "app/regions/outline.hpp"
#include "app/regions/region_names.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

using geometry::MultiPolygon;

constexpr double kInside = 0.95; ///< so much of a region within another: it lies inside, the rest is its line's σ

template<class Map>
MultiPolygon mapped(MultiPolygon shape, Map map) {
    for (auto& rings : shape) {
        for (auto& ring : rings) {
            for (auto& point : ring) point = map(point);
        }
    }
    return shape;
}

MultiPolygon with_height(MultiPolygon shape, double z) {
    return mapped(std::move(shape), [z](const geometry::Point3& p) { return geometry::Point3{p[0], p[1], z}; });
}

struct Axis {
    double x = 0.0;
    double y = 0.0;
};

Axis axis_of(const model::Section& section) {
    const double dx = section.to_in_site[0] - section.from_in_site[0];
    const double dy = section.to_in_site[1] - section.from_in_site[1];
    const double length = std::hypot(dx, dy);
    if (length <= 0.0) throw Error(ErrorCode::BadInput, "section " + section.name + " has no length");
    return {dx / length, dy / length};
}

// What two drawn lines may disagree without anybody meaning it: twice the σ of both.
double line_slack(const model::Region& a, const model::Region& b) { return 2.0 * std::hypot(a.sigma, b.sigma); }

// True when an overlap is no wider than the slack of the lines anywhere.
bool is_sliver(const MultiPolygon& overlap, double slack) { return geometry::offset(overlap, -0.5 * slack).empty(); }

class Layer {
  public:
    Layer(const std::vector<const model::Region*>& regions, const model::Section* section) {
        for (const model::Region* region : regions) {
            try {
                MultiPolygon shape = shape_of(region->outline);
                if (section != nullptr) shape = onto_plane(shape, *section);
                PlacedRegion placed{region, geometry::make_sound(shape).shape, {}};
                placed.shown = placed.drawn;
                layout_.regions.push_back(std::move(placed));
            } catch (const Error&) {
                layout_.unusable.push_back(region);
            }
        }
    }

    RegionLayout lay() {
        const std::size_t n = layout_.regions.size();
        std::vector<geometry::Extent> boxes;
        for (const PlacedRegion& placed : layout_.regions) {
            boxes.push_back(geometry::extent(placed.drawn));
            areas_.push_back(geometry::area(placed.drawn));
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                if (boxes[i].meets(boxes[j])) settle(i, j);
            }
        }
        return std::move(layout_);
    }

  private:
    void settle(std::size_t i, std::size_t j) {
        const std::size_t large = areas_[i] >= areas_[j] ? i : j;
        const std::size_t small = large == i ? j : i;
        PlacedRegion& above = layout_.regions[small];
        PlacedRegion& below = layout_.regions[large];
        const MultiPolygon both = geometry::intersection(above.drawn, below.drawn);
        const double area = geometry::area(both);
        if (area <= 0.0) return;
        const bool same_size = areas_[small] > kInside * areas_[large];
        const bool inside = area > kInside * areas_[small] && !same_size;
        if (inside || is_sliver(both, line_slack(*above.region, *below.region))) {
            below.shown = geometry::difference(below.shown, above.drawn);
            return;
        }
        layout_.overlaps.push_back({layout_.regions[i].region, layout_.regions[j].region, both, area});
        below.shown = geometry::difference(below.shown, both);
        above.shown = geometry::difference(above.shown, both);
    }

    RegionLayout layout_;
    std::vector<double> areas_;
};

} // namespace

RegionLayout layout_regions(const std::vector<const model::Region*>& regions, const model::Section* section) {
    return Layer(regions, section).lay();
}

std::vector<const model::Region*> regions_on(const model::Record& record, model::SurfaceId surface) {
    std::vector<const model::Region*> found;
    for (const model::Region& region : record.regions) {
        if (!surface.is_nil() && region.surface == surface) found.push_back(&region);
    }
    return found;
}

std::vector<const model::Region*> regions_on(const model::Record& record, model::SectionId section) {
    std::vector<const model::Region*> found;
    for (const model::Region& region : record.regions) {
        if (region.surface.is_nil() && region.section == section) found.push_back(&region);
    }
    return found;
}

double region_area(const model::Record& record, const model::Region& region) {
    const MultiPolygon shape = shape_of(region.outline);
    if (!region.surface.is_nil()) return geometry::area(shape);
    const model::Section* section = section_of(record, region);
    return section == nullptr ? 0.0 : geometry::area(onto_plane(shape, *section));
}

MultiPolygon onto_plane(const MultiPolygon& in_site, const model::Section& section) {
    const Axis axis = axis_of(section);
    return mapped(in_site, [&](const geometry::Point3& p) -> geometry::Point3 {
        const double x = p[0] - section.from_in_site[0];
        const double y = p[1] - section.from_in_site[1];
        return {x * axis.x + y * axis.y, p[2], y * axis.x - x * axis.y};
    });
}

MultiPolygon from_plane(const MultiPolygon& on_plane, const model::Section& section) {
    const Axis axis = axis_of(section);
    return mapped(on_plane, [&](const geometry::Point3& p) -> geometry::Point3 {
        return {section.from_in_site[0] + p[0] * axis.x - p[2] * axis.y,
                section.from_in_site[1] + p[0] * axis.y + p[2] * axis.x, p[1]};
    });
}

MultiPolygon shape_of(const std::vector<model::Polygon>& outline) {
    MultiPolygon shape;
    for (const model::Polygon& polygon : outline) {
        geometry::Rings rings = {polygon.outer};
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
        shape.push_back(std::move(rings));
    }
    return shape;
}

MultiPolygon shape_with_heights(const model::Region& region) {
    MultiPolygon shape = shape_of(region.outline);
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return region.has_heights ? shape : with_height(std::move(shape), kUnknown);
}

bool settle_heights(MultiPolygon& shape) {
    bool all = true;
    MultiPolygon known; // rings of the points with heights, for these lie on the lines
    for (const geometry::Rings& rings : shape) {
        geometry::Rings& kept = known.emplace_back();
        for (const geometry::Line3& ring : rings) {
            geometry::Line3& points = kept.emplace_back();
            std::copy_if(ring.begin(), ring.end(), std::back_inserter(points),
                         [](const geometry::Point3& p) { return !std::isnan(p[2]); });
            all = all && points.size() == ring.size();
            if (points.empty()) kept.pop_back();
        }
    }
    if (all) return true;
    const bool none =
        std::all_of(known.begin(), known.end(), [](const geometry::Rings& rings) { return rings.empty(); });
    if (!none) {
        geometry::take_heights(shape, known);
        return true;
    }
    shape = with_height(std::move(shape), 0.0);
    return false;
}

std::vector<model::Polygon> outline_of(const MultiPolygon& shape) {
    std::vector<model::Polygon> outline;
    for (const geometry::Rings& rings : shape) {
        if (!rings.empty()) outline.push_back({rings.front(), {rings.begin() + 1, rings.end()}});
    }
    return outline;
}

} // namespace planum::app
