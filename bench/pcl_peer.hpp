// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "scans/formats/point_block.hpp"

/// The Point Cloud Library on the same files and points. Only built where libpcl-dev is installed; never part of the
/// product.
namespace planum::bench {

/// Each reads the file into a cloud in memory and returns the number of its points.
std::size_t pcl_read_ply(const std::filesystem::path& file);
std::size_t pcl_read_pcd(const std::filesystem::path& file);

/// Processor time of PCL's octree (OctreePointCloudSearch), leaves of 10 cm.
struct PclOctree {
    double build = 0.0;   ///< [s]
    double box = 0.0;     ///< all points in the box [s]
    double nearest = 0.0; ///< 1,000 queries [s]
    std::size_t in_box = 0;
    double megabytes = 0.0; ///< by which the process grew: cloud and tree
};

PclOctree pcl_octree(const scans::PointBlock& cloud);

} // namespace planum::bench
