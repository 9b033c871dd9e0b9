// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/geometry/rigid.hpp"

namespace planum::geometry {

/// What fit_rigid found.
struct RigidFit {
    Rigid3 target_from_source;
    double rms = 0.0; ///< weighted, of the distances that remain [m]
    /// How wide the sources lie: root mean squares along their three principal axes, widest first [m].
    Eigen::Vector3d spread = Eigen::Vector3d::Zero();
    /// Of the six numbers of moved(). If the weights are 1/σ² of one coordinate, it is in rad and m.
    /// Infinite on the diagonal where the points lie on a line.
    Matrix6 covariance = Matrix6::Zero();

    [[nodiscard]] bool is_determined() const { return covariance.allFinite(); }
};

/// The motion that brings sources onto targets with the least weighted sum of squares (Kabsch 1976, Umeyama
/// 1991), never a reflection. Without weights all count 1. Throws BadInput for fewer than three pairs,
/// spans of different length, weights that are negative, or coordinates that are not finite.
[[nodiscard]] RigidFit fit_rigid(std::span<const Eigen::Vector3d> x_in_source,
                                 std::span<const Eigen::Vector3d> x_in_target, std::span<const double> weights = {});

} // namespace planum::geometry
