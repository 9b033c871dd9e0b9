// SPDX-License-Identifier: MIT
#include "core/geometry/pose_sigma.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace planum::geometry {

namespace {

double root_of_largest(const Eigen::Matrix3d& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

} // namespace

PoseSigma worst_sigma(const std::array<double, 36>& covariance) {
    const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> matrix(covariance.data());
    return {root_of_largest(matrix.bottomRightCorner<3, 3>()), root_of_largest(matrix.topLeftCorner<3, 3>())};
}

} // namespace planum::geometry
