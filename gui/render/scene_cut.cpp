// SPDX-License-Identifier: MIT
#include "gui/render/scene_cut.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace planum::gui {

SceneSlab SceneSlab::along(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double thickness) {
    const Eigen::Vector3d way(to.x() - from.x(), to.y() - from.y(), 0.0);
    SceneSlab slab;
    slab.normal = Eigen::Vector3d(-way.y(), way.x(), 0.0).normalized();
    slab.offset = slab.normal.dot(from);
    slab.half = thickness / 2.0;
    return slab;
}

std::vector<Eigen::Vector4d> SceneSlab::planes() const {
    if (!is_cutting()) return {};
    Eigen::Vector4d near;
    near << normal, half - offset;
    Eigen::Vector4d far;
    far << -normal, half + offset;
    return {near, far};
}

std::optional<SightPart> part_inside(const Camera::Sight& sight, const SceneBox& box, const SceneSlab& slab) {
    double begins = 0.0;
    double ends = 1e9;
    // Between two parallel planes: where the place along an axis is low … high.
    const auto cut = [&](double at, double along, double low, double high) {
        if (std::abs(along) < 1e-12) {
            if (at < low || at > high) ends = -1.0;
            return;
        }
        const double a = (low - at) / along;
        const double b = (high - at) / along;
        begins = std::max(begins, std::min(a, b));
        ends = std::min(ends, std::max(a, b));
    };
    for (int axis = 0; axis < 3; ++axis) cut(sight.from(axis), sight.direction(axis), box.low(axis), box.high(axis));
    cut(slab.normal.dot(sight.from), slab.normal.dot(sight.direction), slab.offset - slab.half,
        slab.offset + slab.half);
    if (begins > ends) return std::nullopt;
    return SightPart{{sight.from + begins * sight.direction, sight.direction}, begins, ends - begins};
}

} // namespace planum::gui
