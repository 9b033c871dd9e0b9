// SPDX-License-Identifier: MIT
#include "scans/surface/leaning_sides.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include "scans/surface/surface_builder.hpp"
#include "scans/surface/surface_difference.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::Shots;

namespace {

constexpr double kField = 2.0;
constexpr double kFloor = 0.5;

GridFrame frame() { return frame_around({-0.8, 0.0, 1.0, 1.0}, 0.02); }

SurfaceGrid built(const Shots& shots) {
    SurfaceScan scan = shots.scan("a");
    scan.station = {5.0, 0.5, 6.0};
    return build_surface(std::vector{scan}, frame(), {}, Progress::none()).grid;
}

SurfaceGrid field() {
    Shots shots(1);
    shots.add_ground({{-0.9, -0.1, 1.1, 1.1}, 25000.0, 0.002, 1}, [](double, double) { return kField; });
    return built(shots);
}

/// A trench east of a side whose head is at x = `edge`; `lean` metres farther out for each metre down. The side is seen
/// as far down as `lowest(y)`, the floor from 40 cm off the side on.
SurfaceGrid trench(double edge, double lean, const std::function<double(double)>& lowest) {
    Shots shots(2);
    shots.add_ground({{-0.9, -0.1, edge, 1.1}, 25000.0, 0.002, 1}, [](double, double) { return kField; });
    shots.add_ground({{edge + 0.4, -0.1, 1.1, 1.1}, 25000.0, 0.002, 1}, [](double, double) { return kFloor; });
    for (int i = 0; i < 30000; ++i) {
        const double y = shots.uniform(-0.1, 1.1);
        const double z = shots.uniform(kFloor, kField);
        if (z >= lowest(y)) shots.add(edge + lean * (kField - z) + 0.003 * shots.normal(), y, z);
    }
    return built(shots);
}

double dug(const SurfaceGrid& after) { return dug_volumes(field(), after, {}, 1)[0].net; }

} // namespace

TEST_CASE("A side that leans into a shadow goes on leaning to the floor") {
    constexpr double kLean = 0.05;
    const double deep = kField - kFloor;
    for (const double edge : {0.0, 0.004, 0.01, 0.013}) {
        const SurfaceGrid after = trench(edge, kLean, [](double) { return 1.4; });
        INFO(edge);
        CHECK(dug(after) == Approx(deep * (1.0 - edge - 0.5 * kLean * deep)).margin(0.008));
        const FilledHeights filled = fill_gaps(after);
        for (std::int32_t column = 0; column < frame().columns; ++column) {
            const double out = frame().x(column) - edge;
            if (out < 0.045 || out > 0.065) continue; // seen down to 3 cm out, to the floor 7.5 cm
            CHECK(static_cast<double>(filled.height[frame().at(25, column)]) ==
                  Approx(kField - out / kLean).margin(0.2));
        }
    }
}

TEST_CASE("An upright side stays upright wherever it lies in its cells, and however the shadow runs over it") {
    for (const double edge : {0.0, 0.004, 0.01, 0.013}) {
        const SurfaceGrid even = trench(edge, 0.0, [](double) { return 1.4; });
        const SurfaceGrid aslant = trench(edge, 0.0, [](double y) { return 1.8 - 0.9 * y; });
        INFO(edge);
        CHECK(dug(even) == Approx((kField - kFloor) * (1.0 - edge)).margin(0.008));
        CHECK(dug(aslant) == Approx((kField - kFloor) * (1.0 - edge)).margin(0.008));
    }
}
