// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/geometry/gpb.hpp"

namespace planum::geometry {

/// Areas below this are no regions [m²].
inline constexpr double kLeastArea = 1e-4;

/// An outline that may be kept, and what had to be done to it.
struct SoundPolygon {
    MultiPolygon shape;               ///< valid by OGC; outer rings counter-clockwise, holes clockwise
    std::vector<std::string> repairs; ///< sentences with the place; empty: taken as it was
};

/// Makes an outline valid or refuses it with the place. Repaired: repeated points, rings the wrong way round, rings
/// that touch themselves, small loops where a line overshoots, parts that overlap, holes that stick out. Refused
/// (BadInput): not finite, no area, or a crossing where it matters which side is meant, that is when what a ring
/// encloses differs by more than 2 % and 20 cm² from what it runs around. Heights of new points follow the lines.
[[nodiscard]] SoundPolygon make_sound(const MultiPolygon& drawn);

/// Overlay in plan of valid outlines (make_sound); pieces and holes below kLeastArea are left out. Heights of new
/// points follow the lines of `a`, then of `b`. Throws BadInput when an outline is not valid.
[[nodiscard]] MultiPolygon difference(const MultiPolygon& a, const MultiPolygon& b);
[[nodiscard]] MultiPolygon intersection(const MultiPolygon& a, const MultiPolygon& b);
[[nodiscard]] MultiPolygon united(const MultiPolygon& a, const MultiPolygon& b);

/// The outline moved inwards (distance < 0) or outwards [m]; may be empty.
[[nodiscard]] MultiPolygon offset(const MultiPolygon& shape, double distance);

/// The outline without points that lie closer than about `tolerance` [m] to what remains, of which no two rings meet
/// and none meets itself: where geometry::simplified() would, points stay. Requires a valid outline.
[[nodiscard]] MultiPolygon simplified_apart(const MultiPolygon& shape, double tolerance);

/// A place well inside, for a label [m]. Throws BadInput for an empty shape.
[[nodiscard]] std::array<double, 2> inner_place(const MultiPolygon& shape);

} // namespace planum::geometry
