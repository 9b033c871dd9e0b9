// SPDX-License-Identifier: MIT
#include "core/geometry/polygons.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using geometry::Line3;
using geometry::MultiPolygon;

namespace {

Line3 rectangle(double x0, double y0, double x1, double y1, double z = 10.0) {
    return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

std::string refusal(const MultiPolygon& shape) {
    try {
        (void)geometry::make_sound(shape);
    } catch (const Error& e) {
        CHECK(e.code() == ErrorCode::BadInput);
        return e.what();
    }
    return {};
}

} // namespace

TEST_CASE("A polygon with a hole knows its area and what lies inside") {
    const MultiPolygon shape = {{rectangle(0, 0, 4, 3), rectangle(1, 1, 2, 2)}, {rectangle(10, 0, 11, 1)}};
    CHECK(geometry::area(shape) == Approx(12.0));
    CHECK(geometry::contains(shape, 0.5, 0.5));
    CHECK_FALSE(geometry::contains(shape, 1.5, 1.5));
    CHECK(geometry::contains(shape, 10.5, 0.5));
    CHECK_FALSE(geometry::contains(shape, 5.0, 0.5));
    const auto spans = geometry::spans_at(shape, 1.5);
    REQUIRE(spans.size() == 2);
    CHECK(spans[0].second == Approx(1.0));
    CHECK(spans[1].first == Approx(2.0));
    CHECK(geometry::distance_to_outline(shape, 5.0, 1.0) == Approx(1.0));
}

TEST_CASE("A place on a shared line belongs to one of the two neighbours") {
    const MultiPolygon west = {{rectangle(0, 0, 1, 1)}};
    const MultiPolygon east = {{{{1, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}}}};
    for (const double y : {0.0, 0.25, 0.5, 0.999}) {
        CHECK((geometry::contains(west, 1.0, y) != geometry::contains(east, 1.0, y)));
    }
}

TEST_CASE("A sound outline is taken as it is") {
    const auto sound = geometry::make_sound({{rectangle(0, 0, 4, 3), rectangle(1, 1, 2, 2)}});
    CHECK(sound.repairs.empty());
    CHECK(geometry::area(sound.shape) == Approx(11.0));
    CHECK(geometry::signed_area(sound.shape[0][0]) > 0.0);
    CHECK(geometry::signed_area(sound.shape[0][1]) < 0.0);
    CHECK(sound.shape[0][0][0][2] == 10.0);
}

TEST_CASE("A bow tie is refused with the place where it crosses itself") {
    const std::string said = refusal({{{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}}}});
    CHECK(said.find("crosses itself at 2.00 2.00") != std::string::npos);
}

TEST_CASE("A line that overshoots its start makes a small loop, which is repaired and said") {
    // Closes 2 cm past the start: a loop of a few square centimetres.
    const MultiPolygon drawn = {{{{0, 0, 5}, {4, 0, 5}, {4, 3, 5}, {0, 3, 5}, {0.01, -0.02, 5}, {-0.02, 0.01, 5}}}};
    const auto sound = geometry::make_sound(drawn);
    REQUIRE(sound.repairs.size() == 1);
    CHECK(sound.repairs[0].find("crosses itself at 0.0") != std::string::npos);
    CHECK(geometry::area(sound.shape) == Approx(12.0).margin(0.04));
    for (const auto& rings : sound.shape) {
        for (const auto& point : rings[0]) CHECK(point[2] == Approx(5.0));
    }
}

TEST_CASE("An outline that touches itself falls into its parts, and parts that overlap are joined") {
    const auto touching = geometry::make_sound({{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}}});
    CHECK(touching.shape.size() == 2);
    CHECK(geometry::area(touching.shape) == Approx(2.0));
    const auto joined = geometry::make_sound({{rectangle(0, 0, 2, 1)}, {rectangle(1, 0, 3, 1)}});
    CHECK(joined.shape.size() == 1);
    CHECK(geometry::area(joined.shape) == Approx(3.0));
    CHECK(joined.repairs.size() == 1);
}

TEST_CASE("A hole that sticks out is cut at the outline") {
    const auto sound = geometry::make_sound({{rectangle(0, 0, 2, 2), rectangle(1, 0.5, 3, 1)}});
    CHECK(geometry::area(sound.shape) == Approx(3.5));
    CHECK(sound.repairs.size() == 1);
}

TEST_CASE("Outlines without area are refused in a sentence") {
    CHECK(refusal({}).find("fewer than three") != std::string::npos);
    CHECK(refusal({{{{0, 0, 0}, {1, 1, 0}}}}).find("fewer than three") != std::string::npos);
    CHECK(refusal({{{{0, 0, 0}, {1, 1, 0}, {0, 0, 0}}}}).find("no area") != std::string::npos);
    CHECK(refusal({{{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}}}).find("no area") != std::string::npos);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal({{{{0, 0, 0}, {1, nan, 0}, {2, 2, 0}}}}).find("no number") != std::string::npos);
}

TEST_CASE("Overlays keep heights and leave specks out") {
    const MultiPolygon a = {{rectangle(0, 0, 2, 2, 1.0)}};
    const MultiPolygon b = {{rectangle(1, -1, 3, 3, 7.0)}};
    const MultiPolygon left = geometry::difference(a, b);
    CHECK(geometry::area(left) == Approx(2.0));
    for (const auto& point : left[0][0]) CHECK((point[2] == Approx(1.0) || point[2] == Approx(7.0)));
    CHECK(geometry::area(geometry::intersection(a, b)) == Approx(2.0));
    CHECK(geometry::area(geometry::united(a, b)) == Approx(10.0));
    CHECK(geometry::intersection(a, {{rectangle(2, 0, 3, 3)}}).empty());
    CHECK(geometry::area(geometry::offset(a, -0.5)) == Approx(1.0));
    const auto inside = geometry::inner_place({{rectangle(0, 0, 4, 3), rectangle(1, 1, 3, 2)}});
    CHECK(geometry::contains({{rectangle(0, 0, 4, 3), rectangle(1, 1, 3, 2)}}, inside[0], inside[1]));
}
