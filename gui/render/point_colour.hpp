// SPDX-License-Identifier: MIT
#pragma once

namespace planum::gui {

/// What the colour of a point stands for.
enum class PointColour { Intensity, Colour, Height, Day, Unit, Difference };

} // namespace planum::gui
