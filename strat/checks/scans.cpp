// SPDX-License-Identifier: MIT
#include <numbers>

#include <fmt/format.h>

#include "core/geometry/pose_sigma.hpp"
#include "strat/checks/families.hpp"
#include "strat/checks/finish.hpp"

namespace planum::strat {

namespace {

void add_poor(const model::Scan& scan, const model::ScanPose& pose, Findings& findings) {
    const auto [position, turn] = geometry::worst_sigma(pose.covariance);
    const double rotation = turn * 180.0 / std::numbers::pi;
    if (position <= model::kPoorPosition && turn <= model::kPoorRotation && !pose.verdict.starts_with("poorly")) return;
    auto d = make_diagnostic(model::Severity::Info, "scan-poorly-registered",
                             fmt::format("{} stands where it does only to {:.0f} mm and {:.2f} degrees: {}", scan.name,
                                         position * 1e3, rotation,
                                         pose.verdict.empty() ? "the run says no more" : pose.verdict));
    d.evidence["scan"] = scan.name;
    d.evidence["sigma_position_m"] = position;
    d.evidence["sigma_rotation_deg"] = rotation;
    findings.push_back(std::move(d));
}

} // namespace

void check_scans(const CheckContext& context, Findings& findings) {
    if (!context.options.with_infos) return;
    for (const model::Scan& scan : context.record.scans) {
        if (const model::ScanPose* pose = model::pose_in_force(context.record, scan.id); pose != nullptr) {
            add_poor(scan, *pose, findings);
            continue;
        }
        auto d = make_diagnostic(
            model::Severity::Info, "scan-unregistered",
            fmt::format(
                "{} is not on the site grid, so nothing can be concluded from it; planum register SITE says why",
                scan.name));
        d.evidence["scan"] = scan.name;
        findings.push_back(std::move(d));
    }
}

} // namespace planum::strat
