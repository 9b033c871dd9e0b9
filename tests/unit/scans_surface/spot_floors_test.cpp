// SPDX-License-Identifier: MIT
#include "scans/surface/spot_floors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scans/surface/gap_filling.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

constexpr double kGround = 1.0;
constexpr double kFloor = 0.4;
constexpr std::int32_t kSide = 60; // cells of 2 cm: 1.2 m
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

bool is_pit(std::int32_t row, std::int32_t column) { return row >= 20 && row < 40 && column >= 20 && column < 40; }

/// Even ground around a square pit of 40 cm with upright sides, into which nobody saw.
SurfaceGrid ground_with_pit() {
    SurfaceGrid grid;
    grid.frame = {0, 0, kSide, kSide, 0.02};
    const std::size_t cells = grid.frame.cells();
    grid.height.assign(cells, static_cast<float>(kGround));
    grid.spread.assign(cells, 0.002F);
    grid.pose_sigma.assign(cells, 0.0F);
    grid.slope.assign(cells, 0.0F);
    grid.count.assign(cells, 3);
    grid.state.assign(cells, CellState::Surface);
    grid.ceiling.assign(cells, kUnknown);
    for (std::int32_t row = 0; row < kSide; ++row) {
        for (std::int32_t column = 0; column < kSide; ++column) {
            if (!is_pit(row, column)) continue;
            grid.state[grid.frame.at(row, column)] = CellState::Unseen;
            grid.height[grid.frame.at(row, column)] = kUnknown;
        }
    }
    return grid;
}

SpotHeight floor_spot(double x, double y, double z = kFloor) {
    // The draughtsman's line lies 3 cm outside the rim.
    const geometry::MultiPolygon hollow = {
        {{{0.37, 0.37, 0.0}, {0.83, 0.37, 0.0}, {0.83, 0.83, 0.0}, {0.37, 0.83, 0.0}}}};
    return {x, y, z, 0.02, hollow};
}

double hole_volume(const FilledHeights& filled) {
    double volume = 0.0;
    for (const float height : filled.height) volume += (kGround - static_cast<double>(height)) * 0.0004;
    return volume;
}

} // namespace

TEST_CASE("A pit that no scanner looked into is as deep as its floor was measured") {
    const SurfaceGrid grid = ground_with_pit();
    REQUIRE(hole_volume(fill_gaps(grid)) == Approx(0.0).margin(1e-6));
    const SpotHeight spot = floor_spot(0.5, 0.7);
    const FilledHeights filled = fill_gaps(grid, {}, {.spots = {spot}});
    // Cells at the rim have ground around them, and are closed as gaps in it.
    const double all = (kGround - kFloor) * 0.4 * 0.4;
    CHECK(hole_volume(filled) > 0.6 * all);
    CHECK(hole_volume(filled) <= all);
    const auto at = [&](double x, double y) {
        return grid.frame.at(static_cast<std::int32_t>(y / 0.02), static_cast<std::int32_t>(x / 0.02));
    };
    CHECK(static_cast<double>(filled.height[at(0.51, 0.51)]) == Approx(kFloor));
    CHECK_FALSE(filled.was_seen[at(0.51, 0.51)]);
    CHECK(static_cast<double>(filled.sigma[at(0.51, 0.71)]) >= 0.019);
    CHECK(filled.sigma[at(0.71, 0.51)] > filled.sigma[at(0.51, 0.67)]); // farther away
    for (std::size_t cell = 0; cell < grid.frame.cells(); ++cell) {
        if (grid.state[cell] == CellState::Surface) REQUIRE(filled.height[cell] == grid.height[cell]);
    }
}

TEST_CASE("A floor measured a little outside the outline counts for the nearest cell in it") {
    const SurfaceGrid grid = ground_with_pit();
    SpotHeight spot = floor_spot(0.6, 0.39);
    for (auto& ring : spot.hollow[0]) {
        for (auto& p : ring) p[1] = std::max(p[1], 0.41);
    }
    CHECK(hole_volume(fill_gaps(grid, {}, {.spots = {spot}})) > 0.04);
    spot.y = 0.2; // on the ground beside the pit
    CHECK(hole_volume(fill_gaps(grid, {}, {.spots = {spot}})) == Approx(0.0).margin(1e-6));
}

