// SPDX-License-Identifier: MIT
#include "scans/surface/sight_lines.hpp"

#include <algorithm>
#include <cmath>

#include "scans/surface/gap_filling.hpp"
#include "scans/surface/surface_builder.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::Shots;

namespace {

const Eigen::Vector3d kStation(-1.0, 1.0, 3.0);
constexpr double kEdge = 1.0;  // east of it the floor
constexpr double kDepth = 0.6; // [m]

double step(double x, double /*y*/) { return x < kEdge ? 0.0 : -kDepth; }

/// The line of sight from the station over the upright edge.
double line_over_edge(double x, double y) {
    const double to_edge = (kEdge - kStation.x()) / (x - kStation.x()); // share of the way at which the edge is
    static_cast<void>(y);
    return kStation.z() - kStation.z() / to_edge;
}

GridFrame frame() { return frame_around({0.0, 0.0, 3.0, 2.0}, 0.02); }

/// What the station sees of the step; its upright side is turned away.
Shots seen_step() {
    Shots all(5);
    all.add_ground({{-0.1, -0.1, 3.1, 2.1}, 50000.0, 0.001, 0}, step);
    Shots seen(6);
    for (std::size_t i = 0; i < all.block().size(); ++i) {
        const double x = all.block().x[i];
        const double y = all.block().y[i];
        if (x < kEdge || -kDepth > line_over_edge(x, y)) seen.add(x, y, all.block().z[i]);
    }
    return seen;
}

SurfaceGrid grid_of(const Shots& shots, const Eigen::Vector3d& station = kStation) {
    SurfaceScan scan = shots.scan("a");
    scan.station = station;
    return build_surface(std::vector{scan}, frame(), {}, Progress::none()).grid;
}

bool is_unseen(const SurfaceGrid& grid, double x, double y) {
    const auto row = static_cast<std::int32_t>(y / 0.02);
    return grid.state[grid.frame.at(row, static_cast<std::int32_t>(x / 0.02))] == CellState::Unseen;
}

float at(const std::vector<float>& values, const GridFrame& frame, double x, double y) {
    return values[frame.at(static_cast<std::int32_t>(y / 0.02), static_cast<std::int32_t>(x / 0.02))];
}

} // namespace

TEST_CASE("Over what an edge hides stands the line of sight, and the floor is continued to the edge") {
    const SurfaceGrid grid = grid_of(seen_step());
    for (const double x : {1.05, 1.15, 1.25}) {
        for (const double y : {0.3, 1.0, 1.7}) {
            CAPTURE(x, y);
            REQUIRE(is_unseen(grid, x, y));
            CHECK(static_cast<double>(at(grid.ceiling, grid.frame, x, y)) ==
                  Approx(line_over_edge(x, y)).margin(0.04)); // cells are 2 cm, and a line falls 1.5 times that
        }
    }
    const FilledHeights filled = fill_gaps(grid);
    for (double x = 1.01; x < 1.4; x += 0.02)
        CHECK(static_cast<double>(at(filled.height, grid.frame, x, 1.0)) == Approx(-kDepth).margin(0.005));
    CHECK(at(filled.sigma, grid.frame, 1.05, 1.0) > at(filled.sigma, grid.frame, 1.35, 1.0));
}

TEST_CASE("Points that hang on the line of sight behind an edge are no ground") {
    Shots shots = seen_step();
    for (int i = 0; i < 80; ++i) {
        const double x = shots.uniform(1.03, 1.35);
        const double y = shots.uniform(0.2, 1.8);
        shots.add(x, y, line_over_edge(x, y) + 0.002 * shots.normal());
    }
    const SurfaceGrid grid = grid_of(shots);
    const FilledHeights filled = fill_gaps(grid);
    std::size_t hanging = 0;
    for (std::size_t cell = 0; cell < grid.frame.cells(); ++cell) {
        const double z = static_cast<double>(grid.height[cell]);
        hanging += z < -0.08 && z > -kDepth + 0.08 ? 1U : 0U;
    }
    CHECK(hanging == 0);
    double over = 0.0; // [m³]
    for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
        for (std::int32_t column = 0; column < grid.frame.columns; ++column) {
            const double z = step(grid.frame.x(column), grid.frame.y(row));
            if (std::abs(grid.frame.y(row) - 1.0) > 0.6) continue; // at the border nobody knows what lies behind
            over += (static_cast<double>(filled.height[grid.frame.at(row, column)]) - z) * 0.0004;
        }
    }
    CHECK(std::abs(over) < 0.1 * 0.4 * 1.2 * kDepth); // a tenth of what the shadow could hold; a membrane gives half
}

