// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <Eigen/Core>

namespace planum::geometry {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A rigid motion, read as `target_from_source`: `x_in_target = target_from_source * x_in_source`, and
/// frames cancel from left to right. Invariant kept by every function here: rotation is orthonormal with
/// determinant +1 to rounding.
///
/// Everything with six numbers has the rotation [rad] first and the translation [m] second.
struct Rigid3 {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero(); ///< [m], in target

    [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& x_in_source) const {
        return rotation * x_in_source + translation;
    }

    [[nodiscard]] Rigid3 operator*(const Rigid3& source_from_other) const {
        return {rotation * source_from_other.rotation, rotation * source_from_other.translation + translation};
    }

    [[nodiscard]] Rigid3 inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }

    friend bool operator==(const Rigid3&, const Rigid3&) = default;
};

/// The matrix that makes a cross product: `cross_matrix(a) * b == a.cross(b)`.
[[nodiscard]] Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a);

/// Rotation about the axis `turn` by its length [rad] (Rodrigues).
[[nodiscard]] Eigen::Matrix3d exp_rotation(const Eigen::Vector3d& turn);

/// Inverse of exp_rotation with a length of at most π; exact to rounding for tiny turns and near π.
[[nodiscard]] Eigen::Vector3d log_rotation(const Eigen::Matrix3d& rotation);

/// The motion along a constant twist (rotation, translation) for unit time: exp of SE(3).
[[nodiscard]] Rigid3 exp_rigid(const Vector6& twist);

/// Inverse of exp_rigid for rotations under π.
[[nodiscard]] Vector6 log_rigid(const Rigid3& motion);

/// `motion * exp_rigid(x) == exp_rigid(adjoint(motion) * x) * motion`.
[[nodiscard]] Matrix6 adjoint(const Rigid3& motion);

/// The pose turned by step.head<3>() about its own origin and shifted by step.tail<3>(), both along the
/// axes of the target frame. Steps of the solvers and all pose covariances are written in these six
/// numbers: a turn about the target's origin instead would, with site coordinates of millions of
/// metres, drown the position in the rotation.
[[nodiscard]] Rigid3 moved(const Rigid3& target_from_source, const Vector6& step);

/// The step with `moved(from, step) == to`.
[[nodiscard]] Vector6 step_between(const Rigid3& from, const Rigid3& to);

/// Covariance of the inverse pose, given that of the pose, both in the numbers of moved(); first order.
[[nodiscard]] Matrix6 covariance_of_inverse(const Rigid3& target_from_source, const Matrix6& covariance);

/// Derivative of the step of a product to the step of its first and of its second factor.
[[nodiscard]] Matrix6 product_by_first(const Rigid3& first, const Rigid3& second);
[[nodiscard]] Matrix6 product_by_second(const Rigid3& first);

/// Angle of the rotation [rad], 0…π.
[[nodiscard]] double rotation_angle(const Rigid3& motion);

/// Row-major 4×4, as poses are stored. Reading throws BadInput for numbers that are not finite, a last
/// row other than 0 0 0 1, a mirror image or axes off unit length or right angles by more than 1e-3;
/// within that the nearest rotation is taken.
[[nodiscard]] std::array<double, 16> to_row_major(const Rigid3& motion);
[[nodiscard]] Rigid3 from_row_major(const std::array<double, 16>& matrix);

/// The rotation nearest to the matrix (polar decomposition), reflection excluded.
[[nodiscard]] Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

} // namespace planum::geometry
