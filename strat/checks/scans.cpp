// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "strat/checks/families.hpp"
#include "strat/checks/finish.hpp"

namespace planum::strat {

namespace {

constexpr double kPoorPosition = 0.010; ///< σ in the worst direction [m]
constexpr double kPoorRotation = 0.1;   ///< σ about the worst axis [degrees]

/// Root of the largest eigenvalue of one of the two blocks of a pose's covariance.
double largest_sigma(const std::array<double, 36>& covariance, std::size_t first) {
    std::array<double, 3> v{1.0, 0.9, 1.1};
    double size = 0.0;
    for (int round = 0; round < 60; ++round) { // power iteration: good to percents, which is all that is asked
        std::array<double, 3> next{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) next[i] += covariance[(first + i) * 6 + first + k] * v[k];
        }
        size = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
        if (!(size > 0.0)) return 0.0;
        for (std::size_t i = 0; i < 3; ++i) v[i] = next[i] / size;
    }
    return std::sqrt(size);
}

/// The pose that holds: that of the accepted run made last.
const model::ScanPose* pose_in_force(const model::Record& record, model::ScanId scan) {
    const model::ScanPose* best = nullptr;
    const model::RegistrationRun* best_run = nullptr;
    for (const model::ScanPose& pose : record.poses) {
        if (pose.scan != scan) continue;
        const auto run = std::find_if(record.runs.begin(), record.runs.end(),
                                      [&](const model::RegistrationRun& r) { return r.id == pose.run; });
        if (run == record.runs.end() || run->state != "accepted") continue;
        if (best_run != nullptr && std::tie(best_run->made_at, best_run->name) >= std::tie(run->made_at, run->name))
            continue;
        best = &pose;
        best_run = &*run;
    }
    return best;
}

void add_poor(const model::Scan& scan, const model::ScanPose& pose, Findings& findings) {
    const double position = largest_sigma(pose.covariance, 3);
    const double rotation = largest_sigma(pose.covariance, 0) * 180.0 / std::numbers::pi;
    if (position <= kPoorPosition && rotation <= kPoorRotation && !pose.verdict.starts_with("poorly")) return;
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
        if (const model::ScanPose* pose = pose_in_force(context.record, scan.id); pose != nullptr) {
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
