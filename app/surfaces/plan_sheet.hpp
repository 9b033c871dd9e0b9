// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/map_sheet.hpp"

namespace planum::app {

struct PlanRequest {
    std::string surface; ///< name, DAY or AREA::NAME; empty: the last one of the project
    std::string over;    ///< a unit: only its outlines, on all surfaces of its area one over the other
    bool colour = false; ///< scan colour in place of the relief
    double cell = 0.02;  ///< of the picture under the outlines [m]
};

struct PlanSheet {
    geometry::MapSheet sheet;
    std::string surface;            ///< whose ground is shown; empty: none
    std::vector<std::string> units; ///< that are outlined
    std::vector<std::string> notes; ///< what could not be shown, and why
};

/// A plan: the ground from the scans, outlines, unit numbers with the height of the ground below them where the unit
/// has no level of its own, levels, finds of its days. Without registered scans there are outlines only. Throws
/// NotFound for a surface or unit that is not there, BadInput when there is nothing to show.
[[nodiscard]] PlanSheet plan_sheet(Project& project, const PlanRequest& request, Progress& progress);

} // namespace planum::app
