// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Geometry>

namespace planum::scans {

/// A header's 4×4 matrix taken apart: x_in_site = site_from_scan * (scan_from_file * x_in_file).
struct SplitPose {
    Eigen::Isometry3d site_from_scan = Eigen::Isometry3d::Identity();
    /// Symmetric stretch that is left when the matrix is no rigid motion (some programs write scales).
    std::optional<Eigen::Matrix3d> scan_from_file;
};

/// Polar decomposition of the upper 3×3 part; a deviation from a rotation under 1e-4, as rounding in
/// text files makes it, is dropped. Throws BadInput when the matrix mirrors, is singular, holds no
/// finite numbers, or its last row is not 0 0 0 1.
[[nodiscard]] SplitPose split_pose(const Eigen::Matrix4d& site_from_file);

/// From a quaternion of any length and a translation [m]. Throws BadInput for zero length and for what
/// is not finite.
[[nodiscard]] Eigen::Isometry3d pose_from_quaternion(double w, double x, double y, double z,
                                                     const Eigen::Vector3d& translation);

} // namespace planum::scans
