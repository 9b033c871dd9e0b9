// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scans/surface/layer_field.hpp"
#include "scans/surface/surface_builder.hpp"

namespace planum::scans {

/// σ of how far an error of a pose lifts the ground at a place [m]. A small turn w and shift t move the place r from
/// the station by w × r + t, which lifts ground of normal n = (−∂z/∂x, −∂z/∂y, 1) by w·(r × n) + t·n.
[[nodiscard]] double lift_of_pose(const SurfaceScan& scan, const Eigen::Vector3d& x_in_site,
                                  const std::array<double, 2>& gradient);

/// Mean of lift_of_pose over the scans of a mask (see mask_of); the slope counts up to `steepest`.
[[nodiscard]] double mean_lift(std::span<const SurfaceScan> scans, std::uint32_t mask, const Eigen::Vector3d& x_in_site,
                               std::array<double, 2> gradient, double steepest);

/// Finds where scans disagree, marks those cells Disputed with the height of the scan with most points.
[[nodiscard]] std::vector<DisputedPatch> settle_disputes(const LayerField& field, std::span<const SurfaceScan> scans,
                                                         const SurfaceOptions& options, SurfaceGrid& grid);

} // namespace planum::scans
