// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <rapidcheck/catch.h>

#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "core/geometry/polygons.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using geometry::Line3;
using geometry::MultiPolygon;

namespace {

double between(double low, double high) {
    return low + (high - low) * static_cast<double>(*rc::gen::inRange(0, 100001)) / 100000.0;
}

// A star-shaped ring about a centre, from UTM-sized coordinates.
Line3 a_ring(double x, double y, double radius) {
    const int corners = *rc::gen::inRange(3, 24);
    Line3 ring;
    for (int i = 0; i < corners; ++i) {
        const double turn = 2.0 * std::numbers::pi * (i + between(0.0, 0.8)) / corners;
        const double r = radius * between(0.4, 1.0);
        ring.push_back({x + r * std::cos(turn), y + r * std::sin(turn), between(90.0, 95.0)});
    }
    return ring;
}

MultiPolygon a_shape() {
    const double x = 3456700.0 + between(0.0, 3.0);
    const double y = 5432100.0 + between(0.0, 3.0);
    MultiPolygon shape = {{a_ring(x, y, between(0.3, 3.0))}};
    return geometry::make_sound(shape).shape;
}

} // namespace

TEST_CASE("Inside by spans is inside by the even-odd rule, and areas of overlays add up") {
    rc::prop("spans and areas", [] {
        const MultiPolygon a = a_shape();
        const MultiPolygon b = a_shape();
        for (int i = 0; i < 20; ++i) {
            const double x = 3456700.0 + between(-3.0, 6.0);
            const double y = 5432100.0 + between(-3.0, 6.0);
            bool in_span = false;
            for (const auto& [from, to] : geometry::spans_at(a, y)) in_span = in_span || (from <= x && x < to);
            RC_ASSERT(in_span == geometry::contains(a, x, y));
        }
        const double slack = 5 * geometry::kLeastArea;
        const double both = geometry::area(geometry::intersection(a, b));
        RC_ASSERT(std::abs(geometry::area(geometry::difference(a, b)) + both - geometry::area(a)) < slack);
        RC_ASSERT(std::abs(geometry::area(geometry::united(a, b)) + both - geometry::area(a) - geometry::area(b)) <
                  slack);
        RC_ASSERT(geometry::area(geometry::intersection(geometry::difference(a, b), b)) < slack);
    });
}

TEST_CASE("Whatever is drawn is made sound or refused, and sound outlines stay as they are") {
    rc::prop("make_sound is idempotent", [] {
        const auto corners = *rc::gen::container<std::vector<std::pair<int, int>>>(
            rc::gen::pair(rc::gen::inRange(0, 8), rc::gen::inRange(0, 8)));
        Line3 ring;
        for (const auto& [x, y] : corners) ring.push_back({0.25 * x, 0.25 * y, 1.0});
        try {
            const auto once = geometry::make_sound({{ring}});
            const auto twice = geometry::make_sound(once.shape);
            RC_ASSERT(twice.repairs.empty());
            RC_ASSERT(std::abs(geometry::area(twice.shape) - geometry::area(once.shape)) < 1e-9);
            for (const auto& rings : once.shape) {
                for (const auto& line : rings) {
                    for (const auto& p : line) RC_ASSERT(std::abs(p[2] - 1.0) < 1e-9);
                }
            }
        } catch (const Error& e) {
            RC_ASSERT(e.code() == ErrorCode::BadInput);
        }
    });
}
