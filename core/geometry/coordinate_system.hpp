// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace planum::geometry {

/// A coordinate reference system as a GeoPackage wants it described.
struct CoordinateSystem {
    std::string name;
    std::string wkt; ///< well-known text, version 1
};

/// From PROJ's own database. nullopt when EPSG has no such code, or PROJ's database is not installed.
[[nodiscard]] std::optional<CoordinateSystem> coordinate_system_of_epsg(std::int64_t code);

} // namespace planum::geometry
