// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

namespace planum::scans {

// Where to look in a point store. Everything is in the scan's frame, in metres.

/// Axis-parallel, borders included.
struct Box {
    Eigen::Vector3d minimum = Eigen::Vector3d::Zero();
    Eigen::Vector3d maximum = Eigen::Vector3d::Zero();

    [[nodiscard]] bool contains(const Eigen::Vector3d& x) const noexcept {
        return (x.array() >= minimum.array()).all() && (x.array() <= maximum.array()).all();
    }
};

/// x is inside when normal · x + offset ≥ 0 for all planes; `eye` says what is near and so shown in detail.
struct Frustum {
    std::vector<Eigen::Vector4d> planes; ///< (normal, offset), normals of length 1
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();

    [[nodiscard]] bool contains(const Eigen::Vector3d& x) const noexcept {
        for (const Eigen::Vector4d& plane : planes) {
            if (plane.head<3>().dot(x) + plane.w() < 0.0) return false;
        }
        return true;
    }
};

/// A polygon in the x-y plane of its own frame, drawn out in z: for regions in plan and in section.
struct Prism {
    std::vector<Eigen::Vector2d> corners; ///< closed by itself; even-odd rule
    double z_minimum = -1e9;              ///< [m]
    double z_maximum = 1e9;
    Eigen::Isometry3d prism_from_scan = Eigen::Isometry3d::Identity();

    [[nodiscard]] bool contains(const Eigen::Vector3d& x) const noexcept;
};

/// A ray that widens: a point is hit when it is no farther from the axis than radius + distance × spread.
struct Ray {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< length 1
    double radius = 0.01;                                 ///< [m] at the origin
    double spread = 0.0;                                  ///< tangent of the half angle

    /// Distance along the ray, negative when the point is not hit.
    [[nodiscard]] double hit(const Eigen::Vector3d& x) const noexcept {
        const Eigen::Vector3d from = x - origin;
        const double along = from.dot(direction);
        if (along < 0.0) return -1.0;
        const double reach = radius + along * spread;
        return (from - along * direction).squaredNorm() <= reach * reach ? along : -1.0;
    }
};

} // namespace planum::scans
