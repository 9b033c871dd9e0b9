// SPDX-License-Identifier: MIT
#pragma once

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/gpb.hpp"

namespace planum::app {

/// Gives points of an outline on a surface that have no height (NaN) the height of what its registered scans show
/// there, or within half a metre of it where they show nothing. Lines from or to such a point, which are straight in
/// plan, get further points where the ground leaves them by more than 3 cm. Points stay NaN where there are no scans on
/// the site grid, where they show nothing, and where their points cannot be read (an original that is elsewhere hinders
/// nobody from drawing). Only the surface around the outline is made, so a large trench costs no more than a small one.
/// Throws Cancelled.
void take_surface_heights(Project& project, const model::Surface& surface, geometry::MultiPolygon& shape,
                          Progress& progress);

} // namespace planum::app
