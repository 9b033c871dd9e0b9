// SPDX-License-Identifier: MIT
#include "scans/cloud/shape_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planum::scans {

Overlap box_overlap(const Box& box, const Box& node) noexcept {
    if ((node.minimum.array() > box.maximum.array()).any() || (node.maximum.array() < box.minimum.array()).any())
        return Overlap::None;
    return box.contains(node.minimum) && box.contains(node.maximum) ? Overlap::All : Overlap::Some;
}

Overlap plane_overlap(const Frustum& frustum, const Box& node) noexcept {
    Overlap overlap = Overlap::All;
    const Eigen::Vector3d centre = 0.5 * (node.minimum + node.maximum);
    const Eigen::Vector3d half = 0.5 * (node.maximum - node.minimum);
    for (const Eigen::Vector4d& plane : frustum.planes) {
        const double distance = plane.head<3>().dot(centre) + plane.w();
        const double reach = plane.head<3>().cwiseAbs().dot(half);
        // A rounding error must not turn "some" into "all".
        const double doubt = 1e-9 * (1.0 + std::abs(distance) + reach);
        if (distance < -reach - doubt) return Overlap::None;
        if (distance < reach + doubt) overlap = Overlap::Some;
    }
    return overlap;
}

Box turned(const Eigen::Isometry3d& to, const Box& box) noexcept {
    const Eigen::Vector3d centre = to * (0.5 * (box.minimum + box.maximum));
    const Eigen::Vector3d half = to.linear().cwiseAbs() * (0.5 * (box.maximum - box.minimum));
    return {centre - half, centre + half};
}

double squared_distance(const Box& box, const Eigen::Vector3d& x) noexcept {
    return (x - x.cwiseMax(box.minimum).cwiseMin(box.maximum)).squaredNorm();
}

double first_reach(const Ray& ray, const Box& box) noexcept {
    const Eigen::Vector3d centre = 0.5 * (box.minimum + box.maximum);
    const double radius = 0.5 * (box.maximum - box.minimum).norm();
    const Eigen::Vector3d from = centre - ray.origin;
    const double along = from.dot(ray.direction);
    if (along + radius < 0.0) return std::numeric_limits<double>::infinity();
    const double across = (from - along * ray.direction).norm();
    const double widest = ray.radius + std::max(0.0, along + radius) * ray.spread;
    if (across - radius > widest * (1.0 + 1e-12)) return std::numeric_limits<double>::infinity();
    return std::max(0.0, along - radius);
}

} // namespace planum::scans
