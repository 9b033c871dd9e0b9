// SPDX-License-Identifier: MIT
#include "scans/formats/rigid_pose.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/base/error.hpp"

namespace planum::scans {

SplitPose split_pose(const Eigen::Matrix4d& site_from_file) {
    if (!site_from_file.allFinite()) throw Error(ErrorCode::BadInput, "the matrix holds numbers that are not finite");
    const Eigen::RowVector4d last = site_from_file.row(3);
    if ((last - Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)).cwiseAbs().maxCoeff() > 1e-6) {
        throw Error(ErrorCode::BadInput, "the matrix is no motion in space: its last column must be 0 0 0 1");
    }
    const Eigen::Matrix3d linear = site_from_file.topLeftCorner<3, 3>();
    // linear = rotation * stretch, with stretch² = linearᵀ linear.
    const Eigen::Matrix3d squared = linear.transpose() * linear;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squared);
    const Eigen::Vector3d factors = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    if (!(factors.minCoeff() > 1e-6 && factors.maxCoeff() < 1e6)) {
        throw Error(ErrorCode::BadInput, "the matrix flattens or blows up space, it cannot be a pose");
    }
    const Eigen::Matrix3d axes = solver.eigenvectors();
    const Eigen::Matrix3d stretch = axes * factors.asDiagonal() * axes.transpose();
    const Eigen::Matrix3d rotation = linear * axes * factors.cwiseInverse().asDiagonal() * axes.transpose();
    if (linear.determinant() < 0.0) {
        throw Error(ErrorCode::BadInput, "the matrix mirrors space, it cannot be a pose");
    }
    SplitPose split;
    split.site_from_scan.linear() = rotation;
    split.site_from_scan.translation() = site_from_file.topRightCorner<3, 1>();
    if ((factors.array() - 1.0).abs().maxCoeff() > 1e-4) split.scan_from_file = stretch;
    return split;
}

Eigen::Isometry3d pose_from_quaternion(double w, double x, double y, double z, const Eigen::Vector3d& translation) {
    const Eigen::Quaterniond rotation(w, x, y, z);
    const double length = rotation.norm();
    if (!std::isfinite(length) || !translation.allFinite()) {
        throw Error(ErrorCode::BadInput, "the pose holds numbers that are not finite");
    }
    if (length < 1e-12) throw Error(ErrorCode::BadInput, "the pose's quaternion is zero, it must have length 1");
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation.normalized().toRotationMatrix();
    pose.translation() = translation;
    return pose;
}

} // namespace planum::scans