TEST_CASE("Sides that were seen go on down to the floor, and beams that hang alone in a pit do not") {
    SurfaceGrid grid = ground_with_pit();
    const SpotHeight spot = floor_spot(0.7, 0.6);
    const double upright = hole_volume(fill_gaps(grid, {}, {.spots = {spot}}));
    grid.state[grid.frame.at(30, 30)] = CellState::Surface; // half way down, in the middle
    grid.height[grid.frame.at(30, 30)] = 0.7F;
    const double with_stray = hole_volume(fill_gaps(grid, {}, {.spots = {spot}}));
    CHECK(with_stray == Approx(upright).margin(0.3 * 0.0004 + 1e-6));
    grid = ground_with_pit();
    for (std::int32_t row = 20; row < 40; ++row) { // the western side falls at 45°, its upper 12 cm were seen
        for (std::int32_t column = 20; column < 26; ++column) {
            const std::size_t cell = grid.frame.at(row, column);
            grid.state[cell] = CellState::Surface;
            grid.height[cell] = static_cast<float>(kGround - 0.02 * (column - 19));
            grid.slope[cell] = 1.0F;
        }
    }
    const FilledHeights filled = fill_gaps(grid, {}, {.spots = {spot}});
    for (std::int32_t column = 29; column < 36; ++column) {
        CAPTURE(column);
        CHECK(static_cast<double>(filled.height[grid.frame.at(30, column)]) ==
              Approx(kGround - 0.02 * (column - 19)).margin(1e-5));
    }
}

TEST_CASE("The edge of an overhang is no side that goes on down to the floor") {
    SurfaceGrid grid = ground_with_pit();
    for (std::int32_t row = 20; row < 40; ++row) { // the rim, and between its cells what was seen under it
        grid.state[grid.frame.at(row, 20)] = CellState::Surface;
        grid.height[grid.frame.at(row, 20)] = static_cast<float>(kGround);
        grid.slope[grid.frame.at(row, 20)] = 1.5F;
        grid.state[grid.frame.at(row, 19)] = CellState::Face;
        grid.height[grid.frame.at(row, 19)] = 0.6F;
    }
    const SpotHeight spot = floor_spot(0.7, 0.6);
    const FilledHeights filled = fill_gaps(grid, {}, {.spots = {spot}});
    for (std::int32_t column = 27; column < 36; ++column) {
        CAPTURE(column);
        CHECK(static_cast<double>(filled.height[grid.frame.at(30, column)]) == Approx(kFloor));
    }
}

TEST_CASE("A floor that was measured in a pit says nothing of what nobody saw beside its outline") {
    SurfaceGrid grid = ground_with_pit();
    for (std::int32_t row = 10; row < 50; ++row) { // the pit opens onto a blind spot west of it
        for (std::int32_t column = 0; column < 20; ++column) {
            grid.state[grid.frame.at(row, column)] = CellState::Unseen;
            grid.height[grid.frame.at(row, column)] = kUnknown;
        }
    }
    const SpotHeight spot = floor_spot(0.5, 0.6);
    const FilledHeights filled = fill_gaps(grid, {}, {.spots = {spot}});
    CHECK(static_cast<double>(filled.height[grid.frame.at(30, 25)]) == Approx(kFloor));
    for (std::int32_t column = 0; column < 18; ++column) {
        CAPTURE(column);
        CHECK(static_cast<double>(filled.height[grid.frame.at(30, column)]) == Approx(kGround).margin(0.02));
    }
    for (std::int32_t row = 0; row < kSide; ++row) { // where nothing else is known, it is better than nothing
        for (std::int32_t column = 0; column < kSide; ++column) {
            if (is_pit(row, column)) continue;
            grid.state[grid.frame.at(row, column)] = CellState::Unseen;
            grid.height[grid.frame.at(row, column)] = kUnknown;
        }
    }
    CHECK(static_cast<double>(fill_gaps(grid, {}, {.spots = {spot}}).height[grid.frame.at(30, 5)]) == Approx(kFloor));
}

TEST_CASE("What the scans saw is stronger than a floor that was measured") {
    SurfaceGrid grid = ground_with_pit();
    const SpotHeight spot = floor_spot(0.6, 0.6);
    SECTION("a line of sight below it") {
        for (std::size_t cell = 0; cell < grid.frame.cells(); ++cell) {
            if (grid.state[cell] == CellState::Unseen) grid.ceiling[cell] = 0.3F;
        }
        const FilledHeights without = fill_gaps(grid);
        CHECK(fill_gaps(grid, {}, {.spots = {spot}}).height == without.height);
    }
    SECTION("ground around it") {
        for (std::int32_t row = 20; row < 40; ++row) {
            for (std::int32_t column = 20; column < 40; column += 2) {
                grid.state[grid.frame.at(row, column)] = CellState::Surface;
                grid.height[grid.frame.at(row, column)] = 0.8F;
            }
        }
        const FilledHeights without = fill_gaps(grid);
        CHECK(fill_gaps(grid, {}, {.spots = {spot}}).height == without.height);
    }
    SECTION("the edge of the grid") {
        const SpotHeight away = floor_spot(-5.0, 7.0);
        CHECK(hole_volume(fill_gaps(grid, {}, {.spots = {away}})) == Approx(0.0).margin(1e-6));
    }
}
