// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/polygon_overlay.hpp"
#include "core/model/record.hpp"

namespace planum::app {

/// Sides of trenches lean and are not even; what is drawn on them lies no farther from the section's plane [m].
inline constexpr double kFarthestFromPlane = 0.5;

/// Makes an outline in site coordinates sound: in plan, or in the plane of a section and back. Throws BadInput where
/// a corner lies farther from that plane than kFarthestFromPlane, with the distance.
[[nodiscard]] geometry::SoundPolygon sound_in_site(const geometry::MultiPolygon& shape, const model::Section* section);

} // namespace planum::app
