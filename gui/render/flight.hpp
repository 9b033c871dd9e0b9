// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gui/render/camera.hpp"

namespace planum::gui {

/// A smooth way along placed cameras: `frames` from each to the next, the last one once. The target follows a
/// Catmull-Rom curve (Catmull and Rom 1974), distances change by equal factors, turns take the shorter way. One camera
/// is one frame; none are none. A leg that begins straight down stays so: between parallel and perspective there is no
/// way.
[[nodiscard]] std::vector<Camera> flight_along(const std::vector<Camera>& placed, int frames);

} // namespace planum::gui
