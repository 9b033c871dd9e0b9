// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace planum::scans {

/// Where the square cells of a plan lie: row 0 is the southernmost, column 0 the westernmost.
///
/// Invariant: the south-west corner is a whole multiple of the cell size, so the grids of all surfaces of
/// a dig fall on each other and two of them differ by whole cells only.
struct GridFrame {
    std::int64_t west = 0;  ///< of the corner, in cells from x = 0 of the site grid
    std::int64_t south = 0; ///< in cells from y = 0
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    double cell = 0.02; ///< side [m]

    [[nodiscard]] std::size_t cells() const noexcept {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }

    [[nodiscard]] std::size_t at(std::int32_t row, std::int32_t column) const noexcept {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }

    /// Centre of a cell in site coordinates [m].
    [[nodiscard]] double x(std::int32_t column) const noexcept {
        return (static_cast<double>(west + column) + 0.5) * cell;
    }

    [[nodiscard]] double y(std::int32_t row) const noexcept { return (static_cast<double>(south + row) + 0.5) * cell; }

    friend bool operator==(const GridFrame&, const GridFrame&) = default;
};

/// What a cell of a surface is known to be.
enum class CellState : std::uint8_t {
    Unseen,  ///< too few points
    Surface, ///< one height
    Face,    ///< steeper than 60° or with two heights: a side, no surface
    Disputed ///< scans of this surface disagree beyond what their noise allows
};

/// One recorded state of one area as heights. All vectors have frame.cells() values, row by row from the
/// south.
struct SurfaceGrid {
    GridFrame frame;
    std::vector<float> height; ///< robust height in site [m]; NaN where Unseen
    std::vector<float> spread; ///< robust standard deviation of the heights in the cell [m]
    std::vector<float>
        pose_sigma;           ///< vertical σ from the registration of the scans seen here [m]; common to neighbours
    std::vector<float> slope; ///< of the ground over neighbouring cells, tangent; NaN where unknown
    std::vector<std::uint16_t> count; ///< points, at most 65535
    std::vector<CellState> state;
    /// Where the side runs through a Face, from the middle of the cell to east and north [cells]; not a number where
    /// nobody knows. May be empty: nobody knows anywhere.
    std::vector<float> side_east = {};
    std::vector<float> side_north = {};
    /// How high ground can reach that nobody saw (see lines_of_sight()) [m]; not a number where no shadow says so.
    /// May be empty: none does.
    std::vector<float> ceiling = {};
};

} // namespace planum::scans
