// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "core/geometry/map_sheet.hpp"

namespace planum::app {

// How the two units of a height contradiction are drawn, on surfaces and in sections alike.

inline constexpr double kContradictionWidth = 0.18;  ///< of a map on paper [m]
inline constexpr double kContradictionHeight = 0.09; ///< at most [m]
inline constexpr std::array kContradictionScales = {5.0, 10.0, 20.0, 25.0, 50.0, 100.0, 200.0, 500.0};

/// The largest scale at which so much [m] has room in so much paper [m].
[[nodiscard]] inline double contradiction_scale(const std::array<double, 2>& wanted,
                                                const std::array<double, 2>& paper) {
    for (const double scale : kContradictionScales) {
        if (wanted[0] <= paper[0] * scale && wanted[1] <= paper[1] * scale) return scale;
    }
    return kContradictionScales.back();
}

inline constexpr geometry::SheetColour kUpperColour = 0x1f5a96; ///< blue: seen first, or on top
inline constexpr geometry::SheetColour kLowerColour = 0xb0561a; ///< brown: came out below
inline constexpr geometry::SheetColour kClashColour = 0xd62f3b;
inline constexpr geometry::SheetLook kUpperFace{kUpperColour, 0.6, geometry::SheetDash::Solid, kUpperColour, 0.10};
inline constexpr geometry::SheetLook kLowerFace{kLowerColour, 0.6, geometry::SheetDash::Dashed, kLowerColour, 0.10};
inline constexpr geometry::SheetLook kMeasureLine{0x1d1c1a, 0.4, geometry::SheetDash::Solid, 0xffffff, 0.0};

} // namespace planum::app
