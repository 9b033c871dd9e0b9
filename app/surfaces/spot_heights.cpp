// SPDX-License-Identifier: MIT
#include "app/surfaces/spot_heights.hpp"

#include <algorithm>
#include <cmath>

#include "app/regions/outline.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

constexpr double kLevelSigma = 0.02; // of a level, and of a floor that is not quite level [m]
constexpr double kApartSigma = 0.1;  // of a floor that was measured in another part of the cut [m]
constexpr double kFarthest = 1.5;    // no floor is level farther away, as that of a ditch [m]
constexpr double kBeside = 0.1;      // from an outline that a hand drew [m]

bool is_fill(const model::Record& record, model::UnitId unit) {
    const auto at = std::find_if(record.units.begin(), record.units.end(),
                                 [&](const model::StratigraphicUnit& u) { return u.id == unit; });
    return at != record.units.end() && at->kind == model::UnitKind::Deposit && at->form == model::UnitForm::Fill;
}

// What levels of a unit say of the ground where a region shows it. What is left of a fill may lie as deep in a pit as
// its bare cut; layers lie open.
bool says_height(const model::Record& record, const model::Region& region, const model::Level& level) {
    if (level.unit != region.unit || !level.x || !level.y) return false;
    if (region.shows == model::RegionShows::Cut)
        return level.role == model::LevelRole::Base || level.role == model::LevelRole::Cut;
    return region.shows == model::RegionShows::Top && level.role == model::LevelRole::Top &&
           is_fill(record, region.unit);
}

// A pit that a baulk parts in two is as deep on both sides, though the staff stood on one: for a part in which
// none was measured the nearest holds, if it is near.
void add_spots(const geometry::MultiPolygon& part, const std::vector<const model::Level*>& levels,
               std::vector<scans::SpotHeight>& spots) {
    const std::size_t before = spots.size();
    for (const model::Level* level : levels) {
        if (geometry::contains(part, *level->x, *level->y) ||
            geometry::distance_to_outline(part, *level->x, *level->y) <= kBeside)
            spots.push_back({*level->x, *level->y, level->z, kLevelSigma, part});
    }
    if (spots.size() > before) return;
    const auto [x, y] = geometry::inner_place(part);
    const auto distance = [x = x, y = y](const model::Level* level) {
        return std::hypot(*level->x - x, *level->y - y);
    };
    const model::Level* nearest = *std::min_element(
        levels.begin(), levels.end(), [&](const auto* a, const auto* b) { return distance(a) < distance(b); });
    if (distance(nearest) <= kFarthest) spots.push_back({x, y, nearest->z, kApartSigma, part});
}

} // namespace

std::vector<scans::SpotHeight> spot_heights(const model::Record& record, const model::Surface& surface) {
    std::vector<scans::SpotHeight> spots;
    for (const model::Region& region : record.regions) {
        if (region.surface != surface.id || region.unit.is_nil() || !region.section.is_nil()) continue;
        std::vector<const model::Level*> levels;
        for (const model::Level& level : record.levels) {
            if (says_height(record, region, level)) levels.push_back(&level);
        }
        if (levels.empty()) continue;
        for (const geometry::Rings& part : shape_of(region.outline)) add_spots({part}, levels, spots);
    }
    return spots;
}

} // namespace planum::app
