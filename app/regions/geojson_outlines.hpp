// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "app/regions/outline.hpp"
#include "strat/exchange/json_support.hpp"

namespace planum::app {

/// Reads a GeoJSON feature collection, feature or bare geometry of (multi)polygons in site coordinates; the
/// properties stand in docs/formats/outlines.md. Features that are no outlines become notes. Throws BadInput for
/// what is no GeoJSON, and for coordinates in degrees (a `crs` of longitude and latitude).
[[nodiscard]] OutlineFile read_geojson_outlines(std::string_view bytes);
[[nodiscard]] OutlineFile geojson_outlines_from(const strat::Json& json);

} // namespace planum::app
