// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace planum::geometry {

/// How far a pose may be off in the worst direction and about the worst axis: roots of the largest eigenvalues of the
/// two blocks of its covariance.
struct PoseSigma {
    double position = 0.0; ///< [m]
    double rotation = 0.0; ///< [rad]
};

/// Of a covariance as poses store it: (rotation, translation), row-major.
[[nodiscard]] PoseSigma worst_sigma(const std::array<double, 36>& covariance);

} // namespace planum::geometry
