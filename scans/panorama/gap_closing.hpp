// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scans/panorama/projection.hpp"

namespace planum::scans {

/// What a panorama in the making holds of its points, column by column.
struct PicturePoints {
    std::span<const std::uint32_t> pixel;
    std::span<const std::array<float, 3>> place; ///< [m, scan's frame]
    std::span<const float> range;                ///< [m]
    std::span<const std::uint32_t> row;          ///< of the scanner's grid; empty: none is known
    std::span<const std::uint32_t> column;
};

/// A pixel without points, and the point of its neighbour that it shows instead.
struct ClosedPixel {
    std::uint32_t pixel = 0;
    std::uint32_t point = 0;
};

struct ClosingOptions {
    int most_pixels = 3;       ///< that may be closed in a row or column of the picture
    double agreement = 0.03;   ///< so much may the ranges on both sides differ, as a share of the range
    double alike_steps = 0.65; ///< ground going on: smallest to largest of three steps of the inverse range
};

/// Pixels in small holes. Where the scanner's grid is known, whatever lies between neighbours in the grid that agree in
/// range, or across whose rows one plane of ground goes on, however far apart they are in the picture; then gaps in
/// rows and in columns of the picture. No pixel twice.
[[nodiscard]] std::vector<ClosedPixel> close_gaps(const Projection& projection, const PicturePoints& points,
                                                  const ClosingOptions& options);

} // namespace planum::scans
