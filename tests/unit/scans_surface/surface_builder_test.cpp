// SPDX-License-Identifier: MIT
#include "scans/surface/surface_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.hpp"
#include "core/geometry/rigid.hpp"
#include "scans/surface/disputes.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::GroundShot;
using planum::test::shoot;
using planum::test::Shots;

namespace {

double rolling(double x, double y) { return 101.0 + 0.1 * std::sin(2.0 * x) + 0.05 * std::cos(3.0 * y); }

GridFrame two_metres() { return frame_around({0.0, 0.0, 2.0, 2.0}, 0.02); }

BuiltSurface build(const std::vector<SurfaceScan>& scans, const GridFrame& frame, const SurfaceOptions& options = {}) {
    return build_surface(scans, frame, options, Progress::none());
}

std::size_t count(const SurfaceGrid& grid, CellState state) {
    return static_cast<std::size_t>(std::count(grid.state.begin(), grid.state.end(), state));
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
               return x == y || (std::isnan(x) && std::isnan(y));
           });
}

/// Too slow to ship: all heights of each cell, sorted.
std::map<std::pair<long, long>, std::vector<double>> heights_by_cell(const PointBlock& points, double cell) {
    std::map<std::pair<long, long>, std::vector<double>> cells;
    for (std::size_t i = 0; i < points.size(); ++i) {
        cells[{std::lround(std::floor(points.y[i] / cell)), std::lround(std::floor(points.x[i] / cell))}].push_back(
            points.z[i]);
    }
    for (auto& [place, z] : cells) std::sort(z.begin(), z.end());
    return cells;
}

double median(const std::vector<double>& sorted) {
    const std::size_t n = sorted.size();
    return n % 2 == 1 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]);
}

} // namespace

TEST_CASE("On open ground a cell's height is the median of its points") {
    Shots shots(3);
    shots.add_ground({}, rolling);
    const GridFrame frame = two_metres();
    const BuiltSurface built = build({shots.scan("a")}, frame);
    const auto cells = heights_by_cell(shots.block(), frame.cell);
    CHECK(built.points == shots.block().size());
    REQUIRE(frame.cells() == 10000);
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            const auto found = cells.find({row, column});
            if (found == cells.end()) {
                CHECK(built.grid.state[cell] == CellState::Unseen);
                continue;
            }
            REQUIRE(built.grid.state[cell] == CellState::Surface);
            REQUIRE(built.grid.count[cell] == found->second.size());
            REQUIRE(std::abs(static_cast<double>(built.grid.height[cell]) - median(found->second)) < 1.1e-4);
        }
    }
}

TEST_CASE("Neither threads nor memory nor the order of points change a surface") {
    Shots shots(4);
    shots.add_ground({{-3.0, -3.0, 4.0, 4.0}, 8000.0, 0.003, 0}, rolling);
    const GridFrame frame = frame_around({-3.0, -3.0, 4.0, 4.0}, 0.02);
    SurfaceOptions one;
    one.threads = 1;
    const BuiltSurface first = build({shots.scan("a")}, frame, one);

    Shots backwards(5);
    for (std::size_t i = shots.block().size(); i-- > 0;)
        backwards.add(shots.block().x[i], shots.block().y[i], shots.block().z[i]);
    SurfaceOptions small;
    small.threads = 3;
    small.memory_bytes = 100000; // far less than the points of a tile: they are cut down to the smallest
    const BuiltSurface second = build({backwards.scan("a")}, frame, small);

    CHECK(first.points == second.points);
    CHECK(same_bits(first.grid.height, second.grid.height));
    CHECK(same_bits(first.grid.spread, second.grid.spread));
    CHECK(same_bits(first.grid.slope, second.grid.slope));
    CHECK(first.grid.state == second.grid.state);
    CHECK(first.grid.count == second.grid.count);
}

