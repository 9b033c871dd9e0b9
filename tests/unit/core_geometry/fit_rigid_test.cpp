// SPDX-License-Identifier: MIT
#include "core/geometry/fit_rigid.hpp"

#include <limits>
#include <random>
#include <vector>

#include <Eigen/LU>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::geometry;
using Eigen::Vector3d;

namespace {

const std::vector<Vector3d> kPegs{{4, 1, 0.2}, {-3, 5, 1.0}, {-6, -4, 0.1}, {2, -7, 1.6}, {7, 6, 0.7}};

} // namespace

TEST_CASE("A mirror image is answered by a rotation, not by a reflection") {
    std::vector<Vector3d> mirrored;
    for (const auto& x : kPegs) mirrored.push_back({x.x(), x.y(), -x.z()});
    const RigidFit fit = fit_rigid(kPegs, mirrored);
    CHECK(fit.target_from_source.rotation.determinant() == Approx(1.0));
    CHECK(fit.rms > 0.1);
}

TEST_CASE("Coplanar points that lie mirrored in their plane fit by turning the plane over") {
    const std::vector<Vector3d> flat{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {5, 5, 0}};
    std::vector<Vector3d> mirrored;
    for (const auto& x : flat) mirrored.push_back({-x.x(), x.y(), 0.0});
    const RigidFit fit = fit_rigid(flat, mirrored);
    CHECK(fit.rms < 1e-12);
    CHECK(fit.target_from_source.rotation.determinant() == Approx(1.0));
}

TEST_CASE("Points on a line leave the pose undetermined") {
    const std::vector<Vector3d> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}};
    CHECK_FALSE(fit_rigid(line, line).is_determined());
    const std::vector<Vector3d> same{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
    CHECK_FALSE(fit_rigid(same, same).is_determined());
}

TEST_CASE("The covariance of a fit is what repeating it with noise shows") {
    constexpr double kSigma = 0.002;
    constexpr int kRuns = 2000;
    std::mt19937_64 random(20);
    std::normal_distribution<double> noise(0.0, kSigma);
    const Rigid3 truth{exp_rotation({0.1, -0.2, 1.9}), {100.0, 200.0, 5.0}};
    const std::vector<double> weights(kPegs.size(), 1.0 / (kSigma * kSigma));
    Matrix6 scatter = Matrix6::Zero();
    Matrix6 stated = Matrix6::Zero();
    for (int run = 0; run < kRuns; ++run) {
        std::vector<Vector3d> target;
        for (const auto& x : kPegs) target.push_back(truth * x + Vector3d(noise(random), noise(random), noise(random)));
        const RigidFit fit = fit_rigid(kPegs, target, weights);
        const Vector6 error = step_between(truth, fit.target_from_source);
        scatter += error * error.transpose() / kRuns;
        stated = fit.covariance;
    }
    // A variance from 2,000 runs is good to 3 %; five times that.
    for (int i = 0; i < 6; ++i) CHECK(scatter(i, i) == Approx(stated(i, i)).epsilon(0.16));
}

TEST_CASE("fit_rigid refuses what it cannot judge") {
    const std::span<const Vector3d> two(kPegs.data(), 2);
    CHECK_THROWS_AS(fit_rigid(two, two), Error);
    CHECK_THROWS_AS(fit_rigid(kPegs, two), Error);
    const std::vector<double> negative(kPegs.size(), -1.0);
    CHECK_THROWS_AS(fit_rigid(kPegs, kPegs, negative), Error);
    auto broken = kPegs;
    broken[2].y() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(fit_rigid(kPegs, broken), Error);
}

TEST_CASE("Matrices that are no poses are refused with the reason") {
    auto matrix = to_row_major(Rigid3{});
    matrix[0] = -1.0;
    CHECK_THROWS_WITH(from_row_major(matrix), Catch::Contains("mirror image"));
    matrix[0] = 1.1;
    CHECK_THROWS_WITH(from_row_major(matrix), Catch::Contains("not rigid"));
    matrix[0] = 1.0;
    matrix[12] = 4.0;
    CHECK_THROWS_WITH(from_row_major(matrix), Catch::Contains("last row"));
    matrix[12] = 0.0;
    matrix[3] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(from_row_major(matrix), Catch::Contains("not finite"));
}
