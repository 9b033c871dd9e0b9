// SPDX-License-Identifier: MIT
#include "app/regions/region_points.hpp"

#include <algorithm>
#include <cstddef>

#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

using geometry::MultiPolygon;

constexpr double kAboveOutline = 1.0; ///< [m]
constexpr double kBesidePlane = 0.05; ///< [m]

geometry::Rigid3 plane_from_site(const model::Section& section) {
    const Eigen::Vector2d from(section.from_in_site[0], section.from_in_site[1]);
    const Eigen::Vector2d along = (Eigen::Vector2d(section.to_in_site[0], section.to_in_site[1]) - from).normalized();
    geometry::Rigid3 frame;
    frame.rotation << along.x(), along.y(), 0.0, 0.0, 0.0, 1.0, along.y(), -along.x(), 0.0;
    frame.translation = -(frame.rotation * Eigen::Vector3d(from.x(), from.y(), 0.0));
    return frame;
}

RegionGround ground_of(const PlacedRegion& placed, const model::Section* section) {
    RegionGround ground{placed.shown, {}, -1e9, 1e9};
    if (section != nullptr) {
        ground.frame_from_site = plane_from_site(*section);
        ground.low = -kBesidePlane;
        ground.high = kBesidePlane;
        return ground;
    }
    if (!placed.region->has_heights) return ground;
    double highest = -1e9;
    for (const auto& rings : placed.shown) {
        for (const auto& ring : rings) {
            for (const auto& p : ring) highest = std::max(highest, p[2]);
        }
    }
    ground.high = highest + kAboveOutline;
    return ground;
}

} // namespace

bool may_show(const model::Record& record, const model::Scan& scan, const model::Region& region) {
    for (const model::Surface& surface : record.surfaces) {
        if (!region.surface.is_nil() && surface.id == region.surface) return may_show(record, scan, surface);
    }
    const model::Section* section = section_of(record, region);
    return section != nullptr && (section->day.empty() || section->day == scan.day);
}

std::vector<RegionGround> region_grounds(const model::Record& record) {
    std::vector<RegionGround> grounds(record.regions.size());
    const auto take = [&](const RegionLayout& layout, const model::Section* section) {
        for (const PlacedRegion& placed : layout.regions) {
            grounds[static_cast<std::size_t>(placed.region - record.regions.data())] = ground_of(placed, section);
        }
    };
    for (const model::Surface& surface : record.surfaces) {
        take(layout_regions(regions_on(record, surface.id)), nullptr);
    }
    for (const model::Section& section : record.sections) {
        take(layout_regions(regions_on(record, section.id), &section), &section);
    }
    return grounds;
}

void for_points_on(const RegionGround& ground, const std::vector<PlacedScan>& scans,
                   const std::function<void(const RegionPoint&)>& visit) {
    for (const PlacedScan& placed : scans) {
        const geometry::Rigid3 frame_from_scan = ground.frame_from_site * placed.site_from_scan;
        for (const geometry::Rings& rings : ground.shape) {
            scans::Prism prism;
            for (const auto& p : rings.front()) prism.corners.emplace_back(p[0], p[1]);
            prism.z_minimum = ground.low;
            prism.z_maximum = ground.high;
            prism.prism_from_scan.linear() = frame_from_scan.rotation;
            prism.prism_from_scan.translation() = frame_from_scan.translation;
            placed.store->in_prism(prism, [&](const scans::FoundPoints& found) {
                for (std::size_t i = 0; i < found.points.size(); ++i) {
                    const Eigen::Vector3d x_in_scan(found.points.x[i], found.points.y[i], found.points.z[i]);
                    const Eigen::Vector3d x = frame_from_scan * x_in_scan;
                    if (rings.size() > 1 && !geometry::contains({rings}, x.x(), x.y())) continue;
                    RegionPoint point;
                    point.x_in_site = placed.site_from_scan * x_in_scan;
                    if (!found.points.intensity.empty()) point.intensity = found.points.intensity[i];
                    point.has_colour = !found.points.colour.empty();
                    if (point.has_colour) point.colour = found.points.colour[i];
                    visit(point);
                }
            });
        }
    }
}

} // namespace planum::app
