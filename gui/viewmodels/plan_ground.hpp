// SPDX-License-Identifier: MIT
#pragma once

#include "core/model/place.hpp"
#include "gui/viewmodels/outline_edit.hpp"
#include "gui/viewmodels/outline_tool.hpp"

namespace planum::gui {

/// How corners drawn in plan become an outline on a surface: with the heights of what its scans show, so that it is
/// seen on panoramas and in 3D too; without heights where there are none.
[[nodiscard]] OutlineTool::ToOutlines plan_ground(model::SurfaceId surface);

/// The same for outlines that are changed in plan.
[[nodiscard]] EditGround plan_edit_ground(model::SurfaceId surface);

} // namespace planum::gui
