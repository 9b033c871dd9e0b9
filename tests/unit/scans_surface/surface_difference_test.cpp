// SPDX-License-Identifier: MIT
#include "scans/surface/surface_difference.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include "core/base/error.hpp"
#include "scans/surface/surface_builder.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::Ground;
using planum::test::GroundShot;
using planum::test::shoot;
using planum::test::Shots;

namespace {

SurfaceGrid surface(const Ground& ground, std::uint32_t seed, const GridFrame& frame, double pose_sigma = 0.0) {
    GroundShot shot;
    shot.box = {-0.1, -0.1, 3.1, 2.1};
    shot.seed = seed;
    SurfaceScan scan = shoot("a", shot, ground);
    scan.covariance(5, 5) = pose_sigma * pose_sigma;
    return build_surface(std::vector{scan}, frame, {}, Progress::none()).grid;
}

GridFrame three_by_two() { return frame_around({0.0, 0.0, 3.0, 2.0}, 0.02); }

double uneven(double x, double y) { return 10.0 + 0.05 * std::sin(3.0 * x) * std::cos(2.0 * y); }

} // namespace

TEST_CASE("The volume of a pit with upright sides is right whatever its place in the grid") {
    const GridFrame frame = three_by_two();
    const SurfaceGrid before = surface(uneven, 1, frame);
    for (const double shift : {0.0, 0.003, 0.009, 0.013}) {
        const auto dug = [&](double x, double y) {
            const bool inside = std::abs(x - 1.5 - shift) < 0.5 && std::abs(y - 1.0 + shift) < 0.4;
            return uneven(x, y) - (inside ? 0.6 : 0.0);
        };
        const std::vector<DugVolume> volume = dug_volumes(before, surface(dug, 2, frame), {}, 1);
        INFO(shift);
        CHECK(volume[0].net == Approx(0.48).epsilon(0.015));
        CHECK(std::abs(volume[0].net - 0.48) < volume[0].bound());
        CHECK(volume[0].bound() < 0.05);
        CHECK(volume[0].area == Approx(6.0).epsilon(0.001));
    }
}

TEST_CASE("Volumes of labels add up to the total, and each is its own") {
    const GridFrame frame = three_by_two();
    const SurfaceGrid before = surface(uneven, 3, frame);
    const auto dug = [](double x, double y) { return uneven(x, y) - (x < 1.0 ? 0.1 : x < 2.0 ? 0.2 : 0.0); };
    const SurfaceGrid after = surface(dug, 4, frame);
    std::vector<std::int32_t> label(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column)
            label[frame.at(row, column)] = frame.x(column) < 1.0 ? 0 : frame.x(column) < 2.0 ? 1 : -1;
    }
    const std::vector<DugVolume> volumes = dug_volumes(before, after, label, 2);
    CHECK(volumes[0].net == Approx(0.2).epsilon(0.01));
    CHECK(volumes[1].net == Approx(0.4).epsilon(0.01));
    const DugVolume total = dug_volumes(before, after, {}, 1)[0];
    CHECK(total.net == Approx(0.6).epsilon(0.01));
    VolumeOptions options;
    options.outline_sigma = 0.03;
    CHECK(dug_volumes(before, after, label, 2, options)[0].sigma > volumes[0].sigma);
    CHECK_THROWS_AS(dug_volumes(before, after, std::vector<std::int32_t>(3), 1), Error);
}

TEST_CASE("An error of a pose is common to all cells, so a larger area does not average it away") {
    const GridFrame frame = three_by_two();
    const SurfaceGrid before = surface(uneven, 5, frame, 0.003);
    const SurfaceGrid after = surface(uneven, 6, frame, 0.004);
    VolumeOptions all_ground;
    all_ground.undug.reset();
    const DugVolume volume = dug_volumes(before, after, {}, 1, all_ground)[0];
    CHECK(volume.sigma == Approx(6.0 * 0.005).epsilon(0.05));
}