TEST_CASE("The slope is that of the ground, up to the foot of a wall") {
    const auto ground = [](double x, double y) { return x < 1.0 ? 0.3 * x + 0.4 * y : 0.3 * x + 0.4 * y + 0.8; };
    GroundShot shot;
    shot.noise = 0.0005;
    const BuiltSurface built = build({shoot("a", shot, ground)}, two_metres());
    const GridFrame& frame = built.grid.frame;
    std::size_t good = 0;
    std::size_t all = 0;
    for (std::int32_t row = 2; row < frame.rows - 2; ++row) {
        for (std::int32_t column = 2; column < frame.columns - 2; ++column) {
            if (std::abs(frame.x(column) - 1.0) < 0.02) continue; // the edge itself
            ++all;
            if (std::abs(static_cast<double>(built.grid.slope[frame.at(row, column)]) - 0.5) < 0.05) ++good;
        }
    }
    CHECK(static_cast<double>(good) > 0.99 * static_cast<double>(all));
}

TEST_CASE("What is steeper than 60 degrees is a face, what is not is ground") {
    for (const double degrees : {50.0, 70.0}) {
        const double tangent = std::tan(degrees * 3.14159265358979 / 180.0);
        const auto ground = [&](double x, double /*y*/) { return std::clamp(x - 0.5, 0.0, 0.6) * tangent; };
        const BuiltSurface built = build({shoot("a", {}, ground)}, two_metres());
        std::size_t faces = 0;
        std::size_t all = 0;
        for (std::int32_t row = 0; row < 100; ++row) {
            for (std::int32_t column = 28; column < 52; ++column) {
                const CellState state = built.grid.state[built.grid.frame.at(row, column)];
                all += state == CellState::Unseen ? 0 : 1;
                faces += state == CellState::Face ? 1U : 0U;
            }
        }
        INFO(degrees);
        const double share = static_cast<double>(faces) / static_cast<double>(all);
        CHECK((degrees > 60.0 ? share > 0.95 : share < 0.05));
    }
}

TEST_CASE("An upright side is a face of one or two cells and no surface") {
    Shots shots(7);
    const auto step = [](double x, double /*y*/) { return x < 1.011 ? 0.0 : 0.5; };
    shots.add_ground({}, step);
    for (int i = 0; i < 20000; ++i) shots.add(1.011, shots.uniform(0.0, 2.0), shots.uniform(0.0, 0.5));
    const BuiltSurface built = build({shots.scan("a")}, two_metres());
    for (std::int32_t row = 0; row < 100; ++row) {
        CHECK(built.grid.state[built.grid.frame.at(row, 50)] == CellState::Face);
        CHECK(built.grid.state[built.grid.frame.at(row, 48)] == CellState::Surface);
        CHECK(built.grid.state[built.grid.frame.at(row, 52)] == CellState::Surface);
    }
    CHECK(built.disputed.empty());
}

TEST_CASE("Somebody who stood there during one scan is not ground") {
    Shots before(8);
    before.add_ground({}, rolling);
    Shots during(9);
    during.add_ground({},
                      [](double x, double y) { return std::hypot(x - 1.0, y - 1.0) < 0.25 ? -50.0 : rolling(x, y); });
    Shots seen(10); // no ground under the person in the second scan
    for (std::size_t i = 0; i < during.block().size(); ++i) {
        if (during.block().z[i] > 0.0) seen.add(during.block().x[i], during.block().y[i], during.block().z[i]);
    }
    seen.add_cylinder(1.0, 1.0, 0.22, rolling(1.0, 1.0), rolling(1.0, 1.0) + 1.75, 6000);
    const BuiltSurface built = build({before.scan("a"), seen.scan("b")}, two_metres());
    const GridFrame& frame = built.grid.frame;
    double worst = 0.0;
    for (std::size_t cell = 0; cell < frame.cells(); ++cell) {
        const auto columns = static_cast<std::size_t>(frame.columns);
        const double truth = rolling(frame.x(static_cast<std::int32_t>(cell % columns)),
                                     frame.y(static_cast<std::int32_t>(cell / columns)));
        if (built.grid.state[cell] == CellState::Surface)
            worst = std::max(worst, std::abs(static_cast<double>(built.grid.height[cell]) - truth));
    }
    CHECK(worst < 0.02);
    CHECK(count(built.grid, CellState::Surface) > 9900);
    CHECK(built.passing.area > 0.02);
    CHECK(built.disputed.empty());
}

