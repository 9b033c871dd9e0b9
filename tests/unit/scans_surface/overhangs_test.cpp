// SPDX-License-Identifier: MIT
#include "scans/surface/overhangs.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "scans/surface/surface_builder.hpp"
#include "scans/surface/surface_difference.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_surface/simulated_ground.hpp"

using namespace planum;
using namespace planum::scans;
using planum::test::Shots;

namespace {

constexpr double kGround = 1.0;
constexpr double kFloor = 0.1;
constexpr double kMouth = 0.3; // radius [m]
constexpr double kMiddle = 1.0;

using Radius = std::function<double(double z)>;

GridFrame frame() { return frame_around({0.0, 0.0, 2.0, 2.0}, 0.02); }

SurfaceGrid built(const Shots& shots) {
    SurfaceScan scan = shots.scan("a");
    scan.station = {1.0, 1.0, 9.0};
    return build_surface(std::vector{scan}, frame(), {}, Progress::none()).grid;
}

/// Even ground with a round pit, of whose side scanners at the rim see the upper half meter all around, and of the
/// floor nothing.
SurfaceGrid ground_with_pit(const Radius& radius, double middle = kMiddle, double seen = 0.5) {
    Shots shots(3);
    for (int i = 0; i < 100000; ++i) {
        const double x = shots.uniform(-0.1, 2.1);
        const double y = shots.uniform(-0.1, 2.1);
        if (std::hypot(x - middle, y - kMiddle) > kMouth) shots.add(x, y, kGround + 0.002 * shots.normal());
    }
    for (int i = 0; i < 30000; ++i) {
        const double angle = shots.uniform(0.0, 2.0 * std::numbers::pi);
        const double z = shots.uniform(kGround - seen, kGround);
        shots.add(middle + radius(z) * std::cos(angle), kMiddle + radius(z) * std::sin(angle), z);
    }
    return built(shots);
}

std::vector<SpotHeight> floor_spot(double radius = kMouth, double middle = kMiddle) {
    geometry::Line3 ring;
    for (int i = 0; i < 60; ++i) {
        const double angle = i * std::numbers::pi / 30.0;
        ring.push_back({middle + radius * std::cos(angle), kMiddle + radius * std::sin(angle), 0.0});
    }
    return {{middle, kMiddle, kFloor, 0.02, {{ring}}}};
}

double bell(double z) { return kMouth + 0.25 * (kGround - z); }

/// Of a body of revolution between floor and ground, less the cylinder over the mouth.
double under_overhang(const Radius& radius) {
    double volume = 0.0;
    for (double z = kFloor + 0.0005; z < kGround; z += 0.001)
        volume += 0.001 * std::numbers::pi * (radius(z) * radius(z) - kMouth * kMouth);
    return volume;
}

} // namespace

TEST_CASE("What lies under the overhang of a pit that widens downwards is told from how its side begins") {
    const std::vector<Overhang> found = find_overhangs(ground_with_pit(bell), floor_spot());
    REQUIRE(found.size() == 1);
    CHECK(found[0].widening == Approx(0.25).margin(0.05));
    CHECK(found[0].depth == Approx(kGround - kFloor).margin(0.01));
    CHECK(found[0].volume == Approx(under_overhang(bell)).epsilon(0.2));
}

TEST_CASE("Pits whose sides stand upright or slope have no overhang, drawn 3 cm too far in or out") {
    for (const double slope : {0.0, -0.2, -0.4}) {
        for (const double seen : {0.3, 0.35, 0.5}) {
            const SurfaceGrid grid =
                ground_with_pit([slope](double z) { return kMouth + slope * (kGround - z); }, kMiddle, seen);
            for (const double off : {-0.03, 0.0, 0.03}) {
                INFO(slope << ' ' << seen << ' ' << off);
                CHECK(find_overhangs(grid, floor_spot(kMouth + off)).empty());
            }
        }
    }
}

TEST_CASE("The side of a neighbouring pit is no overhang") {
    // Two pits 5 cm apart: of the other one the near side is seen from within.
    Shots shots(4);
    const auto in = [](double x, double y, double middle) { return std::hypot(x - middle, y - kMiddle) < kMouth; };
    for (int i = 0; i < 100000; ++i) {
        const double x = shots.uniform(-0.1, 2.1);
        const double y = shots.uniform(-0.1, 2.1);
        if (!in(x, y, kMiddle) && !in(x, y, kMiddle + 0.65)) shots.add(x, y, kGround + 0.002 * shots.normal());
    }
    for (int i = 0; i < 30000; ++i) {
        const double angle = shots.uniform(0.0, 2.0 * std::numbers::pi);
        shots.add(kMiddle + 0.65 + kMouth * std::cos(angle), kMiddle + kMouth * std::sin(angle),
                  shots.uniform(kFloor, kGround));
    }
    const SurfaceGrid grid = built(shots);
    std::vector<SpotHeight> spots = floor_spot();
    SpotHeight other = spots.front();
    spots.front().z = 0.3;
    other.x += 0.65;
    for (auto& point : other.hollow.front().front()) point[0] += 0.65;
    spots.push_back(other);
    CHECK(find_overhangs(grid, spots).empty());
}

TEST_CASE("A pit that widens downwards counts with what lies under its overhang, within the bound") {
    Shots shots(5);
    shots.add_ground({{-0.1, -0.1, 2.1, 2.1}, 25000.0, 0.002, 1}, [](double, double) { return kGround; });
    VolumeOptions options;
    options.known_after.spots = floor_spot();
    const DugVolume volume = dug_volumes(built(shots), ground_with_pit(bell), {}, 1, options)[0];
    const double mouth = std::numbers::pi * kMouth * kMouth * (kGround - kFloor);
    const double dug = mouth + under_overhang(bell);
    CHECK(volume.overhung == Approx(under_overhang(bell)).epsilon(0.2));
    CHECK(std::abs(volume.net - dug) < volume.bound());
    CHECK(volume.net == Approx(dug).epsilon(0.1)); // without it a third is missing
    CHECK(volume.bound() < 0.5 * dug);
}

TEST_CASE("The line of a section through a pit has no overhang") {
    const SurfaceGrid grid = ground_with_pit(bell);
    const auto half = [](double side) {
        SpotHeight spot = floor_spot().front();
        geometry::Line3 ring;
        for (int i = 0; i <= 60; ++i) {
            const double angle = i * std::numbers::pi / 60.0;
            ring.push_back({kMiddle + kMouth * std::cos(angle), kMiddle + side * kMouth * std::sin(angle), 0.0});
        }
        spot.y += 0.1 * side;
        spot.hollow = {{ring}};
        return spot;
    };
    const std::vector<SpotHeight> spots = {half(1.0), half(-1.0)};
    double volume = 0.0;
    for (const Overhang& found : find_overhangs(grid, spots)) volume += found.volume;
    CHECK(volume == Approx(find_overhangs(grid, floor_spot())[0].volume).epsilon(0.15)); // each by itself: 1.6 times
}

TEST_CASE("What comes to light under one overhang takes nothing from the bound of another that goes") {
    VolumeOptions options;
    options.known_before.spots = floor_spot(kMouth, 0.55);
    options.known_after.spots = floor_spot(kMouth, 1.45);
    options.undug.reset();
    const DugVolume volume = dug_volumes(ground_with_pit(bell, 0.55), ground_with_pit(bell, 1.45), {}, 1, options)[0];
    const double under = under_overhang(bell);
    CHECK(volume.overhung == Approx(0.0).margin(0.1 * under));
    CHECK(volume.sigma > 0.8 * options.overhang_doubt * std::sqrt(2.0) * under);
}
