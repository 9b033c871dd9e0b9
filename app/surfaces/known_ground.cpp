// SPDX-License-Identifier: MIT
#include "app/surfaces/known_ground.hpp"

#include "app/regions/outline.hpp"
#include "app/surfaces/spot_heights.hpp"

namespace planum::app {

scans::KnownGround known_ground(const model::Record& record, const model::Surface& surface) {
    scans::KnownGround known;
    known.spots = spot_heights(record, surface);
    for (const model::Region& region : record.regions) {
        if (region.surface == surface.id && region.section.is_nil() && region.shows == model::RegionShows::Level)
            known.plana.push_back(shape_of(region.outline));
    }
    return known;
}

} // namespace planum::app
