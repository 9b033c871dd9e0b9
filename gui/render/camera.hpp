// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <vector>

namespace planum::gui {

/// A camera that turns around a place of the site: right-handed, z up, metres.
struct Camera {
    Eigen::Vector3d target = Eigen::Vector3d::Zero(); ///< what stays in the middle
    double distance = 10.0;                           ///< of the eye from it [m]
    double yaw = -1.57;                               ///< direction of the eye seen from the target, from x to y [rad]
    double pitch = 0.6;                               ///< of the eye above the target [rad]
    double opening = 0.9;                             ///< from lower to upper border [rad]
    bool from_above = false;                          ///< plan: parallel, straight down, north up

    static constexpr double kNear = 0.02; ///< nearest that is drawn, in distances
    static constexpr double kFar = 40.0;  ///< farthest

    [[nodiscard]] Eigen::Vector3d eye() const;
    /// From coordinates relative to `origin` to clip space; `aspect` is width over height.
    [[nodiscard]] Eigen::Matrix4d clip_from(const Eigen::Vector3d& origin, double aspect) const;
    /// Border planes of what is seen: (normal, offset), normals of length 1, inside where normal · x + offset ≥ 0.
    [[nodiscard]] std::vector<Eigen::Vector4d> planes(double aspect) const;

    struct Sight {
        Eigen::Vector3d from;
        Eigen::Vector3d direction; ///< length 1
    };

    /// Through a place of the picture: x to the right and y upwards, both −1 … 1.
    [[nodiscard]] Sight sight(double x, double y, double aspect) const;
    /// Height at the target that one picture height shows [m].
    [[nodiscard]] double height_shown() const;

    void orbit(double turn, double lift);
    /// Moves the target in the plane of the picture, in picture heights.
    void pan(double right, double up);
    void zoom(double factor);
    /// Brings a ball into the picture.
    void look_at(const Eigen::Vector3d& middle, double radius);
};

} // namespace planum::gui
