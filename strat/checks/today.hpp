// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/record.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

/// What a sheet still lacks.
struct SheetGaps {
    UnitIndex unit = model::kNoUnit;
    bool level = false;       ///< no measured height
    bool description = false; ///< neither description nor interpretation nor title
    bool relation = false;    ///< nothing recorded below it, and it is not natural ground

    friend bool operator==(const SheetGaps&, const SheetGaps&) = default;
};

/// The director's list of the day, each in the order of the record.
struct Today {
    std::vector<UnitIndex> open;     ///< begun or waiting: status open or partly excavated
    std::vector<UnitIndex> diggable; ///< of these, nothing undug lies above
    std::vector<SheetGaps> gaps;     ///< sheets that lack something
};

/// Void units and units without a sheet are left out. A cut or an interface has no body, so it is in
/// nobody's way: what lies above it counts instead. In a cycle group nothing may be dug, for nobody knows
/// what lies above. O(units + relations).
[[nodiscard]] Today today(const model::Record& record, const HarrisMatrix& matrix);

} // namespace planum::strat
