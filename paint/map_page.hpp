// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <QRectF>

#include "core/geometry/map_sheet.hpp"

namespace planum::paint {

/// One entry of the key at its place [pt].
struct PlacedKey {
    const geometry::SheetKey* key = nullptr;
    QRectF swatch;
    double text_x = 0.0;
    double base_line = 0.0;
};

/// Where the parts of a map sheet lie on paper [pt]. The sheet must outlive it.
struct MapPage {
    double width = 0.0;
    double height = 0.0;
    QRectF frame; ///< the map itself
    double points_per_metre = 0.0;
    double title_size = 14.0;
    double foot = 0.0; ///< upper edge of scale bar and north arrow
    std::vector<PlacedKey> keys;

    [[nodiscard]] QPointF on_paper(const geometry::MapSheet& sheet, double x, double y) const {
        return {frame.left() + (x - sheet.extent.low[0]) * points_per_metre,
                frame.bottom() - (y - sheet.extent.low[1]) * points_per_metre};
    }
};

inline constexpr double kPointsPerMillimetre = 72.0 / 25.4;
inline constexpr double kMapMargin = 28.0; ///< [pt]
inline constexpr double kFootHeight = 30.0;

/// Lays a sheet out at 1 : `scale` on a page that just holds it; on a larger page `width` and `height` [pt] it is moved
/// into the middle. Needs ensure_qt_runtime(). Throws BadInput for an empty extent or scale.
[[nodiscard]] MapPage lay_out_map(const geometry::MapSheet& sheet, double scale, double width = 0.0,
                                  double height = 0.0);

/// How far apart the ticks of an axis (0: along, 1: up) stand [m]: a round length of up to 6 cm on paper; less where an
/// axis of a section would have fewer than three ticks or one of a plan fewer than two. Both axes of a plan have the
/// same.
[[nodiscard]] double tick_step(const geometry::MapSheet& sheet, const MapPage& page, std::size_t axis);

/// A length of 1, 2 or 5 times a power of ten that is not longer than `most`.
[[nodiscard]] double round_length(double most);

} // namespace planum::paint