TEST_CASE("Mixed pixels that float behind an edge are left out") {
    Shots shots(11);
    shots.add_ground({{0.0, 0.0, 2.0, 2.0}, 6000.0, 0.002, 0}, rolling);
    for (int i = 0; i < 240; ++i) // 1 % of the points, anywhere up to a metre above
        shots.add(shots.uniform(0.0, 2.0), shots.uniform(0.0, 2.0), 101.0 + shots.uniform(0.2, 1.2));
    const BuiltSurface built = build({shots.scan("a")}, two_metres());
    const GridFrame& frame = built.grid.frame;
    std::size_t wrong = 0;
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            const double off = static_cast<double>(built.grid.height[cell]) - rolling(frame.x(column), frame.y(row));
            wrong += std::abs(off) > 0.03 ? 1U : 0U;
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("Ground that changed between two scans of a surface is disputed, not averaged") {
    const auto dug = [](double x, double y) {
        return rolling(x, y) - (x > 0.5 && x < 1.1 && y > 0.4 && y < 1.2 ? 0.06 : 0.0);
    };
    const BuiltSurface built = build({shoot("a", {}, rolling), shoot("b", {}, dug)}, two_metres());
    REQUIRE(built.disputed.size() == 1);
    const DisputedPatch& patch = built.disputed.front();
    CHECK(patch.area == Approx(0.48).epsilon(0.05));
    CHECK(patch.difference == Approx(0.06).margin(0.003));
    CHECK(patch.lower == "b");
    CHECK(patch.higher == "a");
    CHECK(patch.detectable >= 0.02);
    const std::size_t inside = built.grid.frame.at(40, 40);
    CHECK(built.grid.state[inside] == CellState::Disputed);
    const double z = static_cast<double>(built.grid.height[inside]);
    const double before = rolling(built.grid.frame.x(40), built.grid.frame.y(40));
    CHECK(std::min(std::abs(z - before), std::abs(z - before + 0.06)) < 0.01);
}

TEST_CASE("Scans that differ no more than their poses allow are not disputed") {
    SurfaceScan a = shoot("a", {}, rolling);
    SurfaceScan b = shoot("b", {}, [](double x, double y) { return rolling(x, y) + 0.05; });
    CHECK_FALSE(build({a, b}, two_metres()).disputed.empty());
    b.covariance(5, 5) = 0.03 * 0.03;
    CHECK(build({a, b}, two_metres()).disputed.empty());
}

TEST_CASE("The σ of a pose at a place is what thousands of disturbed poses show") {
    SurfaceScan scan;
    scan.station = {10.0, -4.0, 102.0};
    geometry::Matrix6 root = geometry::Matrix6::Zero();
    Shots random(12);
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k <= i; ++k) root(i, k) = (i < 3 ? 2e-4 : 2e-3) * random.normal();
    }
    scan.covariance = root * root.transpose();
    const Eigen::Vector3d x(13.0, 2.0, 100.5);
    const std::array<double, 2> gradient{0.4, -0.2};
    const geometry::Rigid3 pose{Eigen::Matrix3d::Identity(), scan.station};
    double sum = 0.0;
    constexpr int kRuns = 20000;
    for (int run = 0; run < kRuns; ++run) {
        geometry::Vector6 z;
        for (int i = 0; i < 6; ++i) z[i] = random.normal();
        const geometry::Vector6 step = root * z;
        const Eigen::Vector3d moved = geometry::moved(pose, step) * (pose.inverse() * x);
        // How far the plane through the moved point stands above x.
        const double lift = moved.z() - x.z() - gradient[0] * (moved.x() - x.x()) - gradient[1] * (moved.y() - x.y());
        sum += lift * lift;
    }
    CHECK(lift_of_pose(scan, x, gradient) == Approx(std::sqrt(sum / kRuns)).epsilon(0.03));
}

TEST_CASE("Frames of one cell size fall on each other; absurd ones are refused") {
    const GridFrame a = frame_around({-0.031, 0.0, 1.0, 1.0}, 0.02);
    CHECK(a.west == -2);
    CHECK(a.columns == 52);
    CHECK(a.rows == 50);
    CHECK_THROWS_AS(frame_around({0.0, 0.0, 0.0, 1.0}, 0.02), Error);
    CHECK_THROWS_AS(frame_around({0.0, 0.0, 1e6, 1e6}, 0.02), Error);
    CHECK_THROWS_AS(frame_around({0.0, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0}, 0.02), Error);
}
