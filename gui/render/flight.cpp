// SPDX-License-Identifier: MIT
#include "gui/render/flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planum::gui {

namespace {

Eigen::Vector3d on_curve(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                         const Eigen::Vector3d& d, double t) {
    return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                  (3.0 * b - a - 3.0 * c + d) * t * t * t);
}

// Slow at both ends of a leg, so that it does not jerk where cameras stand far apart.
double eased(double t) { return t * t * (3.0 - 2.0 * t); }

} // namespace

std::vector<Camera> flight_along(const std::vector<Camera>& placed, int frames) {
    std::vector<Camera> way;
    if (placed.empty()) return way;
    const int steps = std::max(frames, 1);
    for (std::size_t leg = 0; leg + 1 < placed.size(); ++leg) {
        const Camera& from = placed[leg];
        const Camera& to = placed[leg + 1];
        const Eigen::Vector3d& before = placed[leg == 0 ? 0 : leg - 1].target;
        const Eigen::Vector3d& after = placed[std::min(leg + 2, placed.size() - 1)].target;
        const double turn = std::remainder(to.yaw - from.yaw, 2.0 * std::numbers::pi);
        for (int i = 0; i < steps; ++i) {
            const double t = eased(static_cast<double>(i) / steps);
            Camera camera = from;
            camera.target = on_curve(before, from.target, to.target, after, t);
            camera.distance = from.distance * std::pow(to.distance / from.distance, t);
            camera.yaw = from.yaw + turn * t;
            camera.pitch = from.pitch + (to.pitch - from.pitch) * t;
            camera.from_above = from.from_above;
            way.push_back(camera);
        }
    }
    way.push_back(placed.back());
    return way;
}

} // namespace planum::gui
