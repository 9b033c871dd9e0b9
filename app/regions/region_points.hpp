// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "app/project/project.hpp"
#include "app/scans/scan_stores.hpp"
#include "app/scans/surface_scans.hpp"
#include "core/geometry/gpb.hpp"

namespace planum::app {

/// One point of a region.
struct RegionPoint {
    Eigen::Vector3d x_in_site;
    std::uint16_t intensity = 0;
    scans::Rgb colour;
    bool has_colour = false;
};

/// Whether a scan may show a region: that of its surface; on a section, scans of its day (all when it has none).
[[nodiscard]] bool may_show(const model::Record& record, const model::Scan& scan, const model::Region& region);

/// What a region shows, in a frame where it is a polygon in x and y: the site grid, or on a section (metres along,
/// height, distance from the plane). Points count up to 1 m above the highest point of an outline with heights; on a
/// section up to 5 cm before and behind the plane.
struct RegionGround {
    geometry::MultiPolygon shape; ///< less what lies inside it and what another claims too, see layout_regions
    geometry::Rigid3 frame_from_site;
    double low = -1e9; ///< [m]
    double high = 1e9;
};

/// The ground of every region of the record, in its order; empty shapes for outlines that are not valid.
[[nodiscard]] std::vector<RegionGround> region_grounds(const model::Record& record);

/// Visits the points of the scans that lie on a ground, in the order of the scans and their stores.
void for_points_on(const RegionGround& ground, const std::vector<PlacedScan>& scans,
                   const std::function<void(const RegionPoint&)>& visit);

} // namespace planum::app