TEST_CASE("What hangs in the shadow of the scan that saw it hides neither floor nor side that another scan sees") {
    Shots west = seen_step();
    for (int i = 0; i < 80; ++i) {
        const double x = west.uniform(1.03, 1.35);
        const double y = west.uniform(0.2, 1.8);
        west.add(x, y, line_over_edge(x, y) + 0.002 * west.normal());
    }
    Shots east(7); // sees the floor and the side, with a point in every second cell
    east.add_ground({{kEdge, -0.1, 3.1, 2.1}, 1200.0, 0.001, 0}, step);
    for (int i = 0; i < 600; ++i) east.add(kEdge, east.uniform(-0.1, 2.1), east.uniform(-kDepth, 0.0));
    std::vector<SurfaceScan> scans = {west.scan("west"), east.scan("east")};
    scans[0].station = kStation;
    scans[1].station = {6.0, 1.0, 3.0};
    const BuiltSurface built = build_surface(scans, frame(), {}, Progress::none());
    CHECK(built.hanging > 40);

    const SurfaceGrid& grid = built.grid;
    // What surfaces prove is read from all that was seen: where something hangs over the floor, the floor proves
    // nothing.
    SurfaceGrid seen = grid;
    put_back(seen, built.as_seen);
    std::size_t over_floor = 0;
    for (std::size_t cell = 0; cell < grid.frame.cells(); ++cell)
        over_floor += grid.state[cell] == CellState::Surface && seen.state[cell] == CellState::Face ? 1U : 0U;
    CHECK(over_floor > 10);
    CHECK(cells_as_seen(seen, grid).size() == built.as_seen.size());
    CHECK(cells_as_seen(seen, seen).empty());
    const FilledHeights filled = fill_gaps(grid);
    std::size_t no_ground = 0;
    double over = 0.0; // [m³]
    for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
        for (std::int32_t column = 0; column < grid.frame.columns; ++column) {
            const double x = grid.frame.x(column);
            if (std::abs(grid.frame.y(row) - 1.0) > 0.6) continue;
            const std::size_t cell = grid.frame.at(row, column);
            if (x > kEdge + 0.04 && grid.state[cell] != CellState::Unseen)
                no_ground += std::abs(static_cast<double>(grid.height[cell]) + kDepth) > 0.02 ? 1U : 0U;
            over += (static_cast<double>(filled.height[cell]) - step(x, grid.frame.y(row))) * 0.0004;
        }
    }
    CHECK(no_ground <= 2);                        // of 1,080
    CHECK(std::abs(over) < 0.005 * 1.2 * kDepth); // as an edge 5 mm off gives, a quarter of a cell
}

TEST_CASE("Ground that one scan alone sees at the end of its shadow stays ground") {
    Shots shots = seen_step();
    for (double y = 0.25; y < 1.8; y += 0.25) shots.add(1.38, y, -kDepth); // a little before the shadow ends
    const SurfaceGrid grid = grid_of(shots);
    for (double y = 0.25; y < 1.8; y += 0.25) CHECK_FALSE(is_unseen(grid, 1.381, y + 0.001));
}

TEST_CASE("Gaps between points on even ground, and clouds of no one station, give no lines of sight") {
    Shots sparse(8);
    sparse.add_ground({{-0.1, -0.1, 3.1, 2.1}, 900.0, 0.002, 0}, [](double x, double) { return 0.1 * x; });
    const SurfaceGrid even = grid_of(sparse);
    REQUIRE(std::count(even.state.begin(), even.state.end(), CellState::Unseen) > 1000);
    CHECK(std::all_of(even.ceiling.begin(), even.ceiling.end(), [](float z) { return std::isnan(z); }));

    Shots flown(9); // all of the floor is seen from above, but the cloud says it stands low beside the step
    flown.add_ground({{-0.1, -0.1, 3.1, 2.1}, 900.0, 0.002, 0}, step);
    const SurfaceGrid none = grid_of(flown, {-1.0, 1.0, 0.2});
    CHECK(std::all_of(none.ceiling.begin(), none.ceiling.end(), [](float z) { return std::isnan(z); }));
}

TEST_CASE("A point alone over the middle of a wide gap is no ground, however far the floor around it") {
    constexpr double kBlind = 1.1; // a scanner sees nothing of a floor right below it [m]
    constexpr double kFloor = -1.2;
    Shots all(11);
    all.add_ground({{-0.1, -0.1, 3.1, 3.1}, 10000.0, 0.001, 0}, [](double, double) { return kFloor; });
    Shots shots(12);
    for (std::size_t i = 0; i < all.block().size(); ++i) {
        const double x = all.block().x[i];
        const double y = all.block().y[i];
        if (std::hypot(x - 1.5, y - 1.5) > kBlind) shots.add(x, y, all.block().z[i]);
    }
    const std::vector<SurfaceScan> scans{shots.scan("a")};
    const SurfaceGrid floor = build_surface(scans, frame_around({0.0, 0.0, 3.0, 3.0}, 0.02), {}, Progress::none()).grid;
    const auto filled_with_point_at = [&](double height) { // what is left of several that hung there
        SurfaceGrid grid = floor;
        const std::size_t middle = grid.frame.at(75, 75);
        grid.state[middle] = CellState::Surface;
        grid.height[middle] = static_cast<float>(height);
        grid.count[middle] = 1;
        return fill_gaps(grid);
    };
    const FilledHeights under_stray = filled_with_point_at(0.0);
    for (const double x : {0.9, 1.2, 1.51, 1.8, 2.1})
        CHECK(static_cast<double>(at(under_stray.height, under_stray.frame, x, 1.51)) == Approx(kFloor).margin(0.01));

    // Ground can rise by so much on the way there.
    const FilledHeights risen = filled_with_point_at(kFloor + 0.3);
    CHECK(static_cast<double>(at(risen.height, risen.frame, 1.51, 1.51)) == Approx(kFloor + 0.3).margin(0.01));
}
