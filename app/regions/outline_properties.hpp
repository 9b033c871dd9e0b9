// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "app/regions/outline.hpp"
#include "strat/exchange/json_support.hpp"

namespace planum::app {

/// Takes one property of an outline (docs/formats/outlines.md); case, blanks, hyphens and underscores in its name do
/// not matter. False when nobody knows it. Throws BadInput for a value that cannot be used.
bool read_outline_property(DrawnOutline& outline, std::string_view name, const strat::Json& value);

/// One ring of [x, y] or [x, y, z]; z is NaN where it is not said; the repeated last point goes. Throws BadInput.
[[nodiscard]] geometry::Line3 ring_from_json(const strat::Json& points);

} // namespace planum::app
