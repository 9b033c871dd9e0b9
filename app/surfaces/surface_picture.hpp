// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/base/progress.hpp"
#include "core/geometry/map_sheet.hpp"
#include "scans/surface/point_source.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::app {

/// Heights as grey relief, light from north-west, 45° high; sides darker, what no scan saw clear. Holes up to 10 cm
/// across are closed for the picture only.
[[nodiscard]] geometry::SheetPicture shaded_relief(const scans::SurfaceGrid& grid);

/// Clear pixels between seen ones, up to twice `passes` apart, take the mean of the known around them; what lies
/// outside stays clear, so that a line of single pixels stays one (a morphological closing with a square).
void close_holes(geometry::SheetPicture& picture, int passes);

struct Orthophoto {
    geometry::SheetPicture picture;
    bool is_colour = false; ///< false: reflectance
};

/// What the ground looks like from above: the mean colour of the points of a cell that lie within 5 cm of its height;
/// reflectance as grey, drawn out from 2 % to 98 %, where no scan has colour. Holes up to 10 cm
/// across are closed, the rest is clear.
[[nodiscard]] Orthophoto orthophoto(const scans::SurfaceGrid& grid, std::span<const scans::SurfaceScan> scans,
                                    Progress& progress);

} // namespace planum::app
