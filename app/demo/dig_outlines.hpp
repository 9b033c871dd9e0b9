// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/dig_surfaces.hpp"
#include "core/model/place.hpp"

namespace planum::app::demo {

/// What the draughtsman drew around one patch of one surface.
struct DrawnRegion {
    SurfaceNo surface = 0;
    UnitNo unit = kAir;
    model::RegionCategory category = model::RegionCategory::Unit;
    model::RegionShows shows = model::RegionShows::Top;
    model::Polygon outline;
    std::string notes;
};

/// Draws one surface as a person does: small specks left out, corners cut, everything a little displaced,
/// by the same amount on both sides of a shared line, and at most 3 cm from the truth.
[[nodiscard]] std::vector<DrawnRegion> draw_outlines(const SurfaceMap& map, const ColumnGrid& grid, SurfaceNo surface,
                                                     std::uint64_t seed);

} // namespace planum::app::demo
