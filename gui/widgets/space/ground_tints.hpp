// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/model/record.hpp"
#include "gui/render/point_set.hpp"
#include "gui/viewmodels/difference_model.hpp"
#include "gui/viewmodels/region_shapes.hpp"

namespace planum::gui {

/// Each unit's outlines in a hue of its own, those inside others over them; null where nothing is outlined. For
/// threads.
[[nodiscard]] std::shared_ptr<const TintGrid> tints_of(const std::vector<RegionShape>& shapes,
                                                       const model::RecordIndex& index);

[[nodiscard]] std::shared_ptr<const TintGrid> tints_of(const GroundColours& ground);

} // namespace planum::gui
