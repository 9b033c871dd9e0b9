// SPDX-License-Identifier: MIT
#include "bench/pcl_peer.hpp"

#include <ctime>
#include <fstream>

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/octree/octree_search.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <unistd.h>

#include "core/base/error.hpp"

namespace planum::bench {

namespace {

double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double resident_mb() {
    std::size_t pages = 0;
    std::size_t resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

} // namespace

std::size_t pcl_read_ply(const std::filesystem::path& file) {
    pcl::PointCloud<pcl::PointXYZI> cloud;
    if (pcl::io::loadPLYFile(file.string(), cloud) != 0) throw Error(ErrorCode::Io, "PCL cannot read " + file.string());
    return cloud.size();
}

std::size_t pcl_read_pcd(const std::filesystem::path& file) {
    pcl::PointCloud<pcl::PointXYZI> cloud;
    if (pcl::io::loadPCDFile(file.string(), cloud) != 0) throw Error(ErrorCode::Io, "PCL cannot read " + file.string());
    return cloud.size();
}

PclOctree pcl_octree(const scans::PointBlock& points) {
    const double before = resident_mb();
    const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    cloud->reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        cloud->push_back(pcl::PointXYZ(static_cast<float>(points.x[i]), static_cast<float>(points.y[i]),
                                       static_cast<float>(points.z[i])));
    }
    PclOctree result;
    double start = now();
    pcl::octree::OctreePointCloudSearch<pcl::PointXYZ> tree(0.1);
    tree.setInputCloud(cloud);
    tree.addPointsFromInputCloud();
    result.build = now() - start;
    result.megabytes = resident_mb() - before;
    pcl::Indices found;
    start = now();
    tree.boxSearch({-2.0F, -2.0F, -5.0F}, {2.0F, 2.0F, 5.0F}, found);
    result.box = now() - start;
    result.in_box = found.size();
    std::vector<float> distances;
    start = now();
    for (int i = 0; i < 1000; ++i) {
        const pcl::PointXYZ at(0.01F * static_cast<float>(i) - 5.0F, 0.003F * static_cast<float>(i), 1.0F);
        tree.nearestKSearch(at, 1, found, distances);
    }
    result.nearest = now() - start;
    return result;
}

} // namespace planum::bench
