// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// Sums over square windows of a grid, each in constant time whatever the window's size (summed-area table).
template<class Value>
class WindowSums {
  public:
    /// `value_of(cell)` is asked once for each cell, row by row.
    template<class ValueOf>
    WindowSums(const GridFrame& frame, const ValueOf& value_of)
        : rows_(frame.rows), columns_(frame.columns), sums_(static_cast<std::size_t>(frame.rows + 1) * wide()) {
        for (std::int32_t row = 0; row < rows_; ++row) {
            Value in_row{};
            for (std::int32_t column = 0; column < columns_; ++column) {
                in_row += static_cast<Value>(value_of(frame.at(row, column)));
                sums_[at(row + 1, column + 1)] = sums_[at(row, column + 1)] + in_row;
            }
        }
    }

    /// Over all cells no more than `reach` cells away in row and in column, the cell itself included.
    [[nodiscard]] Value around(std::int32_t row, std::int32_t column, std::int32_t reach) const noexcept {
        const Window w = window(row, column, reach);
        return sums_[at(w.north, w.east)] - sums_[at(w.south, w.east)] - sums_[at(w.north, w.west)] +
               sums_[at(w.south, w.west)];
    }

    /// How many cells around() sums up; fewer at the edges of the grid.
    [[nodiscard]] std::int32_t cells_around(std::int32_t row, std::int32_t column, std::int32_t reach) const noexcept {
        const Window w = window(row, column, reach);
        return (w.north - w.south) * (w.east - w.west);
    }

  private:
    struct Window {
        std::int32_t south = 0;
        std::int32_t west = 0;
        std::int32_t north = 0; // the first row and column beyond
        std::int32_t east = 0;
    };

    [[nodiscard]] Window window(std::int32_t row, std::int32_t column, std::int32_t reach) const noexcept {
        return {std::max(0, row - reach), std::max(0, column - reach), std::min(rows_, row + reach + 1),
                std::min(columns_, column + reach + 1)};
    }

    [[nodiscard]] std::size_t wide() const noexcept { return static_cast<std::size_t>(columns_) + 1; }

    [[nodiscard]] std::size_t at(std::int32_t row, std::int32_t column) const noexcept {
        return static_cast<std::size_t>(row) * wide() + static_cast<std::size_t>(column);
    }

    std::int32_t rows_;
    std::int32_t columns_;
    std::vector<Value> sums_; // over all cells to the south-west; a row and a column more than the grid
};

} // namespace planum::scans
