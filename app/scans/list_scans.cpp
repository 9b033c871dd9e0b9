// SPDX-License-Identifier: MIT
#include "app/scans/list_scans.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/pose_sigma.hpp"

namespace planum::app {

namespace {

void add_pose(ListedScan& listed, const model::ScanPose& pose, const model::Record& record) {
    listed.status = "registered";
    listed.site_from_scan = pose.site_from_scan;
    listed.rms = pose.rms;
    listed.overlap = pose.overlap;
    listed.verdict = pose.verdict;
    const geometry::PoseSigma sigma = geometry::worst_sigma(pose.covariance);
    listed.sigma_rotation_deg = sigma.rotation * 180.0 / std::numbers::pi;
    listed.sigma_position = sigma.position;
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
        if (const model::ScanPose* pose = model::pose_in_force(record, scan.id); pose != nullptr) {
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
