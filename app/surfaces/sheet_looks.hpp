// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/geometry/map_sheet.hpp"
#include "core/geometry/polygons.hpp"
#include "core/model/unit.hpp"

namespace planum::app {

/// How a unit of that kind is drawn, the same on plans, sections and on the screen.
[[nodiscard]] geometry::SheetLook unit_look(model::UnitKind kind, model::UnitForm form);

/// Adds an outline. Below dashes and dots, and around lines without a fill, lies white: a solid line of the neighbour
/// that runs along the same edge would close every gap, and a colour would be lost on a photograph.
void add_outline(geometry::MapSheet& sheet, const geometry::MultiPolygon& shape, const geometry::SheetLook& look);

/// The colour of the surface at `place` of `count` in time: early light, late dark, so that they differ in grey too.
[[nodiscard]] geometry::SheetColour colour_in_time(std::size_t place, std::size_t count);

} // namespace planum::app
