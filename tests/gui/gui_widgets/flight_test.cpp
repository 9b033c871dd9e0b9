// SPDX-License-Identifier: MIT
#include "gui/render/flight.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"

using namespace planum::gui;

namespace {

Camera at(double x, double yaw, double distance) {
    Camera camera;
    camera.target = {x, 0.0, 0.0};
    camera.yaw = yaw;
    camera.distance = distance;
    return camera;
}

} // namespace

TEST_CASE("A flight begins and ends where cameras were placed and passes each of them") {
    const auto way = flight_along({at(0.0, 0.0, 4.0), at(10.0, 0.5, 8.0), at(10.0, 1.0, 2.0)}, 20);
    REQUIRE(way.size() == 41);
    CHECK(way.front().target.x() == Approx(0.0));
    CHECK(way[20].target.x() == Approx(10.0));
    CHECK(way[20].distance == Approx(8.0));
    CHECK(way.back().yaw == Approx(1.0));
    CHECK(way.back().distance == Approx(2.0));
}

TEST_CASE("A flight turns the shorter way and comes nearer by equal factors") {
    const double almost = 2.0 * std::numbers::pi - 0.2;
    const auto way = flight_along({at(0.0, 0.1, 1.0), at(0.0, almost, 4.0)}, 10);
    REQUIRE(way.size() == 11);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) CHECK(std::abs(way[i].yaw) <= 0.2 + 1e-9);
    CHECK(way[5].distance == Approx(2.0)); // half way: the geometric middle
}

TEST_CASE("One camera is one frame, none is none") {
    CHECK(flight_along({}, 10).empty());
    CHECK(flight_along({at(1.0, 0.0, 3.0)}, 10).size() == 1);
}
