// SPDX-License-Identifier: MIT
#include "app/surfaces/recorded_surface.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"
#include "core/model/astray.hpp"
#include "scans/surface/label_grid.hpp"

namespace planum::app {

namespace {

const model::Surface* find_surface(const model::Record& record, model::SurfaceId id) {
    const auto found = std::find_if(record.surfaces.begin(), record.surfaces.end(),
                                    [&](const model::Surface& surface) { return surface.id == id; });
    return found == record.surfaces.end() ? nullptr : &*found;
}

} // namespace

std::vector<const model::Surface*> surfaces_in_time(const model::Record& record, model::AreaId area) {
    std::vector<const model::Surface*> found;
    for (const model::Surface& surface : record.surfaces) {
        if (surface.area == area) found.push_back(&surface);
    }
    std::stable_sort(found.begin(), found.end(), [](const model::Surface* a, const model::Surface* b) {
        return std::tie(a->order, a->first_day) < std::tie(b->order, b->first_day);
    });
    return found;
}

const model::Surface& known_surface(const model::Record& record, std::string_view name) {
    const model::Surface* surface = surface_named(record, name, {});
    if (surface == nullptr) {
        throw Error(ErrorCode::NotFound, fmt::format("no surface {}; planum surface list names all", name));
    }
    return *surface;
}

std::optional<scans::PlanBox> plan_of_area(const model::Record& record, model::AreaId area) {
    const auto in_area = [&](model::SurfaceId id) {
        const model::Surface* surface = find_surface(record, id);
        return surface != nullptr && surface->area == area;
    };
    geometry::Extent outlines;
    const model::ScannedBox scanned(record);
    for (const model::Region& region : record.regions) {
        if (in_area(region.surface) && !scanned.is_astray(region))
            outlines.add(geometry::extent(scans::shape_of(region)));
    }
    geometry::Extent stations;
    for (const model::Scan& scan : record.scans) {
        if (!in_area(scan.surface)) continue;
        if (const model::ScanPose* pose = model::pose_in_force(record, scan.id))
            stations.add(pose->site_from_scan[3], pose->site_from_scan[7]);
    }
    const geometry::Extent& extent = outlines.is_empty() ? stations : outlines;
    const double spare = outlines.is_empty() ? 6.0 : 0.5;
    if (extent.is_empty()) return std::nullopt;
    return scans::PlanBox{extent.low[0] - spare, extent.low[1] - spare, extent.high[0] + spare, extent.high[1] + spare};
}

scans::GridFrame frame_of_area(const model::Record& record, model::AreaId area, double cell) {
    const std::optional<scans::PlanBox> plan = plan_of_area(record, area);
    if (!plan) {
        throw Error(ErrorCode::Conflict, "neither outlines nor registered scans say where the area is: planum region "
                                         "import, planum register");
    }
    return scans::frame_around(*plan, cell);
}

RecordedSurface surface_without_heights(const model::Record& record, const model::Surface& surface) {
    RecordedSurface result;
    result.name = surface_name(record, surface);
    for (const model::Scan* scan : scans_of(record, surface))
        (model::pose_in_force(record, scan->id) != nullptr ? result.scans : result.raw).push_back(scan->name);
    if (result.scans.empty()) {
        throw Error(ErrorCode::Conflict, fmt::format("surface {}: {}", result.name, why_unseen(record, surface)));
    }
    return result;
}

RecordedSurface recorded_surface(Project& project, const model::Surface& surface, double cell, Progress& progress) {
    const model::Record& record = project.record();
    RecordedSurface result = surface_without_heights(record, surface);
    const scans::GridFrame frame = frame_of_area(record, surface.area, cell);
    result.grid = kept_surface(project, surface.id, frame, surface_key(record, surface.id, frame), progress).grid;
    return result;
}

} // namespace planum::app
