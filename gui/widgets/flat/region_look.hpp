// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>

#include "gui/viewmodels/region_shapes.hpp"

namespace planum::gui {

/// How a region is filled and outlined. Kinds differ by pattern as well as by colour, as on paper.
struct RegionLook {
    QColor fill;
    Qt::BrushStyle pattern = Qt::SolidPattern;
    QColor line;
    Qt::PenStyle dashed = Qt::SolidLine;
};

[[nodiscard]] RegionLook look_of(const RegionShape& shape);

} // namespace planum::gui
