// SPDX-License-Identifier: MIT
#include "scans/surface/window_sums.hpp"

#include <cstdlib>

#include "tests/support/catch.hpp"

using namespace planum::scans;

TEST_CASE("Sums over windows are those of their cells, cut off at the edges of the grid") {
    const GridFrame frame{-3, 7, 9, 6, 0.02};
    const auto value = [](std::size_t cell) { return static_cast<std::int32_t>(cell * cell % 23) - 8; };
    const WindowSums<std::int32_t> sums(frame, value);
    for (std::int32_t reach = 0; reach < 10; ++reach) {
        for (std::int32_t row = 0; row < frame.rows; ++row) {
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                std::int32_t sum = 0;
                std::int32_t cells = 0;
                for (std::int32_t r = 0; r < frame.rows; ++r) {
                    for (std::int32_t c = 0; c < frame.columns; ++c) {
                        if (std::abs(r - row) > reach || std::abs(c - column) > reach) continue;
                        sum += value(frame.at(r, c));
                        ++cells;
                    }
                }
                REQUIRE(sums.around(row, column, reach) == sum);
                REQUIRE(sums.cells_around(row, column, reach) == cells);
            }
        }
    }
}
