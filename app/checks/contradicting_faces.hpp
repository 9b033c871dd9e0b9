// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/polygons.hpp"
#include "core/model/diagnostic.hpp"
#include "scans/surface/surface_step.hpp"

namespace planum::app {

/// The two surfaces that contradict a relation of the record.
struct ContradictingFaces {
    scans::UnitNumber upper = scans::kNobody; ///< seen first
    scans::UnitNumber lower = scans::kNobody; ///< came out below it
    std::vector<scans::KnownUnit> units;      ///< by number
    const model::Surface* surface_before = nullptr;
    const model::Surface* surface_after = nullptr;
    scans::LabelledSurface before;
    scans::LabelledSurface after;
    scans::SurfaceGrid ground_after;
    geometry::MultiPolygon face_before; ///< outlines of `upper` on the first
    geometry::MultiPolygon face_after;  ///< outlines of `lower` on the second
    std::vector<std::size_t> clash;     ///< cells where `lower` came out lower than can be told from level; ascending
    geometry::Extent extent;            ///< of these cells [m, site]
    std::size_t worst = 0;              ///< the cell with the greatest drop, median over 5 × 5 cells, to a centimetre
};

/// Throws Conflict when surfaces and outlines do not show the contradiction any more, Io when points are missing.
[[nodiscard]] ContradictingFaces contradicting_faces(Project& project, const model::Diagnostic& problem,
                                                     Progress& progress);

} // namespace planum::app
