// SPDX-License-Identifier: MIT
#pragma once

#include "core/model/record.hpp"

namespace planum::app {

/// Whether an outline was not redrawn: the same points, none farther than 0.5 mm away; in plan only where one of the
/// two has no heights.
[[nodiscard]] bool same_lines(const model::Region& a, const model::Region& b);

/// Whether two regions of one surface or section are one, drawn anew: more than half of the smaller lies on the other,
/// in plan or in the plane of the section.
[[nodiscard]] bool is_drawn_anew(const model::Record& record, const model::Region& region, const model::Region& other);

} // namespace planum::app
