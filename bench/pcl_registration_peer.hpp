// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <Eigen/Core>

#include "core/geometry/rigid.hpp"

/// The fine alignments of the Point Cloud Library on the same points. Only built where libpcl-dev is installed; never
/// part of the product.
namespace planum::bench {

enum class PclMethod { Gicp, Icp };

struct PclAlignment {
    geometry::Rigid3 target_from_source;
    double seconds = 0.0;   ///< wall, thinning and planes included
    double megabytes = 0.0; ///< by which the process grew
    std::size_t points = 0; ///< of the target that took part
    bool has_converged = false;
};

/// Thins both scans to one point a cube of `voxel` [m] (0: not at all) and aligns them as PCL does unasked but for the
/// largest distance of a pair [m], 30 iterations and 10 neighbours of a plane.
PclAlignment pcl_align(PclMethod method, std::span<const Eigen::Vector3d> target,
                       std::span<const Eigen::Vector3d> source, const geometry::Rigid3& start, double voxel,
                       double max_distance);

} // namespace planum::bench
