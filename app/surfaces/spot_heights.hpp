// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"
#include "scans/surface/gap_filling.hpp"

namespace planum::app {

/// The recorded depths of cuts that stand bare on a surface, each with the outline that shows it. What was measured on
/// their rims, and levels without a place, say nothing of their floors.
[[nodiscard]] std::vector<scans::SpotHeight> spot_heights(const model::Record& record, const model::Surface& surface);

} // namespace planum::app
