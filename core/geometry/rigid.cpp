// SPDX-License-Identifier: MIT
#include "core/geometry/rigid.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/core.h>

#include "core/base/error.hpp"

namespace planum::geometry {

namespace {

constexpr double kSmallAngle = 1e-4; ///< [rad]; below it three terms of the series are exact to rounding

/// (1 − cos θ)/θ² and (θ − sin θ)/θ³, the two coefficients of the matrix V of SE(3).
struct Coefficients {
    double of_cross = 0.5;
    double of_square = 1.0 / 6.0;
};

Coefficients coefficients(double angle) {
    const double square = angle * angle;
    if (angle < kSmallAngle) return {0.5 - square / 24.0, 1.0 / 6.0 - square / 120.0};
    // 1 − cos θ = 2 sin²(θ/2) does not cancel.
    const double half_sine = std::sin(0.5 * angle);
    return {2.0 * half_sine * half_sine / square, (angle - std::sin(angle)) / (square * angle)};
}

} // namespace

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
    Eigen::Matrix3d m;
    m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return m;
}

Eigen::Matrix3d exp_rotation(const Eigen::Vector3d& turn) {
    const double half = 0.5 * turn.norm();
    const double scale = half < kSmallAngle ? 0.5 * (1.0 - half * half / 6.0) : 0.5 * std::sin(half) / half;
    Eigen::Quaterniond q;
    q.w() = std::cos(half);
    q.vec() = scale * turn;
    return q.normalized().toRotationMatrix();
}

Eigen::Vector3d log_rotation(const Eigen::Matrix3d& rotation) {
    Eigen::Quaterniond q(rotation);
    q.normalize();
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    const double sine = q.vec().norm();
    if (sine < kSmallAngle) {
        const double tangent = sine / q.w();
        return 2.0 / q.w() * (1.0 - tangent * tangent / 3.0) * q.vec();
    }
    return 2.0 * std::atan2(sine, q.w()) / sine * q.vec();
}

Rigid3 exp_rigid(const Vector6& twist) {
    const Eigen::Vector3d turn = twist.head<3>();
    const auto c = coefficients(turn.norm());
    const Eigen::Matrix3d w = cross_matrix(turn);
    const Eigen::Matrix3d v = Eigen::Matrix3d::Identity() + c.of_cross * w + c.of_square * w * w;
    return {exp_rotation(turn), v * twist.tail<3>()};
}

Vector6 log_rigid(const Rigid3& motion) {
    const Eigen::Vector3d turn = log_rotation(motion.rotation);
    const double angle = turn.norm();
    const Eigen::Matrix3d w = cross_matrix(turn);
    // V⁻¹ = I − w/2 + (1 − (θ/2) cot(θ/2))/θ² w²
    double of_square = 1.0 / 12.0 + angle * angle / 720.0;
    if (angle >= kSmallAngle) {
        const double half = 0.5 * angle;
        of_square = (1.0 - half * std::cos(half) / std::sin(half)) / (angle * angle);
    }
    const Eigen::Matrix3d v_inverse = Eigen::Matrix3d::Identity() - 0.5 * w + of_square * w * w;
    Vector6 twist;
    twist << turn, v_inverse * motion.translation;
    return twist;
}

Matrix6 adjoint(const Rigid3& motion) {
    Matrix6 m = Matrix6::Zero();
    m.topLeftCorner<3, 3>() = motion.rotation;
    m.bottomRightCorner<3, 3>() = motion.rotation;
    m.bottomLeftCorner<3, 3>() = cross_matrix(motion.translation) * motion.rotation;
    return m;
}

Rigid3 moved(const Rigid3& target_from_source, const Vector6& step) {
    // Renormalised, so that a thousand small steps do not shear the axes.
    const Eigen::Quaterniond q(exp_rotation(step.head<3>()) * target_from_source.rotation);
    return {q.normalized().toRotationMatrix(), target_from_source.translation + step.tail<3>()};
}

Vector6 step_between(const Rigid3& from, const Rigid3& to) {
    Vector6 step;
    step << log_rotation(to.rotation * from.rotation.transpose()), to.translation - from.translation;
    return step;
}

Matrix6 covariance_of_inverse(const Rigid3& target_from_source, const Matrix6& covariance) {
    // R' = e^ω R, t' = t + ρ: the inverse turns by −Rᵀω and shifts by −Rᵀρ + (Rᵀt)×… to first order.
    const Eigen::Matrix3d back = target_from_source.rotation.transpose();
    Matrix6 j = Matrix6::Zero();
    j.topLeftCorner<3, 3>() = -back;
    j.bottomRightCorner<3, 3>() = -back;
    j.bottomLeftCorner<3, 3>() = -back * cross_matrix(target_from_source.translation);
    return j * covariance * j.transpose();
}

Matrix6 product_by_first(const Rigid3& first, const Rigid3& second) {
    Matrix6 j = Matrix6::Identity();
    j.bottomLeftCorner<3, 3>() = -cross_matrix(first.rotation * second.translation);
    return j;
}

Matrix6 product_by_second(const Rigid3& first) {
    Matrix6 j = Matrix6::Zero();
    j.topLeftCorner<3, 3>() = first.rotation;
    j.bottomRightCorner<3, 3>() = first.rotation;
    return j;
}

double rotation_angle(const Rigid3& motion) { return log_rotation(motion.rotation).norm(); }

std::array<double, 16> to_row_major(const Rigid3& motion) {
    std::array<double, 16> m{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            m[static_cast<std::size_t>(4 * row + column)] = motion.rotation(row, column);
        }
        m[static_cast<std::size_t>(4 * row + 3)] = motion.translation[row];
    }
    m[15] = 1.0;
    return m;
}

Rigid3 from_row_major(const std::array<double, 16>& matrix) {
    constexpr double kTolerance = 1e-3;
    Rigid3 motion;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            motion.rotation(row, column) = matrix[static_cast<std::size_t>(4 * row + column)];
        }
        motion.translation[row] = matrix[static_cast<std::size_t>(4 * row + 3)];
    }
    if (!motion.rotation.allFinite() || !motion.translation.allFinite()) {
        throw Error(ErrorCode::BadInput, "pose with a number that is not finite");
    }
    if (matrix[12] != 0.0 || matrix[13] != 0.0 || matrix[14] != 0.0 || matrix[15] != 1.0) {
        throw Error(ErrorCode::BadInput, "pose whose last row is not 0 0 0 1: is it written column by column?");
    }
    const Eigen::Matrix3d gram = motion.rotation * motion.rotation.transpose();
    const double off = (gram - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (off > kTolerance) {
        throw Error(
            ErrorCode::BadInput,
            fmt::format("pose that is not rigid: axes are off by {:.2g}, the limit is {:.2g}", off, kTolerance));
    }
    if (motion.rotation.determinant() < 0.0) {
        throw Error(ErrorCode::BadInput, "pose that is a mirror image: swap one axis in the export");
    }
    motion.rotation = nearest_rotation(motion.rotation);
    return motion;
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    // Umeyama 1991, eq. 43: a reflection is undone along the weakest direction.
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs.z() = -1.0;
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

} // namespace planum::geometry
