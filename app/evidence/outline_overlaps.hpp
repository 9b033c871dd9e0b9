// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/evidence.hpp"

namespace planum::app {

/// Where outlines of one surface, or of one section, claim the same ground (layout_regions()). Kept in
/// NAME.scans/evidence by the hash of the outlines. Throws Cancelled.
[[nodiscard]] std::vector<model::OutlineOverlap> outline_overlaps(Project& project, Progress& progress);

} // namespace planum::app
