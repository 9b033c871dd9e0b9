// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "gui/render/camera.hpp"

namespace planum::gui {

/// Only points inside it are drawn; by itself everything is. Site coordinates [m].
struct SceneBox {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(-1e9);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(1e9);
};

/// Only points between its two upright planes are drawn; by itself everything is.
struct SceneSlab {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); ///< of the plane in the middle: level, length 1
    double offset = 0.0;                               ///< where normal · x_in_site is this [m]
    double half = 1e9;                                 ///< from it to either plane [m]

    /// Along the line between two places, however high they are. Seen along the normal, `from` is on the left.
    [[nodiscard]] static SceneSlab along(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double thickness);

    [[nodiscard]] bool is_cutting() const noexcept { return half < 1e9; }

    /// (normal, offset) of both planes, inside where normal · x + offset ≥ 0; none where nothing is cut away.
    [[nodiscard]] std::vector<Eigen::Vector4d> planes() const;

    friend bool operator==(const SceneSlab&, const SceneSlab&) = default;
};

/// The part of a line of sight that runs through what is drawn.
struct SightPart {
    Camera::Sight sight; ///< begins where it enters
    double begins = 0.0; ///< so far from the eye [m]
    double length = 0.0; ///< until it leaves [m]
};

/// nullopt: it passes beside it.
[[nodiscard]] std::optional<SightPart> part_inside(const Camera::Sight& sight, const SceneBox& box,
                                                   const SceneSlab& slab);

} // namespace planum::gui
