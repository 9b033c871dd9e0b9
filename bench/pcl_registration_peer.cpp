// SPDX-License-Identifier: MIT
#include "bench/pcl_registration_peer.hpp"

#include <chrono>
#include <fstream>

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <unistd.h>

namespace planum::bench {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

double resident_mb() {
    std::size_t pages = 0;
    std::size_t resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

Cloud::Ptr cloud_of(std::span<const Eigen::Vector3d> points) {
    Cloud::Ptr cloud(new Cloud);
    cloud->reserve(points.size());
    for (const auto& x : points) {
        cloud->push_back(
            pcl::PointXYZ(static_cast<float>(x.x()), static_cast<float>(x.y()), static_cast<float>(x.z())));
    }
    return cloud;
}

Cloud::Ptr thinned(const Cloud::Ptr& cloud, double voxel) {
    if (voxel <= 0.0) return cloud;
    const auto edge = static_cast<float>(voxel);
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(edge, edge, edge);
    Cloud::Ptr thin(new Cloud);
    grid.filter(*thin);
    return thin;
}

template<class Method>
void align(Method& method, const Cloud::Ptr& target, const Cloud::Ptr& source, const geometry::Rigid3& start,
           double max_distance, PclAlignment& result) {
    method.setInputTarget(target);
    method.setInputSource(source);
    method.setMaxCorrespondenceDistance(max_distance);
    method.setMaximumIterations(30);
    Eigen::Matrix4f guess = Eigen::Matrix4f::Identity();
    guess.topLeftCorner<3, 3>() = start.rotation.cast<float>();
    guess.topRightCorner<3, 1>() = start.translation.cast<float>();
    Cloud aligned;
    method.align(aligned, guess);
    const Eigen::Matrix4d found = method.getFinalTransformation().template cast<double>();
    result.target_from_source = {found.topLeftCorner<3, 3>(), found.topRightCorner<3, 1>()};
    result.has_converged = method.hasConverged();
}

} // namespace

PclAlignment pcl_align(PclMethod method, std::span<const Eigen::Vector3d> target,
                       std::span<const Eigen::Vector3d> source, const geometry::Rigid3& start, double voxel,
                       double max_distance) {
    const Cloud::Ptr whole_target = cloud_of(target);
    const Cloud::Ptr whole_source = cloud_of(source);
    PclAlignment result;
    const double before = resident_mb();
    const auto began = std::chrono::steady_clock::now();
    const Cloud::Ptr thin_target = thinned(whole_target, voxel);
    const Cloud::Ptr thin_source = thinned(whole_source, voxel);
    if (method == PclMethod::Gicp) {
        pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
        gicp.setCorrespondenceRandomness(10);
        align(gicp, thin_target, thin_source, start, max_distance, result);
    } else {
        pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
        align(icp, thin_target, thin_source, start, max_distance, result);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    result.megabytes = resident_mb() - before;
    result.points = thin_target->size();
    return result;
}

} // namespace planum::bench