TEST_CASE("Stated bounds hold the truth as often as they say") {
    const GridFrame frame = frame_around({0.0, 0.0, 1.0, 1.0}, 0.02);
    int held = 0;
    constexpr int kRuns = 40;
    for (int run = 0; run < kRuns; ++run) {
        GroundShot shot;
        shot.box = {0.0, 0.0, 1.0, 1.0};
        shot.per_square_metre = 5000.0;
        const auto dug = [](double x, double y) {
            return uneven(x, y) - (std::hypot(x - 0.5, y - 0.5) < 0.3 ? 0.2 : 0.0);
        };
        shot.seed = 100U + static_cast<std::uint32_t>(run);
        const SurfaceGrid a = build_surface(std::vector{shoot("a", shot, uneven)}, frame, {}, Progress::none()).grid;
        shot.seed += 1000;
        const SurfaceGrid b = build_surface(std::vector{shoot("b", shot, dug)}, frame, {}, Progress::none()).grid;
        const DugVolume volume = dug_volumes(a, b, {}, 1)[0];
        held += std::abs(volume.net - 0.2 * 3.14159265 * 0.09) <= volume.bound() ? 1 : 0;
    }
    CHECK(held >= 36);
}

TEST_CASE("A shadow between known ground is filled and counts for the uncertainty, a large one does not count") {
    const GridFrame frame = three_by_two();
    Shots shots(7);
    const auto tilted = [](double x, double y) { return 5.0 + 0.1 * x - 0.05 * y; };
    Shots all(8);
    all.add_ground({{-0.1, -0.1, 3.1, 2.1}, 25000.0, 0.002, 0}, tilted);
    for (std::size_t i = 0; i < all.block().size(); ++i) {
        const double x = all.block().x[i];
        const double y = all.block().y[i];
        const bool small = std::hypot(x - 0.7, y - 1.0) < 0.15;
        const bool large = std::abs(x - 2.2) < 0.6 && std::abs(y - 1.0) < 0.6;
        if (!small && !large) shots.add(x, y, all.block().z[i]);
    }
    const SurfaceGrid grid = build_surface(std::vector{shots.scan("a")}, frame, {}, Progress::none()).grid;
    VolumeOptions options;
    options.gaps.reach = 0.3;
    const FilledHeights filled = fill_gaps(grid, options.gaps);
    const std::size_t in_small = frame.at(50, 35);
    CHECK_FALSE(filled.was_seen[in_small]);
    CHECK(static_cast<double>(filled.height[in_small]) == Approx(tilted(frame.x(35), frame.y(50))).margin(0.005));
    CHECK(filled.sigma[in_small] > 0.0F);
    CHECK(std::isnan(filled.height[frame.at(50, 110)]));
    const DugVolume volume = dug_volumes(grid, grid, {}, 1, options)[0];
    CHECK(volume.net == 0.0);
    CHECK(volume.unseen_area == Approx(0.36).epsilon(0.1)); // what is left of 1.2 × 1.2 m
    CHECK(volume.area + volume.unseen_area == Approx(6.0));
}

TEST_CASE("A change is told from none at the stated level") {
    const GridFrame frame = three_by_two();
    const SurfaceGrid a = surface(uneven, 9, frame);
    const SurfaceGrid b = surface(uneven, 10, frame);
    const SurfaceDifference none = surface_difference(a, b, 0.0);
    std::size_t significant = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < none.change.size(); ++i) {
        if (std::isnan(none.change[i])) continue;
        ++all;
        significant += std::abs(none.change[i]) > none.detectable[i] ? 1U : 0U;
    }
    // The median of n points has a σ of 1.25 s/√n and n is small, so it is more than 5 %, but of that order.
    CHECK(static_cast<double>(significant) < 0.2 * static_cast<double>(all));
    const SurfaceDifference with = surface_difference(a, b, 0.02);
    for (std::size_t i = 0; i < with.change.size(); ++i) {
        if (!std::isnan(with.change[i])) REQUIRE(std::abs(with.change[i]) < with.detectable[i]);
    }
}

