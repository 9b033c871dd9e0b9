// SPDX-License-Identifier: MIT
#include "scans/surface/undug_ground.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "scans/surface/surface_difference.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::Ground;

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr double kPose = 0.0003; // σ of either surface [m]

using Inside = std::function<bool(double x, double y)>;

double level(double /*x*/, double /*y*/) { return 1.0; }

/// 4 × 3 m of ground, one point of 2 mm noise in each cell.
SurfaceGrid surface(const Ground& ground, std::uint32_t seed) {
    SurfaceGrid grid;
    grid.frame = {0, 0, 200, 150, 0.02};
    const std::size_t cells = grid.frame.cells();
    grid.spread.assign(cells, 0.0F);
    grid.pose_sigma.assign(cells, static_cast<float>(kPose));
    grid.slope.assign(cells, 0.0F);
    grid.count.assign(cells, 1);
    grid.state.assign(cells, CellState::Surface);
    grid.ceiling.assign(cells, kUnknown);
    test::Shots random(seed);
    for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
        for (std::int32_t column = 0; column < grid.frame.columns; ++column)
            grid.height.push_back(
                static_cast<float>(ground(grid.frame.x(column), grid.frame.y(row)) + 0.002 * random.normal()));
    }
    return grid;
}

void for_each(SurfaceGrid& grid, const Inside& inside, const std::function<void(std::size_t)>& change) {
    for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
        for (std::int32_t column = 0; column < grid.frame.columns; ++column) {
            if (inside(grid.frame.x(column), grid.frame.y(row))) change(grid.frame.at(row, column));
        }
    }
}

SurfaceGrid without(SurfaceGrid grid, const Inside& inside) {
    for_each(grid, inside, [&](std::size_t cell) {
        grid.state[cell] = CellState::Unseen;
        grid.height[cell] = kUnknown;
        grid.slope[cell] = kUnknown;
        grid.count[cell] = 0;
        grid.pose_sigma[cell] = 0.0F;
    });
    return grid;
}

Inside square(double x, double y, double half) {
    return [=](double to_x, double to_y) { return std::abs(to_x - x) < half && std::abs(to_y - y) < half; };
}

Ground with_pit(const Inside& inside, double depth) {
    return [=](double x, double y) { return inside(x, y) ? 1.0 - depth : 1.0; };
}

/// Share of the cells inside that are undug.
double undug_share(const SurfaceGrid& before, const SurfaceGrid& after, const Inside& inside,
                   std::vector<SpotHeight> spots_before = {}, std::vector<SpotHeight> spots_after = {}) {
    const FilledHeights was = fill_gaps(before, {}, {.spots = std::move(spots_before)});
    const FilledHeights is = fill_gaps(after, {}, {.spots = std::move(spots_after)});
    const std::vector<bool> undug = undug_ground({before, was}, {after, is});
    double all = 0.0;
    double number = 0.0;
    SurfaceGrid grid = before;
    for_each(grid, inside, [&](std::size_t cell) {
        all += 1.0;
        number += undug[cell] ? 1.0 : 0.0;
    });
    return number / all;
}

const Inside kEverywhere = [](double, double) { return true; };

} // namespace

TEST_CASE("Ground on which nobody dug counts for the area, not for the volume and its bound") {
    const SurfaceGrid before = surface(level, 1);
    const SurfaceGrid after = surface(level, 2);
    CHECK(undug_share(before, after, kEverywhere) > 0.95);
    const DugVolume volume = dug_volumes(before, after, {}, 1)[0];
    VolumeOptions plain;
    plain.undug.reset();
    const DugVolume all = dug_volumes(before, after, {}, 1, plain)[0];
    CHECK(volume.area == Approx(12.0));
    CHECK(volume.undug_area > 11.4);
    CHECK(all.undug_area == 0.0);
    CHECK(volume.bound() < 0.1 * all.bound());
    CHECK(std::abs(volume.net) <= volume.bound());
}

TEST_CASE("A small pit in wide ground has its volume, and the bound of a small pit") {
    const Inside pit = square(2.0, 1.5, 0.3);
    const SurfaceGrid before = surface(level, 3);
    const SurfaceGrid after = surface(with_pit(pit, 0.1), 4);
    CHECK(undug_share(before, after, pit) == 0.0);
    CHECK(undug_share(before, after, square(2.0, 1.5, 0.31)) == 0.0); // its sides
    const DugVolume volume = dug_volumes(before, after, {}, 1)[0];
    CHECK(volume.net == Approx(0.036).margin(volume.bound()));
    VolumeOptions plain;
    plain.undug.reset();
    CHECK(volume.bound() < 0.25 * dug_volumes(before, after, {}, 1, plain)[0].bound());
}

