// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/map_sheet.hpp"

namespace planum::geometry {

/// A plan or a section with the scale it is to be printed at.
struct ScaledSheet {
    MapSheet sheet;
    double scale = 20.0; ///< 1 : scale
};

/// Plans and sections that belong together on one page, below one another, under a heading.
struct SheetGroup {
    std::string title;
    std::string text; ///< a sentence or two below the title
    std::string site; ///< at the head, right
    std::vector<ScaledSheet> sheets;
};

} // namespace planum::geometry
