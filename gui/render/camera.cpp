// SPDX-License-Identifier: MIT
#include "gui/render/camera.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace planum::gui {

namespace {

struct Axes {
    Eigen::Vector3d right;
    Eigen::Vector3d up;
    Eigen::Vector3d back; ///< from the target to the eye
};

Axes axes_of(const Camera& camera) {
    if (camera.from_above) return {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
    const double c = std::cos(camera.pitch);
    const Eigen::Vector3d back(c * std::cos(camera.yaw), c * std::sin(camera.yaw), std::sin(camera.pitch));
    const Eigen::Vector3d right(-std::sin(camera.yaw), std::cos(camera.yaw), 0.0);
    return {right, back.cross(right), back};
}

} // namespace

Eigen::Vector3d Camera::eye() const { return target + distance * axes_of(*this).back; }

double Camera::height_shown() const { return 2.0 * distance * std::tan(opening / 2.0); }

Eigen::Matrix4d Camera::clip_from(const Eigen::Vector3d& origin, double aspect) const {
    const Axes axes = axes_of(*this);
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = axes.right.transpose();
    view.block<1, 3>(1, 0) = axes.up.transpose();
    view.block<1, 3>(2, 0) = axes.back.transpose();
    view.block<3, 1>(0, 3) = view.block<3, 3>(0, 0) * (origin - eye());
    const double near = kNear * distance;
    const double far = kFar * distance;
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
    if (from_above) {
        clip(0, 0) = 2.0 / (height_shown() * aspect);
        clip(1, 1) = 2.0 / height_shown();
        clip(2, 2) = -1.0 / far;
        clip(3, 3) = 1.0;
        return clip * view;
    }
    const double f = 1.0 / std::tan(opening / 2.0);
    clip(0, 0) = f / aspect;
    clip(1, 1) = f;
    clip(2, 2) = (far + near) / (near - far);
    clip(2, 3) = 2.0 * far * near / (near - far);
    clip(3, 2) = -1.0;
    return clip * view;
}

std::vector<Eigen::Vector4d> Camera::planes(double aspect) const {
    // Rows of the clip matrix give the planes (Gribb and Hartmann 2001).
    const Eigen::Matrix4d m = clip_from(Eigen::Vector3d::Zero(), aspect);
    std::vector<Eigen::Vector4d> planes;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            Eigen::Vector4d plane = (m.row(3) + sign * m.row(axis)).transpose();
            plane /= plane.head<3>().norm();
            planes.push_back(plane);
        }
    }
    return planes;
}

Camera::Sight Camera::sight(double x, double y, double aspect) const {
    const Axes axes = axes_of(*this);
    const double half = height_shown() / 2.0;
    const Eigen::Vector3d through = target + axes.right * (x * half * aspect) + axes.up * (y * half);
    if (from_above) return {through + axes.back * distance * kFar / 2.0, -axes.back};
    return {eye(), (through - eye()).normalized()};
}

void Camera::orbit(double turn, double lift) {
    from_above = false;
    yaw += turn;
    pitch = std::clamp(pitch + lift, -1.5, 1.55);
}

void Camera::pan(double right, double up) {
    const Axes axes = axes_of(*this);
    target += (axes.right * right + axes.up * up) * height_shown();
}

void Camera::zoom(double factor) { distance = std::clamp(distance / factor, 0.05, 5000.0); }

void Camera::look_at(const Eigen::Vector3d& middle, double radius) {
    target = middle;
    distance = std::max(radius, 0.1) / std::sin(opening / 2.0);
}

} // namespace planum::gui
