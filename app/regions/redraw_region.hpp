// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/geometry/gpb.hpp"

namespace planum::app {

/// Gives a region another outline, in site coordinates [m], as one undo step; where it was drawn, what it shows and all
/// else stays. `drawn_over` is the outline that somebody saw while drawing: Conflict where the project has another by
/// now. Points without height (NaN) are settled by settle_heights(). The outline is made sound, on a section in its
/// plane; what was mended is said, a sentence each. NotFound where the region is gone, BadInput for an outline that
/// cannot be used.
std::vector<std::string> redraw_region(Project& project, model::RegionId id, const geometry::MultiPolygon& drawn_over,
                                       geometry::MultiPolygon outline);

} // namespace planum::app
