// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/evidence/evidence.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/evidence.hpp"

namespace planum::app {

/// Where, inside outlines, scans of one surface disagree or the ground rose since the last scanned surface, over 0.1 m²
/// and more, on the cells that `areas` (from gather_evidence()) were compared on. A surface that nobody outlined yet is
/// looked at inside the outlines of the last one before it. What is outlined as spoil, slump, backfill, water or
/// equipment is known to be there and passed over. Kept in NAME.scans/evidence by the hash of scans, poses and
/// outlines. Surfaces whose points are missing are passed over; gather_evidence() names them. Throws Cancelled.
[[nodiscard]] std::vector<model::GroundAlteration>
altered_ground(Project& project, const std::vector<AreaEvidence>& areas, Progress& progress);

} // namespace planum::app
