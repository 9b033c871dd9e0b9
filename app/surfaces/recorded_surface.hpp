// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "scans/surface/surface_builder.hpp"

namespace planum::app {

/// Cells on which surfaces are compared: the first that the scans fill with kDensePoints a cell, else the last [m].
inline constexpr std::array kComparedCells = {0.02, 0.04, 0.08};
inline constexpr double kDensePoints = 1.5;

/// A surface of the record with the heights that its scans give.
struct RecordedSurface {
    std::string name;
    std::vector<std::string> scans; ///< that stand on the site grid
    std::vector<std::string> raw;   ///< that do not yet
    scans::SurfaceGrid grid;
};

/// The rectangle on which surfaces of an area are made: around all its outlines with half a metre to spare, else
/// around all set-ups of the scanner there with 6 m. nullopt when there is neither.
[[nodiscard]] std::optional<scans::PlanBox> plan_of_area(const model::Record& record, model::AreaId area);

/// Surfaces of an area, earliest first.
[[nodiscard]] std::vector<const model::Surface*> surfaces_in_time(const model::Record& record, model::AreaId area);

/// The surface of that name, `DAY` or `AREA::NAME`. Throws NotFound, and Usage where several areas have one.
[[nodiscard]] const model::Surface& known_surface(const model::Record& record, std::string_view name);

/// The cells on which surfaces of an area are made, `cell` wide [m]. Throws Conflict when neither outlines nor set-ups
/// say where the area is.
[[nodiscard]] scans::GridFrame frame_of_area(const model::Record& record, model::AreaId area, double cell);

/// The surface with its scans, without heights. Throws Conflict when none of its scans stands on the site grid.
[[nodiscard]] RecordedSurface surface_without_heights(const model::Record& record, const model::Surface& surface);

/// The heights of a surface from all registered scans that belong to it, from the cache where nothing changed. Throws
/// Conflict when none of its scans stands on the site grid.
[[nodiscard]] RecordedSurface recorded_surface(Project& project, const model::Surface& surface, double cell,
                                               Progress& progress);

} // namespace planum::app
