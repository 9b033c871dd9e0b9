// SPDX-License-Identifier: MIT
#include "scans/surface/altered_ground.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include "core/base/error.hpp"
#include "scans/surface/label_grid.hpp"
#include "scans/surface/surface_builder.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;

namespace {

const GridFrame kFrame = frame_around({0.0, 0.0, 2.0, 2.0}, 0.02);

SurfaceGrid seen(const test::Ground& ground, std::uint32_t seed) {
    test::GroundShot shot;
    shot.seed = seed;
    test::Shots shots(seed);
    shots.add_ground(shot, ground);
    return build_surface(std::vector{shots.scan("s")}, kFrame, {}, Progress::none()).grid;
}

double flat(double /*x*/, double /*y*/) { return 10.0; }

// Region 0 in the west, 1 in the east, none north of 1.8.
std::vector<std::int32_t> halves() {
    std::vector<std::int32_t> region(kFrame.cells(), kNoRegion);
    for (std::int32_t row = 0; row < 90; ++row) {
        for (std::int32_t column = 0; column < kFrame.columns; ++column)
            region[kFrame.at(row, column)] = column < kFrame.columns / 2 ? 0 : 1;
    }
    return region;
}

} // namespace

TEST_CASE("A heap is found with its area, height and the regions it lies on") {
    const auto heap = [](double x, double y) { return x > 0.6 && x < 1.2 && y > 0.5 && y < 1.0 ? 10.12 : 10.0; };
    const auto found = risen_ground(seen(flat, 1), seen(heap, 2), halves(), {});
    REQUIRE(found.size() == 1);
    CHECK(found[0].area == Approx(0.3).epsilon(0.1));
    CHECK(found[0].change == Approx(0.12).margin(0.003));
    CHECK(found[0].low == Approx(10.12).margin(0.01));
    CHECK(found[0].regions.at(0) == Approx(2.0 * found[0].regions.at(1)).epsilon(0.1));
    CHECK((found[0].x > 0.6 && found[0].x < 1.2 && found[0].y > 0.5 && found[0].y < 1.0));
}

TEST_CASE("Ground that rose too little, over too little, or outside outlines is passed over") {
    const auto raised = [&](double west, double east, double south, double north, double by) {
        return risen_ground(seen(flat, 3),
                            seen(
                                [=](double x, double y) {
                                    const bool inside = x > west && x < east && y > south && y < north;
                                    return inside ? 10.0 + by : 10.0;
                                },
                                4),
                            halves(), {});
    };
    CHECK_FALSE(raised(0.2, 1.8, 0.2, 1.6, 0.06).empty());
    CHECK(raised(0.2, 1.8, 0.2, 1.6, 0.03).empty());  // within twice the tolerance
    CHECK(raised(0.2, 1.8, 0.2, 1.6, -0.2).empty());  // went down
    CHECK(raised(0.2, 0.45, 0.2, 0.45, 0.2).empty()); // 0.06 m²
    CHECK(raised(0.1, 1.9, 1.0, 1.03, 0.2).empty());  // a line
    CHECK(raised(0.0, 2.0, 1.82, 2.0, 0.2).empty());  // nobody drew it
}

TEST_CASE("Poses that are not sure hide a rise") {
    SurfaceGrid after = seen([](double, double) { return 10.06; }, 6);
    CHECK_FALSE(risen_ground(seen(flat, 5), after, halves(), {}).empty());
    for (float& sigma : after.pose_sigma) sigma = 0.05F;
    CHECK(risen_ground(seen(flat, 5), after, halves(), {}).empty());
}

TEST_CASE("The part of a patch inside outlines is measured, and surfaces on other cells are refused") {
    const SurfaceGrid grid = seen(flat, 7);
    const std::vector<std::size_t> cells{kFrame.at(10, 10), kFrame.at(10, 90), kFrame.at(95, 10)};
    const AlteredPatch inside = patch_inside(grid, cells, halves());
    CHECK(inside.area == Approx(2.0 * 0.0004));
    CHECK(inside.regions.size() == 2);
    CHECK(patch_inside(grid, std::vector{kFrame.at(95, 10)}, halves()).area == 0.0);
    SurfaceGrid other = grid;
    ++other.frame.west;
    CHECK_THROWS_AS(risen_ground(grid, other, halves(), {}), Error);
}
