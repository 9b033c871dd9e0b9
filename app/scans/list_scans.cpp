// SPDX-License-Identifier: MIT
#include "app/scans/list_scans.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

double largest_sigma(const Eigen::Matrix3d& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

void add_pose(ListedScan& listed, const model::ScanPose& pose, const model::Record& record) {
    listed.status = "registered";
    listed.site_from_scan = pose.site_from_scan;
    listed.rms = pose.rms;
    listed.overlap = pose.overlap;
    listed.verdict = pose.verdict;
    const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> covariance(pose.covariance.data());
    listed.sigma_rotation_deg = largest_sigma(covariance.topLeftCorner<3, 3>()) * 180.0 / std::numbers::pi;
    listed.sigma_position = largest_sigma(covariance.bottomRightCorner<3, 3>());
    for (const model::RegistrationRun& run : record.runs) {
        if (run.id == pose.run) listed.method = run.method;
    }
}

} // namespace

std::vector<ListedScan> list_scans(Project& project) {
    const model::Record& record = project.record();
    std::vector<ListedScan> all;
    for (const model::Scan& scan : record.scans) {
        ListedScan listed;
        listed.scan = scan.name;
        listed.day = scan.day;
        listed.points = scan.points;
        listed.status = "raw";
        listed.file = scan.path;
        listed.original_there = std::filesystem::exists(original_path(project.path(), scan));
        for (const model::Surface& surface : record.surfaces) {
            if (surface.id == scan.surface) listed.surface = surface_name(record, surface);
        }
        if (const model::ScanPose* pose = accepted_pose(record, scan.id); pose != nullptr) {
            add_pose(listed, *pose, record);
        }
        all.push_back(std::move(listed));
    }
    std::sort(all.begin(), all.end(),
              [](const ListedScan& a, const ListedScan& b) { return text::natural_order(a.scan, b.scan) < 0; });
    return all;
}

const model::Scan& scan_named(Project& project, std::string_view name) {
    for (const model::Scan& scan : project.record().scans) {
        if (scan.name == name) return scan;
    }
    throw Error(ErrorCode::NotFound, fmt::format("no scan {}; planum scan list shows them", name));
}

void delete_scan(Project& project, std::string_view name) {
    const model::ScanId scan = scan_named(project, name).id;
    project.change(fmt::format("Delete scan {}", name), [&] { project.file().remove(scan); });
}

} // namespace planum::app