TEST_CASE("Ground that sank as a whole was dug where the poses cannot have lowered it so much") {
    const SurfaceGrid before = surface(level, 5);
    const auto lowered = [](double by) { return surface([=](double, double) { return 1.0 - by; }, 6); };
    CHECK(undug_share(before, lowered(0.0008), kEverywhere) > 0.95);
    CHECK(undug_share(before, lowered(0.003), kEverywhere) == 0.0);
    SurfaceGrid unsure = lowered(0.01);
    std::fill(unsure.pose_sigma.begin(), unsure.pose_sigma.end(), 0.01F);
    CHECK(undug_share(before, unsure, kEverywhere) == 0.0); // a centimetre is a centimetre, whoever placed the scans
}

TEST_CASE("What is in shadow on one day or both is undug in the midst of undug ground, not at the edge of a pit") {
    const Inside shadow = square(1.0, 1.0, 0.2);
    const Inside wide = square(2.8, 1.8, 0.5);
    const Inside either = [&](double x, double y) { return shadow(x, y) || wide(x, y); };
    const SurfaceGrid before = surface(level, 7);
    const SurfaceGrid after = surface(level, 8);
    CHECK(undug_share(without(before, either), without(after, either), shadow) > 0.95);
    CHECK(undug_share(without(before, either), without(after, either), wide) > 0.9);
    CHECK(undug_share(before, without(after, either), shadow) > 0.95);
    CHECK(undug_share(without(before, either), after, shadow) > 0.95);
    const SurfaceGrid dug = surface(with_pit(square(1.0, 1.5, 0.3), 0.2), 9);
    CHECK(undug_share(before, without(dug, shadow), square(1.0, 1.15, 0.05)) == 0.0);
}

TEST_CASE("A pit whose floor nobody saw was dug when a line of sight runs below the ground that was") {
    const Inside pit = square(2.0, 1.5, 0.15);
    const SurfaceGrid before = surface(level, 10);
    const SurfaceGrid closed = without(surface(level, 11), pit);
    REQUIRE(undug_share(before, closed, pit) > 0.9);
    SurfaceGrid open = closed;
    for_each(open, square(2.06, 1.5, 0.08), [&](std::size_t cell) { open.ceiling[cell] = 0.9F; });
    CHECK(undug_share(before, open, pit) < 0.03); // but for a cell in a corner
    CHECK(undug_share(open, before, pit) < 0.03); // and filled in, when it is the other way round
}

TEST_CASE("A pit whose floor nobody saw was dug when points of its side lie below the ground that was") {
    const Inside pit = square(2.0, 1.5, 0.15);
    const SurfaceGrid before = surface(level, 12);
    SurfaceGrid after = without(surface(level, 13), pit);
    for_each(
        after, [](double x, double y) { return std::abs(x - 2.13) < 0.01 && std::abs(y - 1.5) < 0.13; },
        [&](std::size_t cell) {
            after.state[cell] = CellState::Face;
            after.height[cell] = 0.9F;
            after.spread[cell] = 0.01F;
            after.count[cell] = 2;
        });
    CHECK(undug_share(before, after, pit) < 0.03);
}

TEST_CASE("A floor laid by a level on one day only was dug") {
    const Inside pit = square(2.0, 1.5, 0.25);
    const SurfaceGrid before = without(surface(level, 14), pit);
    const SurfaceGrid after = without(surface(level, 15), pit);
    const SpotHeight spot{
        2.0, 1.5, 0.5, 0.02, {{{{1.72, 1.22, 0.0}, {2.28, 1.22, 0.0}, {2.28, 1.78, 0.0}, {1.72, 1.78, 0.0}}}}};
    CHECK(undug_share(before, after, pit, {}, {spot}) == 0.0);
    CHECK(undug_share(before, after, square(2.0, 1.5, 0.1), {spot}, {spot}) > 0.95); // still open on the next day
}

TEST_CASE("A side is undug where it stands, and was dug where it was cut back") {
    const auto step = [](double at, std::uint32_t seed) {
        SurfaceGrid grid = surface([=](double x, double) { return x < at ? 1.0 : 0.4; }, seed);
        grid.side_east.assign(grid.frame.cells(), kUnknown);
        grid.side_north.assign(grid.frame.cells(), kUnknown);
        for_each(
            grid, [=](double x, double) { return std::abs(x - at) < 0.011; },
            [&](std::size_t cell) {
                grid.state[cell] = CellState::Face;
                grid.height[cell] = 0.7F;
                grid.spread[cell] = 0.2F;
                grid.side_east[cell] = 0.0F;
                grid.side_north[cell] = 0.0F;
            });
        return grid;
    };
    const Inside beside = [](double x, double y) { return std::abs(x - 1.99) < 0.03 && std::abs(y - 1.5) < 1.0; };
    CHECK(undug_share(step(2.01, 16), step(2.01, 17), beside) > 0.95);
    CHECK(undug_share(step(2.01, 16), step(1.97, 18), beside) == 0.0);
    const DugVolume volume = dug_volumes(step(2.01, 16), step(1.97, 18), {}, 1)[0];
    CHECK(volume.net == Approx(0.04 * 3.0 * 0.6).epsilon(0.05));
}
