// SPDX-License-Identifier: MIT
#include "app/surfaces/spot_heights.hpp"

#include "app/regions/outline.hpp"

namespace planum::app {

namespace {

constexpr double kLevelSigma = 0.02; // of a level, and of a floor that is not quite level [m]

bool is_depth(const model::Level& level) {
    return level.role == model::LevelRole::Base || level.role == model::LevelRole::Cut;
}

} // namespace

std::vector<scans::SpotHeight> spot_heights(const model::Record& record, const model::Surface& surface) {
    std::vector<scans::SpotHeight> spots;
    for (const model::Region& region : record.regions) {
        if (region.surface != surface.id || region.shows != model::RegionShows::Cut || region.unit.is_nil()) continue;
        const geometry::MultiPolygon shape = shape_of(region.outline);
        for (const model::Level& level : record.levels) {
            if (level.unit == region.unit && is_depth(level) && level.x && level.y)
                spots.push_back({*level.x, *level.y, level.z, kLevelSigma, shape});
        }
    }
    return spots;
}

} // namespace planum::app
