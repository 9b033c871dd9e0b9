// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"
#include "scans/surface/gap_filling.hpp"

namespace planum::app {

/// The recorded depths of cuts that stand bare on a surface, and the tops of fills that show on it, each with the part
/// of the outline that holds it; a part that holds none has that of the nearest within 1.5 m, as where a baulk parts a
/// pit in two. What was measured on the rims of cuts, and levels without a place, say nothing of their floors.
[[nodiscard]] std::vector<scans::SpotHeight> spot_heights(const model::Record& record, const model::Surface& surface);

} // namespace planum::app
