// SPDX-License-Identifier: MIT
#include "core/geometry/fit_rigid.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/core.h>

#include "core/base/error.hpp"

namespace planum::geometry {

namespace {

using Points = std::span<const Eigen::Vector3d>;

struct Weights {
    std::span<const double> given;

    [[nodiscard]] double operator[](std::size_t i) const { return given.empty() ? 1.0 : given[i]; }
};

void refuse_bad_input(Points sources, Points targets, std::span<const double> weights) {
    if (sources.size() != targets.size() || (!weights.empty() && weights.size() != sources.size())) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("{} source points for {} target points", sources.size(), targets.size()));
    }
    std::size_t counting = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (!sources[i].allFinite() || !targets[i].allFinite()) {
            throw Error(ErrorCode::BadInput, fmt::format("point pair {} is not finite", i + 1));
        }
        const double weight = Weights{weights}[i];
        if (!(weight >= 0.0) || !std::isfinite(weight)) {
            throw Error(ErrorCode::BadInput, fmt::format("weight {} of point pair {}", weight, i + 1));
        }
        if (weight > 0.0) ++counting;
    }
    if (counting < 3) {
        throw Error(ErrorCode::BadInput, fmt::format("{} point pairs, a pose needs three", counting));
    }
}

Matrix6 covariance_of(Points sources, Weights weights, const RigidFit& fit) {
    // A line leaves the turn about itself open; rounding (its square root here) would hide that behind a
    // huge finite number.
    if (fit.spread[1] <= 1e-7 * fit.spread[0] || fit.spread[0] <= 0.0) {
        return Matrix6::Constant(std::numeric_limits<double>::infinity());
    }
    Matrix6 information = Matrix6::Zero();
    for (std::size_t i = 0; i < sources.size(); ++i) {
        Eigen::Matrix<double, 3, 6> j;
        j.leftCols<3>() = -cross_matrix(fit.target_from_source.rotation * sources[i]);
        j.rightCols<3>().setIdentity();
        information += weights[i] * j.transpose() * j;
    }
    return information.ldlt().solve(Matrix6::Identity());
}

} // namespace

RigidFit fit_rigid(Points x_in_source, Points x_in_target, std::span<const double> given_weights) {
    refuse_bad_input(x_in_source, x_in_target, given_weights);
    const Weights weights{given_weights};
    double total = 0.0;
    Eigen::Vector3d mean_source = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean_target = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < x_in_source.size(); ++i) {
        total += weights[i];
        mean_source += weights[i] * x_in_source[i];
        mean_target += weights[i] * x_in_target[i];
    }
    mean_source /= total;
    mean_target /= total;

    Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d within = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < x_in_source.size(); ++i) {
        const Eigen::Vector3d s = x_in_source[i] - mean_source;
        across += weights[i] * (x_in_target[i] - mean_target) * s.transpose();
        within += weights[i] * s * s.transpose();
    }
    RigidFit fit;
    fit.target_from_source.rotation = nearest_rotation(across);
    fit.target_from_source.translation = mean_target - fit.target_from_source.rotation * mean_source;

    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(within / total, Eigen::EigenvaluesOnly);
    fit.spread = principal.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
    double sum = 0.0;
    for (std::size_t i = 0; i < x_in_source.size(); ++i) {
        sum += weights[i] * (fit.target_from_source * x_in_source[i] - x_in_target[i]).squaredNorm();
    }
    fit.rms = std::sqrt(sum / total);
    fit.covariance = covariance_of(x_in_source, weights, fit);
    return fit;
}

} // namespace planum::geometry
