// SPDX-License-Identifier: MIT
#pragma once

#include "scans/cloud/store_shapes.hpp"

namespace planum::scans {

/// How much of a node lies inside what is looked for. Where rounding leaves a doubt, Some.
enum class Overlap { None, Some, All };

[[nodiscard]] Overlap box_overlap(const Box& box, const Box& node) noexcept;
[[nodiscard]] Overlap plane_overlap(const Frustum& frustum, const Box& node) noexcept;

/// Axis-parallel box around a box seen in another frame.
[[nodiscard]] Box turned(const Eigen::Isometry3d& to, const Box& box) noexcept;

/// From a place to the nearest of the box; 0 inside [m²].
[[nodiscard]] double squared_distance(const Box& box, const Eigen::Vector3d& x) noexcept;

/// The least distance along a ray at which anything in the box can be hit; infinite when nothing can [m].
[[nodiscard]] double first_reach(const Ray& ray, const Box& box) noexcept;

} // namespace planum::scans
