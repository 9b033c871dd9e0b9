// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>

#include "core/geometry/map_sheet.hpp"
#include "paint/map_page.hpp"

namespace planum::paint {

/// Paints a sheet as it was laid out, in points; `scale` is 1 : scale.
void paint_map(QPainter& painter, const geometry::MapSheet& sheet, const MapPage& page, double scale);

} // namespace planum::paint
