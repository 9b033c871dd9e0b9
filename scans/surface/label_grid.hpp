// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "core/model/place.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// Distances to outlines are known up to here only; beyond it they read this [m].
inline constexpr float kFarFromOutlines = 0.3F;

/// The outlines of one surface on the cells of a plan. Vectors have frame.cells() values.
struct LabelGrid {
    GridFrame frame;
    std::vector<std::int32_t> region;    ///< position in the regions given; kNoRegion: outside all of them
    std::vector<float> outline_distance; ///< from the middle of the cell to the nearest outline [m]
};

inline constexpr std::int32_t kNoRegion = -1;

/// The outline of a region as the geometry functions take it.
[[nodiscard]] geometry::MultiPolygon shape_of(const model::Region& region);

/// Gives every cell the region its middle lies in. Where regions overlap the smaller one has the cell: a
/// region inside another cuts its own hole. Regions on sections are passed over.
[[nodiscard]] LabelGrid label_cells(const GridFrame& frame, std::span<const model::Region> regions);

} // namespace planum::scans
