// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>

#include "scans/surface/gap_filling.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

constexpr float kGround = 1.0F;
constexpr float kPlanum = 0.3F;
constexpr std::int32_t kRows = 30;     // of 2 cm
constexpr std::int32_t kColumns = 150; // 3 m
constexpr std::int32_t kSeen = 20;     // columns of the planum that a scanner reached

bool is_dug(std::int32_t row, std::int32_t column) {
    return row >= 5 && row < kRows - 5 && column >= 5 && column < kColumns - 5;
}

/// A narrow trench dug to a planum, of which one end was seen; its sides show only as the ground above them.
SurfaceGrid trench_behind_a_baulk() {
    SurfaceGrid grid;
    grid.frame = {0, 0, kColumns, kRows, 0.02};
    const std::size_t cells = grid.frame.cells();
    grid.height.assign(cells, kGround);
    grid.spread.assign(cells, 0.002F);
    grid.pose_sigma.assign(cells, 0.0F);
    grid.slope.assign(cells, 0.0F);
    grid.count.assign(cells, 3);
    grid.state.assign(cells, CellState::Surface);
    grid.ceiling.assign(cells, std::numeric_limits<float>::quiet_NaN());
    for (std::int32_t row = 0; row < kRows; ++row) {
        for (std::int32_t column = 0; column < kColumns; ++column) {
            if (!is_dug(row, column)) continue;
            const std::size_t cell = grid.frame.at(row, column);
            grid.height[cell] = kPlanum;
            grid.ceiling[cell] = kPlanum + 0.5F; // lines of sight over the edges
            if (column >= kSeen) grid.state[cell] = CellState::Unseen;
        }
    }
    return grid;
}

geometry::MultiPolygon outline_of_planum() {
    return {{{{0.1, 0.1, 0.0}, {2.9, 0.1, 0.0}, {2.9, 0.5, 0.0}, {0.1, 0.5, 0.0}}}};
}

} // namespace

TEST_CASE("A planum lies as level where no scanner looked as where one did, as far as its outline goes") {
    const SurfaceGrid grid = trench_behind_a_baulk();
    const std::size_t far = grid.frame.at(15, 140);
    const FilledHeights without = fill_gaps(grid);
    REQUIRE(without.height[far] > kPlanum + 0.2F); // beyond the reach it comes from the ground beside the trench
    const FilledHeights with = fill_gaps(grid, {}, {.spots = {}, .plana = {outline_of_planum()}});
    for (std::int32_t column = kSeen; column < kColumns - 5; ++column) {
        for (std::int32_t row = 5; row < kRows - 5; ++row)
            CHECK(static_cast<double>(with.height[grid.frame.at(row, column)]) ==
                  Approx(static_cast<double>(kPlanum)).margin(1e-4));
    }
    CHECK_FALSE(with.was_seen[far]);
}

TEST_CASE("What was filled in on a planum is no more uncertain than plana are level") {
    const SurfaceGrid grid = trench_behind_a_baulk();
    const GapOptions options;
    const std::size_t far = grid.frame.at(15, 140);
    const FilledHeights with = fill_gaps(grid, options, {.spots = {}, .plana = {outline_of_planum()}});
    CHECK(with.sigma[far] == options.planum_doubt);
    CHECK(with.shadow_sigma[far] == options.planum_doubt);
    const FilledHeights without = fill_gaps(grid, options);
    CHECK(without.sigma[grid.frame.at(15, 80)] > options.planum_doubt);
}

TEST_CASE("A planum of which nobody saw anything is not made up from the ground above it") {
    SurfaceGrid grid = trench_behind_a_baulk();
    for (std::int32_t row = 0; row < kRows; ++row) {
        for (std::int32_t column = 0; column < kColumns; ++column) {
            if (is_dug(row, column)) grid.state[grid.frame.at(row, column)] = CellState::Unseen;
        }
    }
    GapOptions options;
    options.doubt = 1.0; // so that the middle of the trench is more uncertain than a planum
    const FilledHeights without = fill_gaps(grid, options);
    const FilledHeights with = fill_gaps(grid, options, {.spots = {}, .plana = {outline_of_planum()}});
    REQUIRE(without.sigma[grid.frame.at(15, 75)] > options.planum_doubt);
    CHECK(with.height == without.height);
    CHECK(with.sigma == without.sigma);
    CHECK(with.shadow_sigma == without.shadow_sigma);
}

TEST_CASE("A planum's outline with too few points says nothing") {
    const SurfaceGrid grid = trench_behind_a_baulk();
    const FilledHeights without = fill_gaps(grid);
    const FilledHeights with =
        fill_gaps(grid, {}, {.spots = {}, .plana = {{}, {{}}, {{{}}}, {{{{0.1, 0.1, 0.0}, {2.9, 0.1, 0.0}}}}}});
    CHECK(with.height == without.height);
    CHECK(with.sigma == without.sigma);
}
