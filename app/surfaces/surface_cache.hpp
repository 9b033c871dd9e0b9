// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "scans/surface/surface_builder.hpp"

namespace planum::app {

/// The scans of a surface that stand on the site grid, with their points. Throws as placed_scans().
[[nodiscard]] std::vector<scans::SurfaceScan> surface_scans(Project& project, model::SurfaceId surface,
                                                            Progress& progress);

/// Hash of all that the heights of a surface are made from: scans, poses, tolerance and cells. Empty: no scan of it
/// stands on the site grid.
[[nodiscard]] std::string surface_key(const model::Record& record, model::SurfaceId surface,
                                      const scans::GridFrame& frame);

/// A surface as its scans give it, with where they disagree.
struct KeptSurface {
    scans::SurfaceGrid grid;                    ///< without what hangs behind edges
    std::vector<scans::CellAsSeen> as_seen;     ///< where that makes a difference
    std::vector<scans::DisputedPatch> disputed; ///< largest first
};

/// A surface from its registered scans, kept in NAME.scans/surfaces under `key`, which surface_key()
/// gave. A cache that cannot be written (read-only media) is done without. Throws as placed_scans() when points are
/// needed and missing.
[[nodiscard]] KeptSurface kept_surface(Project& project, model::SurfaceId surface, const scans::GridFrame& frame,
                                       const std::string& key, Progress& progress);

/// The heights of kept_surface() as they were seen, for what surfaces prove.
[[nodiscard]] scans::SurfaceGrid seen_surface(Project& project, model::SurfaceId surface, const scans::GridFrame& frame,
                                              const std::string& key, Progress& progress);

} // namespace planum::app
