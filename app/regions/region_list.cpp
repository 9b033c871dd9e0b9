// SPDX-License-Identifier: MIT
#include "app/regions/region_list.hpp"

#include <algorithm>
#include <utility>

#include "app/regions/region_heights.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

// Heights of the drawn points, ascending.
std::vector<double> outline_heights(const model::Region& region) {
    std::vector<double> z;
    if (!region.has_heights) return z;
    for (const model::Polygon& polygon : region.outline) {
        for (const auto& point : polygon.outer) z.push_back(point[2]);
    }
    std::sort(z.begin(), z.end());
    return z;
}

// Of every region of the record, in its order [m²].
std::vector<double> shown_areas(const model::Record& record) {
    std::vector<double> areas(record.regions.size(), 0.0);
    const auto take = [&](const RegionLayout& layout) {
        for (const PlacedRegion& placed : layout.regions) {
            areas[static_cast<std::size_t>(placed.region - record.regions.data())] = geometry::area(placed.shown);
        }
    };
    for (const model::Surface& surface : record.surfaces) take(layout_regions(regions_on(record, surface.id)));
    for (const model::Section& section : record.sections) {
        take(layout_regions(regions_on(record, section.id), &section));
    }
    return areas;
}

} // namespace

RegionList list_regions(Project& project, const std::string& day, Progress& progress) {
    if (!day.empty()) require_day("--day", day);
    const model::Record& record = project.record();
    const model::RecordIndex& index = project.index();
    const std::vector<double> areas = shown_areas(record);
    CountedHeights counted = heights_of_regions(project, progress);
    const std::vector<RegionHeights>& heights = counted.regions;
    RegionList list;
    list.problems = std::move(counted.problems);
    for (const std::size_t i : regions_in_order(record, index)) {
        const model::Region& region = record.regions[i];
        RegionRow row;
        row.day = region_day(record, region);
        if (!day.empty() && row.day != day) continue;
        row.region = region_name(record, index, region);
        if (!region.unit.is_nil()) row.unit = index.name(region.unit);
        row.shows = to_word(region.shows);
        row.category = to_word(region.category);
        row.drawn_area = region_area(record, region);
        row.area = areas.at(i);
        if (region.unit.is_nil() && !region.unit_as_drawn.empty()) {
            row.drawn = region.unit_as_drawn;
            row.near = proposed_numbers(record, region.unit_as_drawn);
        }
        row.points = heights.at(i).points;
        row.incomplete = heights[i].incomplete;
        row.outside_scans = heights[i].outside_scans;
        if (row.points > 0) {
            row.z_min = heights[i].lowest;
            row.z_median = heights[i].median;
            row.z_max = heights[i].highest;
        } else if (const std::vector<double> z = outline_heights(region); !z.empty()) {
            row.z_min = z.front();
            row.z_median = z[z.size() / 2];
            row.z_max = z.back();
        }
        list.rows.push_back(std::move(row));
    }
    return list;
}

} // namespace planum::app
