// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/gpb.hpp"
#include "core/model/record.hpp"

namespace planum::app {

/// Whether two outlines were not redrawn: the same points, none farther than 0.5 mm away.
[[nodiscard]] bool same_lines(const geometry::MultiPolygon& a, const geometry::MultiPolygon& b);

/// Whether two regions of one surface or section are one, drawn anew: more than half of the smaller lies on the other,
/// in plan or in the plane of the section.
[[nodiscard]] bool is_drawn_anew(const model::Record& record, const model::Region& region, const model::Region& other);

} // namespace planum::app
