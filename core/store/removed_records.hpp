// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"

namespace planum::store {

/// Units and relations that were deleted on or after some moment, as they last stood.
struct RemovedRecords {
    std::vector<model::StratigraphicUnit> units;
    std::vector<model::PhysicalRelation> relations;
};

} // namespace planum::store
