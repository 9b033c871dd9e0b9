// SPDX-License-Identifier: MIT
#include "gui/render/scene_cut.hpp"

#include <random>

#include "tests/support/catch.hpp"

using namespace planum::gui;
using Eigen::Vector3d;

namespace {

bool is_inside(const SceneSlab& slab, const Vector3d& x) {
    for (const Eigen::Vector4d& plane : slab.planes()) {
        if (plane.head<3>().dot(x) + plane.w() < 0.0) return false;
    }
    return true;
}

} // namespace

TEST_CASE("A slab keeps what lies within half its thickness of its line, however high") {
    const SceneSlab slab = SceneSlab::along({1.0, 1.0, 0.0}, {4.0, 5.0, 7.0}, 0.2);
    CHECK(slab.is_cutting());
    CHECK(slab.normal.norm() == Approx(1.0));
    CHECK(slab.normal.z() == 0.0);
    const Vector3d across = Vector3d(-4.0, 3.0, 0.0) / 5.0;
    for (const double along : {-3.0, 0.0, 0.5, 9.0}) {
        const Vector3d on = Vector3d(1.0, 1.0, 12.0) + along * Vector3d(3.0, 4.0, 0.0);
        CHECK(is_inside(slab, on));
        CHECK(is_inside(slab, on + 0.09 * across));
        CHECK(is_inside(slab, on - 0.09 * across));
        CHECK_FALSE(is_inside(slab, on + 0.11 * across));
        CHECK_FALSE(is_inside(slab, on - 0.11 * across));
    }
    CHECK(SceneSlab{}.planes().empty());
    CHECK(is_inside(SceneSlab{}, {1e7, -1e7, 0.0}));
}

TEST_CASE("A slab on a national grid is as exact as one at the origin") {
    const Vector3d far(3'456'789.0, 5'678'901.0, 0.0);
    const SceneSlab slab = SceneSlab::along(far, far + Vector3d(1.0, 1.0, 0.0), 0.02);
    const Vector3d across = Vector3d(1.0, -1.0, 0.0).normalized();
    CHECK(is_inside(slab, far + 0.009 * across));
    CHECK_FALSE(is_inside(slab, far + 0.011 * across));
}

TEST_CASE("The part of a line of sight inside box and slab is where its points are inside both") {
    std::mt19937 random(7); // NOLINT: the same lines each time
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    const auto any = [&] { return Vector3d(place(random), place(random), place(random)); };
    int seen = 0;
    for (int round = 0; round < 400; ++round) {
        const SceneBox box{Vector3d(-1.0, -1.5, -1.0), Vector3d(1.0, 0.5, 2.0)};
        const SceneSlab slab = SceneSlab::along(any(), any(), 2.5);
        const Camera::Sight sight{any(), any().normalized()};
        const auto part = part_inside(sight, box, slab);
        seen += part ? 1 : 0;
        for (double t = 0.0; t < 9.0; t += 0.037) {
            const Vector3d x = sight.from + t * sight.direction;
            const bool inside =
                is_inside(slab, x) && (x.array() >= box.low.array()).all() && (x.array() <= box.high.array()).all();
            const bool said = part && t >= part->begins && t <= part->begins + part->length;
            CHECK(inside == said);
        }
        if (part) CHECK((part->sight.from - sight.from - part->begins * sight.direction).norm() < 1e-9);
    }
    CHECK(seen > 20);
}

TEST_CASE("Where nothing is cut away a line of sight is seen from the eye on") {
    const Camera::Sight sight{Vector3d(1.0, 2.0, 3.0), Vector3d::UnitY()};
    const auto part = part_inside(sight, {}, {});
    REQUIRE(part);
    CHECK(part->begins == 0.0);
    CHECK(part->length > 1e6);
    CHECK(part->sight.from == sight.from);
}
