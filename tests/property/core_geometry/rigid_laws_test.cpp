// SPDX-License-Identifier: MIT
#include "core/geometry/fit_rigid.hpp"
#include "core/geometry/rigid.hpp"

#include <numbers>
#include <vector>

#include <rapidcheck.h>

#include "tests/support/catch.hpp"

using namespace planum::geometry;
using Eigen::Vector3d;

namespace {

double number(double limit) { return limit * (*rc::gen::inRange(-1000000, 1000001)) / 1e6; }

Vector3d some_point(double limit) { return {number(limit), number(limit), number(limit)}; }

Vector3d some_turn(double limit) {
    Vector3d axis = some_point(1.0);
    if (axis.norm() < 1e-3) axis = Vector3d::UnitZ();
    return axis.normalized() * number(limit);
}

Rigid3 some_motion() { return {exp_rotation(some_turn(std::numbers::pi)), some_point(100.0)}; }

double apart(const Rigid3& a, const Rigid3& b) {
    return (a.rotation - b.rotation).norm() + (a.translation - b.translation).norm();
}

} // namespace

TEST_CASE("Motions form a group: inverse, identity and associativity") {
    CHECK(rc::check([] {
        const Rigid3 a = some_motion();
        const Rigid3 b = some_motion();
        const Rigid3 c = some_motion();
        RC_ASSERT(apart(a * a.inverse(), Rigid3{}) < 1e-12);
        RC_ASSERT(apart(a.inverse() * a, Rigid3{}) < 1e-12);
        RC_ASSERT(apart((a * b) * c, a * (b * c)) < 1e-11);
        const Vector3d x = some_point(50.0);
        RC_ASSERT(((a * b) * x - a * (b * x)).norm() < 1e-11);
    }));
}

TEST_CASE("exp and log undo each other, tiny turns and turns near π too") {
    CHECK(rc::check([] {
        const double limit = *rc::gen::element(1e-12, 1e-6, 1e-3, 1.0, std::numbers::pi - 1e-6);
        Vector6 twist;
        twist << some_turn(limit), some_point(10.0);
        const Rigid3 motion = exp_rigid(twist);
        RC_ASSERT((motion.rotation * motion.rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
        RC_ASSERT((log_rigid(motion) - twist).norm() < 1e-8);
        RC_ASSERT(apart(exp_rigid(log_rigid(motion)), motion) < 1e-9);
        RC_ASSERT((log_rotation(exp_rotation(twist.head<3>())) - twist.head<3>()).norm() < 1e-8);
    }));
}

TEST_CASE("exp goes along one screw: half the way twice is the whole way") {
    CHECK(rc::check([] {
        Vector6 twist;
        twist << some_turn(3.0), some_point(10.0);
        RC_ASSERT(apart(exp_rigid(0.5 * twist) * exp_rigid(0.5 * twist), exp_rigid(twist)) < 1e-12);
    }));
}

TEST_CASE("The adjoint carries a twist through a motion") {
    CHECK(rc::check([] {
        const Rigid3 motion{exp_rotation(some_turn(3.0)), some_point(10.0)};
        Vector6 twist;
        twist << some_turn(1.0), some_point(1.0);
        RC_ASSERT(apart(motion * exp_rigid(twist), exp_rigid(adjoint(motion) * twist) * motion) < 1e-11);
    }));
}

TEST_CASE("A step leads from one pose to the other, far from the origin as well") {
    CHECK(rc::check([] {
        Rigid3 from = some_motion();
        from.translation += Vector3d(5e5, 5.7e6, 300.0);
        Vector6 step;
        step << some_turn(1.0), some_point(1.0);
        RC_ASSERT((step_between(from, moved(from, step)) - step).norm() < 1e-8);
    }));
}

TEST_CASE("Derivatives of products and inverses agree with differences") {
    CHECK(rc::check([] {
        const Rigid3 a{exp_rotation(some_turn(3.0)), some_point(10.0)};
        const Rigid3 b{exp_rotation(some_turn(3.0)), some_point(10.0)};
        Vector6 step;
        step << some_turn(1e-6), some_point(1e-6);
        const Vector6 by_first = step_between(a * b, moved(a, step) * b);
        RC_ASSERT((by_first - product_by_first(a, b) * step).norm() < 1e-9);
        const Vector6 by_second = step_between(a * b, a * moved(b, step));
        RC_ASSERT((by_second - product_by_second(a) * step).norm() < 1e-9);
        const Vector6 inverse = step_between(a.inverse(), moved(a, step).inverse());
        const Matrix6 outer = step * step.transpose();
        RC_ASSERT((covariance_of_inverse(a, outer) - inverse * inverse.transpose()).norm() <
                  1e-3 * outer.norm() + 1e-16);
    }));
}

TEST_CASE("Stored poses come back") {
    CHECK(rc::check([] {
        const Rigid3 motion = some_motion();
        RC_ASSERT(apart(from_row_major(to_row_major(motion)), motion) < 1e-12);
    }));
}

TEST_CASE("fit_rigid finds the motion, its swap finds the inverse, weights of zero do not count") {
    CHECK(rc::check([] {
        const Rigid3 truth{exp_rotation(some_turn(std::numbers::pi)), some_point(20.0)};
        std::vector<Vector3d> source{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}; // never on a line
        const int more = *rc::gen::inRange(0, 6);
        for (int i = 0; i < more; ++i) source.push_back(some_point(10.0));
        std::vector<Vector3d> target;
        for (const auto& x : source) target.push_back(truth * x);
        std::vector<double> weights(source.size(), 2.0);
        source.push_back({1.0, 1.0, 1.0});
        target.push_back({7.0, 7.0, 7.0});
        weights.push_back(0.0);
        const RigidFit fit = fit_rigid(source, target, weights);
        RC_ASSERT(apart(fit.target_from_source, truth) < 1e-9);
        RC_ASSERT(fit.rms < 1e-9);
        RC_ASSERT(fit.is_determined());
        RC_ASSERT(apart(fit_rigid(target, source, weights).target_from_source, truth.inverse()) < 1e-8);
    }));
}
