// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace planum::geometry {

using Point3 = std::array<double, 3>; ///< x, y, z
using Line3 = std::vector<Point3>;

/// Rings without the repeated last point: the outer one first, then the holes.
using Rings = std::vector<Line3>;
using MultiPolygon = std::vector<Rings>;

/// One geometry as a GeoPackage stores it.
struct Geometry {
    std::int32_t srs_id = -1;
    bool has_z = true; ///< false: the file had no heights and every z is 0
    /// monostate: an empty geometry. A single polygon reads as a multipolygon of one.
    std::variant<std::monostate, Point3, Line3, MultiPolygon> shape;

    friend bool operator==(const Geometry&, const Geometry&) = default;
};

/// GeoPackage binary (OGC 12-128, clause 2.1.3) around ISO WKB, with z where has_z says so, little-endian. Lines and
/// polygons carry their x/y envelope. Throws BadInput when a coordinate is not finite.
[[nodiscard]] std::vector<std::byte> encode_gpb(const Geometry& geometry);

/// Reads points, lines, polygons and multipolygons, with or without z and m, in both byte orders, ISO or
/// extended WKB. Throws BadInput, saying what is wrong, for everything else: other types, counts that the
/// blob cannot hold, coordinates that are not finite.
[[nodiscard]] Geometry decode_gpb(std::span<const std::byte> blob);

} // namespace planum::geometry
