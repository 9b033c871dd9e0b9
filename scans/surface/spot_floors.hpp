// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "scans/surface/gap_filling.hpp"

namespace planum::scans {

/// What is no higher above a line of sight counts as under it [m].
inline constexpr float kOnSightLine = 0.02F;

/// Lays the floor of hollows that no scanner looked into at heights that were measured otherwise.
///
/// A spot counts where hardly any ground was seen around it, and no line of sight runs below it (SurfaceGrid::ceiling).
/// From there the floor is level within the outline of the hollow, as far as hardly any ground was seen and no side is
/// in the way. What was seen of sloping sides goes on as steep as it was seen, down to the floor; single cells above
/// the floor that hang there alone, as beams that met an edge with half their width do, say nothing. `fence` says
/// through which cells a side runs, those that were only drawn from one piece of it to the next included: of these,
/// what lies on a floor is taken back. Cells that get a height get its σ too, which grows by `doubt` for each metre
/// from what it was taken from.
void lay_floors(FilledHeights& filled, const SurfaceGrid& grid, std::vector<bool>& fence,
                std::span<const SpotHeight> spots, double doubt);

} // namespace planum::scans
