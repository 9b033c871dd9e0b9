// SPDX-License-Identifier: MIT
#include "app/surfaces/spot_heights.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

struct Part {
    const model::Region* region;
    geometry::MultiPolygon outline;
};

std::vector<Part> parts_of(const model::Record& record, const model::Surface& surface) {
    std::vector<Part> parts;
    for (const model::Region& region : record.regions) {
        if (region.surface != surface.id || region.unit.is_nil() || !region.section.is_nil()) continue;
        for (const geometry::Rings& rings : shape_of(region.outline)) {
            const geometry::MultiPolygon outline = {rings};
            if (!rings.empty() && rings.front().size() >= 3 && geometry::area(outline) >= geometry::kLeastArea)
                parts.push_back({&region, outline});
        }
    }
    return parts;
}

bool holds(const Part& part, const model::Level& level) {
    return geometry::contains(part.outline, *level.x, *level.y) ||
           geometry::distance_to_outline(part.outline, *level.x, *level.y) <= kBeside;
}

// A pit that a baulk parts in two is as deep on both sides, though the staff stood on one: for a part in which
// none was measured the nearest holds, if it is near. What was measured where a fill still lies, at the
// bottom of a pit that is half emptied, says nothing; where a layer lies it may be the roof over an undercut one.
std::optional<scans::SpotHeight> from_another(const model::Record& record, const Part& part,
                                              const std::vector<Part>& parts,
                                              const std::vector<const model::Level*>& levels) {
    const auto [x, y] = geometry::inner_place(part.outline);
    const model::Level* nearest = nullptr;
    double least = kFarthest;
    for (const model::Level* level : levels) {
        const double distance = std::hypot(*level->x - x, *level->y - y);
        const bool is_covered = std::any_of(parts.begin(), parts.end(), [&](const Part& other) {
            return other.region->unit != part.region->unit && geometry::contains(other.outline, *level->x, *level->y) &&
                   is_fill(record, other.region->unit);
        });
        if (is_covered || distance > least) continue;
        least = distance;
        nearest = level;
    }
    if (nearest == nullptr) return std::nullopt;
    return scans::SpotHeight{x, y, nearest->z, kApartSigma, part.outline};
}

} // namespace

std::vector<scans::SpotHeight> spot_heights(const model::Record& record, const model::Surface& surface) {
    std::vector<scans::SpotHeight> spots;
    const std::vector<Part> parts = parts_of(record, surface);
    for (const Part& part : parts) {
        std::vector<const model::Level*> levels;
        for (const model::Level& level : record.levels) {
            if (says_height(record, *part.region, level)) levels.push_back(&level);
        }
        const std::size_t before = spots.size();
        for (const model::Level* level : levels) {
            if (holds(part, *level)) spots.push_back({*level->x, *level->y, level->z, kLevelSigma, part.outline});
        }
        if (spots.size() > before || levels.empty()) continue;
        if (auto spot = from_another(record, part, parts, levels)) spots.push_back(*std::move(spot));
    }
    return spots;
}

} // namespace planum::app
