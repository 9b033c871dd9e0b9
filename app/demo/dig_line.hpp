// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <vector>

namespace planum::app::demo {

/// A corner of the lattice of cells.
struct Corner {
    int x = 0;
    int y = 0;

    friend auto operator<=>(const Corner&, const Corner&) = default;
};

/// A point in units of cells.
struct LinePoint {
    double x = 0.0;
    double y = 0.0;
};

/// A line along cell edges, smoothed and with few points: the stairs of the cells go, what is left is within
/// half a cell of the line through the middles of the edges. Ends stay. The same from both sides.
[[nodiscard]] std::vector<LinePoint> simplified_piece(std::vector<Corner> piece);

/// The same for a closed line; the last corner is not repeated.
[[nodiscard]] std::vector<LinePoint> simplified_loop(std::vector<Corner> ring);

} // namespace planum::app::demo
