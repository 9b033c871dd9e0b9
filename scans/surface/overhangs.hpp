// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scans/surface/gap_filling.hpp"

namespace planum::scans {

/// A hollow whose sides were seen to widen downwards, as those of a bell-shaped pit.
struct Overhang {
    double widening = 0.0; ///< tangent of its side against the plumb line
    double depth = 0.0;    ///< from the ground around it to its floor [m]
    double volume = 0.0;   ///< under the overhang, as if it went on to the floor as it was seen to begin [m³]
    geometry::MultiPolygon outline;
    std::vector<std::size_t> mouth; ///< cells inside its outline
    /// Faces outside its outline: points of the side beneath the ground. What lies on top of them is in `ground`.
    std::vector<std::size_t> roof;
    std::vector<float> ground; ///< [m, site]
};

/// The hollows among `spots` that widen downwards. From the rim of a trench a scanner sees the upper part of the far
/// side of a pit: of every face there the distance from the outline over its depth below the ground around. Their
/// median is how fast the side recedes; 15 cm a metre and more is an overhang, what is less,
/// or would be less than 2 cm a metre had the line been drawn 3 cm farther out, may be the hand that drew it, and what
/// is steeper than earth stays up is something else. The hollow then is a frustum of a cone over its outline, which for
/// a pit of 80 cm that opens to one and two thirds of its mouth gives five sixths of what lies under the overhang.
[[nodiscard]] std::vector<Overhang> find_overhangs(const SurfaceGrid& grid, std::span<const SpotHeight> spots);

} // namespace planum::scans
