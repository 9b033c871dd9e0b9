// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "scans/surface/label_grid.hpp"
#include "scans/surface/surface_difference.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// How much of something lies on, or along, a patch.
struct LabelShare {
    std::int32_t label = kNoRegion;
    double amount = 0.0; ///< area [m²], or length along its edge [m]
};

/// Ground that changed between two surfaces and that nobody outlined on the later one.
struct ChangedPatch {
    geometry::MultiPolygon shape; ///< one polygon in site [m], with the heights of the later surface
    double area = 0.0;            ///< of its cells [m²]
    double change = 0.0;          ///< median, negative where ground went [m]
    double edge = 0.0;            ///< length of its edge along cells [m]
    std::vector<LabelShare> was;  ///< what lay there before, largest first; kNoRegion: nothing was outlined
    /// Labels of the later surface beside it, where the ground goes on without a step; longest first.
    std::vector<LabelShare> beside;
};

struct PatchOptions {
    double least_area = 0.05; ///< smaller patches are left out [m²]
    double step = 0.03;       ///< ground beside a patch that differs by more is no continuation [m]
    double simplify = 0.02;   ///< corners closer to the line than this are left out [m]; 0: all corners of cells
    double least_hole = 0.0;  ///< smaller holes are not drawn [m²]
};

/// Patches of the ground of `after` that differ from `before` beyond the level of detection and lie in no region of
/// `after_labels`, largest first. Sides (CellState::Face) part them, so that the bottom of a pit is a patch of its own.
/// Single cells are noise: cells count where at least five of their eight neighbours changed in the same way.
///
/// `before_labels` and `after_labels` have a value for each cell of `difference.frame`, kNoRegion for none.
[[nodiscard]] std::vector<ChangedPatch> changed_patches(const SurfaceDifference& difference, const SurfaceGrid& after,
                                                        const std::vector<std::int32_t>& before_labels,
                                                        const std::vector<std::int32_t>& after_labels,
                                                        const PatchOptions& options = {});

/// The outlines of the cells where `inside` is not 0, along the edges of the cells, in site [m], z = 0: outer rings
/// counter-clockwise, each followed by its holes. Cells that touch at a corner only do not belong together.
[[nodiscard]] geometry::MultiPolygon outline_of_cells(const GridFrame& frame, const std::vector<std::uint8_t>& inside);

} // namespace planum::scans
