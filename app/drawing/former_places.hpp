// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/model/record.hpp"
#include "strat/layout/layout_engine.hpp"

namespace planum::app {

/// Where the units of the record stand in an earlier drawing, an SVG file of our own: middles of their boxes and the
/// lines between them, in points of that drawing (y downwards), found by the ids that the drawing gives to units.
/// Isolated and folded boxes are left out, as their places say nothing. Throws BadInput for what is no such drawing or
/// shows none of the units, Io where it cannot be read.
[[nodiscard]] strat::PreviousDrawing former_places(const std::filesystem::path& svg, const model::Record& record);

} // namespace planum::app
