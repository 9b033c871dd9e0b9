// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/gpb.hpp"

namespace planum::app {

/// Ground that changed since the surface before and that nobody has outlined yet, ready to be named.
struct ReadyPatch {
    std::string surface;
    model::SurfaceId on_surface;
    geometry::MultiPolygon shape; ///< one polygon in site [m]
    double area = 0.0;            ///< [m²]
    double change = 0.0;          ///< median since the surface before, negative where ground went [m]
    std::string was;              ///< what was outlined there last: a number or a category; empty: nothing
    model::UnitId unit;           ///< proposed; nil: nobody can say
    std::string proposed;         ///< its number
    std::string because;          ///< why this unit, or why none, in a sentence
};

struct ReadyPatches {
    std::vector<ReadyPatch> patches; ///< by surface in time, then by size
    std::size_t outside = 0;         ///< left out: changed ground outside all outlines of the area (heaps, paths)
    std::vector<std::string> notes;  ///< surfaces that could not be compared, and why
};

struct PatchQuery {
    std::string surface;      ///< empty: the last registered surface of each area
    bool all = false;         ///< all surfaces
    double cell = 0.0;        ///< of the heights compared [m]; 0: 2, 4 or 8 cm, as dense as the scans are
    double least_area = 0.05; ///< smaller patches are left out [m²]
};

/// Finds them. A unit is proposed where an outlined neighbour goes on without a step along half of the edge, else where
/// the record knows exactly one contact below the unit that was dug away, of those not outlined yet or of all. Throws
/// NotFound and Usage for the name of a surface, and as recorded_surface().
[[nodiscard]] ReadyPatches ready_patches(Project& project, const PatchQuery& query, Progress& progress);

/// The patches as GeoJSON that `planum region import` takes: `unit` where one is proposed, `notes` with the reason.
[[nodiscard]] std::string patches_geojson(const model::Record& record, const ReadyPatches& patches);

} // namespace planum::app
