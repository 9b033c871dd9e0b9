// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/rigid.hpp"

namespace planum::test {

struct GroundOptions {
    int points = 12000;
    double sigma = 0.002;   ///< noise of a point across its surface [m]
    double dug_depth = 0.0; ///< the middle of the pit floor lies this much lower [m]
    unsigned seed = 1;      ///< of the places of the points and their noise; the ground is the same
    bool is_mirrored = false;
};

/// Points on an 8 × 6 m site with a pit, rolling ground and two walls, as seen from site_from_scan.
[[nodiscard]] std::vector<Eigen::Vector3d> synthetic_ground(const geometry::Rigid3& site_from_scan,
                                                            const GroundOptions& options = {});

} // namespace planum::test