TEST_CASE("Surfaces that lie apart have nothing in common; cells of different size are refused") {
    CHECK(common_frame({0, 0, 10, 10, 0.02}, {10, 0, 5, 5, 0.02}).cells() == 0);
    CHECK(common_frame({0, 0, 10, 10, 0.02}, {-3, 4, 8, 30, 0.02}) == GridFrame{0, 4, 5, 6, 0.02});
    CHECK_THROWS_AS(common_frame({0, 0, 1, 1, 0.02}, {0, 0, 1, 1, 0.05}), Error);
}

TEST_CASE("A pit with upright sides has its volume wherever its sides lie in their cells") {
    const auto field = [](double depth, double shift) {
        PointBlock points;
        const auto add = [&](double x, double y, double z) {
            points.x.push_back(x);
            points.y.push_back(y);
            points.z.push_back(z);
            points.validity.push_back(Validity::Valid);
        };
        const double low = 1.0 + shift;
        for (int i = 0; i < 300; ++i) {
            for (int j = 0; j < 300; ++j) {
                const double x = 0.01 * i + 0.005;
                const double y = 0.01 * j + 0.005;
                const bool inside = x > low && x < low + 1.0 && y > low && y < low + 1.0;
                add(x, y, inside ? -depth : 0.0);
            }
        }
        for (double z = -0.005; z > -depth; z -= 0.01) {
            for (double along = low + 0.005; along < low + 1.0; along += 0.01) {
                add(along, low + 0.001, z);
                add(along, low + 0.999, z);
                add(low + 0.001, along, z);
                add(low + 0.999, along, z);
            }
        }
        SurfaceScan scan;
        scan.points = std::make_shared<BlockPoints>(std::move(points));
        return scan;
    };
    const GridFrame frame = frame_around({0.2, 0.2, 2.8, 2.8}, 0.02);
    const auto built = [&](double depth, double shift) {
        return build_surface(std::vector{field(depth, shift)}, frame, {}, Progress::none()).grid;
    };
    const SurfaceGrid before = built(0.0, 0.0);
    for (const double shift : {0.0, 0.004, 0.01, 0.015}) {
        INFO("sides " << shift << " m from the edge of a cell");
        const DugVolume volume = dug_volumes(before, built(0.3, shift), {}, 1)[0];
        CHECK(volume.net == Approx(0.3).epsilon(0.01));
        CHECK(std::abs(volume.net - 0.3) < volume.bound());
    }
}

TEST_CASE("What a shadow hides on both days is unsure by what was dug there, not by how deep the shadow is") {
    const auto in_shadow = [](double ground, bool hidden) {
        SurfaceGrid grid;
        grid.frame = {0, 0, 100, 100, 0.02};
        const std::size_t cells = grid.frame.cells();
        grid.height.assign(cells, static_cast<float>(ground));
        grid.spread.assign(cells, 0.002F);
        grid.pose_sigma.assign(cells, 0.0F);
        grid.slope.assign(cells, 0.0F);
        grid.count.assign(cells, 3);
        grid.state.assign(cells, CellState::Surface);
        grid.ceiling.assign(cells, std::numeric_limits<float>::quiet_NaN());
        for (std::int32_t row = 40; hidden && row < 60; ++row) {
            for (std::int32_t column = 40; column < 60; ++column) {
                const std::size_t cell = grid.frame.at(row, column);
                grid.state[cell] = CellState::Unseen;
                grid.height[cell] = std::numeric_limits<float>::quiet_NaN();
                grid.ceiling[cell] = 2.0F;
            }
        }
        return grid;
    };
    const auto sigma = [](const SurfaceGrid& before, const SurfaceGrid& after) {
        return dug_volumes(before, after, {}, 1)[0].sigma;
    };
    const double seen_once = sigma(in_shadow(1.0, false), in_shadow(0.9, true));
    CHECK(seen_once > 0.04 * 0.1); // a fifth of a metre over some of 0.16 m²
    CHECK(sigma(in_shadow(1.0, true), in_shadow(0.9, true)) < 0.5 * seen_once);
    CHECK(sigma(in_shadow(1.0, true), in_shadow(0.2, true)) > sigma(in_shadow(1.0, true), in_shadow(0.9, true)));
}
