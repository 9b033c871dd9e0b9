// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.hpp"
#include "scans/surface/layer_field.hpp"
#include "scans/surface/point_source.hpp"
#include "scans/surface/sight_rules.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// A layer that was taken out of the field: no ground, but it threw a shadow.
struct RemovedLayer {
    std::size_t cell = 0;
    HeightLayer layer;
};

/// How high ground can reach that nobody saw, cell by cell [m]; not a number where no shadow says so.
///
/// Where a scan saw an edge, and behind it something lower, what lies between is no higher than the line of sight over
/// that edge, or the scan would have seen it. Nothing is said of what lies before a side that only others saw: it may
/// belong to the edge. Of several scans the lowest line counts. Cells with ground get one too where they are strays
/// (see drop_hanging()). Scans after the 31st say nothing, nor those whose points lie behind each other as seen from
/// where they are said to stand, as flown clouds do.
[[nodiscard]] std::vector<float> lines_of_sight(const LayerField& field, std::span<const RemovedLayer> removed,
                                                const SurfaceGrid& grid, std::span<const SurfaceScan> scans,
                                                const SightRules& rules, int threads, Progress& progress);

/// Marks the layers that hang behind an edge in the shadow of the very scan that saw them, and of no other: beams that
/// met the edge with half their width, which scanners report somewhere between it and what lies behind. They lie near
/// the line of sight over the edge, at a height at which hardly any cells around have points; ground that goes on
/// behind at their height stays. `marked` gets a value for each layer, by its number. Returns how many there are.
std::size_t mark_hanging(const LayerField& field, std::span<const RemovedLayer> removed,
                         std::span<const SurfaceScan> scans, const SightRules& rules, int threads, Progress& progress,
                         std::vector<bool>& marked);

/// Makes Unseen of strays, cells at a height at which hardly any cells around have their points, that hang on or above
/// a line of sight: beams that met an edge with half their width, which scanners report somewhere between it and what
/// lies behind. Returns how many there were.
std::size_t drop_hanging(SurfaceGrid& grid, const SightRules& rules);

} // namespace planum::scans
