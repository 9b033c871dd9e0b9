// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scans/surface/layer_field.hpp"
#include "scans/surface/sight_rules.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// Cells that hold points at a height at which hardly any cells around have theirs.
[[nodiscard]] std::vector<bool> stray_cells(const SurfaceGrid& grid, const SightRules& rules);

/// Layers at a height at which hardly any cells around have one, by their number: 1 for a stray. Points drawn out in
/// height are of a side and no strays.
[[nodiscard]] std::vector<std::uint8_t> stray_layers(const LayerField& field, const SightRules& rules, int threads,
                                                     Progress& progress);

} // namespace planum::scans
