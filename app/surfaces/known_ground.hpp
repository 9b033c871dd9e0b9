// SPDX-License-Identifier: MIT
#pragma once

#include "core/model/record.hpp"
#include "scans/surface/gap_filling.hpp"

namespace planum::app {

/// What the record says of a surface's ground besides its scans: spot_heights(), and the outlines in which it shows
/// artificial levels.
[[nodiscard]] scans::KnownGround known_ground(const model::Record& record, const model::Surface& surface);

} // namespace planum::app
