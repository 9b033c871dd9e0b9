// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "scans/registration/point_index.hpp"

namespace planum::scans {

/// A point with the little plane it lies in.
struct Surfel {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();       ///< [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();        ///< unit, towards the scanner
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity(); ///< thin along the normal, wide across [m²]
    bool is_flat = false;                                     ///< false: edge, twig, single scan line; does not vote
};

struct SurfelOptions {
    double voxel = 0.02;   ///< points within one cube of this edge become one [m]; 0: none do
    int neighbours = 12;   ///< points that make the plane
    double noise = 0.0005; ///< least spread along a normal that is believed [m]
    int threads = 2;
};

/// A scan thinned to one point a cube, with planes and an index. Ordered by cube, so the order of the points
/// in the file does not matter but to rounding.
struct SurfelCloud {
    double voxel = 0.0; ///< [m]
    std::vector<Surfel> surfels;
    PointIndex index{std::span<const Eigen::Vector3d>{}};
};

/// Mean of the points of every cube of the grid with this edge [m], in the order of the cubes. Points that are
/// not finite are left out. Throws BadInput if the points spread over more than 2 million cubes a side.
[[nodiscard]] std::vector<Eigen::Vector3d> thin_out(std::span<const Eigen::Vector3d> points, double voxel);

/// Points in the frame of the scanner, which stands at the origin.
[[nodiscard]] SurfelCloud make_surfels(std::span<const Eigen::Vector3d> x_in_scan, const SurfelOptions& options);

} // namespace planum::scans
