// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"
#include "scans/surface/gap_filling.hpp"

namespace planum::app {

/// The recorded levels of cuts that lie in an outline of the bare cut on a surface. Levels without a place say nothing.
[[nodiscard]] std::vector<scans::SpotHeight> spot_heights(const model::Record& record, const model::Surface& surface);

} // namespace planum::app
