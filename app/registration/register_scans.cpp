// SPDX-License-Identifier: MIT
#include "app/registration/register_scans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/registration/markers.hpp"
#include "app/registration/registration_chain.hpp"
#include "app/registration/registration_runs.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/list_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/pose_sigma.hpp"

namespace planum::app {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::array<double, 36> row_major(const geometry::Matrix6& covariance) {
    std::array<double, 36> numbers{};
    Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(numbers.data()) = covariance;
    return numbers;
}

/// Which scans take part, in natural order, and which of them are to be placed.
ChainInput chain_input(Project& project, const RegisterOptions& options) {
    const model::Record& record = project.record();
    if (record.scans.empty())
        throw Error(ErrorCode::BadInput, "the project has no scans yet: planum scan add SITE FILE|FOLDER");
    std::vector<model::Scan> scans = record.scans;
    std::sort(scans.begin(), scans.end(),
              [](const model::Scan& a, const model::Scan& b) { return text::natural_order(a.name, b.name) < 0; });
    if (!options.day.empty()) require_day("--day", options.day);
    const MarkerTable markers = project_markers(record);
    ChainInput input;
    input.project = project.path();
    input.survey = markers.survey;
    bool has_day = false;
    for (const auto& scan : scans) {
        ChainScan one;
        one.scan = scan;
        const model::ScanPose* pose = model::pose_in_force(record, scan.id);
        const bool is_asked = options.day.empty() ? options.again || pose == nullptr : scan.day == options.day;
        has_day = has_day || scan.day == options.day;
        if (pose != nullptr) {
            one.accepted =
                AcceptedPose{geometry::from_row_major(pose->site_from_scan),
                             Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(pose->covariance.data())};
        }
        one.is_asked = is_asked;
        one.is_origin = scan.name == options.origin;
        if (const auto it = markers.in_scan.find(scan.name); it != markers.in_scan.end()) one.markers = it->second;
        if (is_asked || pose != nullptr) input.scans.push_back(std::move(one));
    }
    if (!options.day.empty() && !has_day)
        throw Error(ErrorCode::NotFound, fmt::format("no scan was made on {}", options.day));
    if (!options.origin.empty()) static_cast<void>(scan_named(project, options.origin));
    return input;
}

std::string placed_by(const ChainScan& asked, const ChainScanResult& scan) {
    if (asked.is_origin) return "its own frame, which is taken for the site grid";
    std::vector<std::string> parts;
    if (scan.anchored_by_markers) parts.push_back(fmt::format("{} markers", scan.markers.used));
    if (scan.links > 0) parts.push_back(scan.links == 1 ? "1 link" : fmt::format("{} links", scan.links));
    return text::join(parts, " and ");
}

/// The sentence about a placed scan, and whether it is placed poorly.
void judge(ReportedScan& reported, const ChainScan& asked, const ChainScanResult& result) {
    std::vector<std::string> doubts;
    if (reported.sigma_position > model::kPoorPosition) {
        doubts.push_back(fmt::format("its position is only known to {:.0f} mm", reported.sigma_position * 1e3));
    }
    if (reported.sigma_rotation_deg > model::kPoorRotation * kDegrees) {
        doubts.push_back(fmt::format("its direction is only known to {:.2f} degrees", reported.sigma_rotation_deg));
    }
    if (result.by_features_only) doubts.push_back("it was placed by features alone, which are good to centimetres");
    reported.is_poor = !doubts.empty();
    const std::string by = placed_by(asked, result);
    reported.verdict = reported.is_poor ? fmt::format("poorly placed by {}: {}", by, text::join(doubts, "; "))
                                        : fmt::format("placed by {}", by);
    for (const auto& marker : result.markers.residuals) {
        if (!marker.is_used) reported.verdict += fmt::format("; marker {} left out: {}", marker.name, marker.reason);
    }
    if (!result.anchor_doubt.empty()) reported.verdict += "; its markers were left out: " + result.anchor_doubt;
}

ReportedScan report_scan(const ChainScan& scan, const ChainScanResult& result) {
    ReportedScan reported;
    reported.scan = scan.scan.name;
    reported.day = scan.scan.day;
    reported.points = scan.scan.points;
    for (const auto& marker : result.markers.residuals) {
        reported.markers.push_back({marker.name, marker.is_used, marker.residual.norm(), marker.reason});
    }
    reported.links = result.links;
    if (!result.pose) {
        reported.status = "failed";
        reported.verdict = result.why_not;
        return reported;
    }
    reported.status = "registered";
    reported.method = scan.is_origin            ? "origin"
                      : result.links == 0       ? "markers"
                      : result.by_features_only ? "features"
                                                : "icp";
    reported.site_from_scan = geometry::to_row_major(result.pose->site_from_scan);
    reported.covariance = row_major(result.pose->covariance);
    reported.rms = result.rms;
    reported.overlap = result.overlap;
    const geometry::PoseSigma sigma = geometry::worst_sigma(reported.covariance);
    reported.sigma_position = sigma.position;
    reported.sigma_rotation_deg = sigma.rotation * kDegrees;
    reported.sigma_to_others =
        result.links == 0 ? sigma.position : geometry::worst_sigma(row_major(result.pose->link_covariance)).position;
    judge(reported, scan, result);
    return reported;
}

ReportedLink report_link(const ChainInput& input, const ChainLink& link) {
    ReportedLink reported;
    reported.from = input.scans[link.target].scan.name;
    reported.to = input.scans[link.source].scan.name;
    reported.from_from_to = geometry::to_row_major(link.target_from_source);
    reported.covariance = row_major(link.covariance);
    reported.is_accepted = link.is_used;
    reported.rms = link.rms;
    reported.overlap = link.overlap;
    reported.matches = link.matches;
    reported.inliers = link.inliers;
    const geometry::PoseSigma sigma = geometry::worst_sigma(reported.covariance);
    reported.sigma_position = sigma.position;
    reported.sigma_rotation_deg = sigma.rotation * kDegrees;
    reported.error_before = link.check.before;
    reported.error_after = link.check.after;
    reported.shift = link.check.shift;
    reported.turn_deg = link.check.turn * kDegrees;
    for (const auto& patch : link.patches) {
        reported.stable_patches += patch.state == scans::PatchState::Stable ? 1 : 0;
        reported.changed_patches += patch.state == scans::PatchState::Changed ? 1 : 0;
        reported.shifted_patches += patch.state == scans::PatchState::Shifted ? 1 : 0;
    }
    reported.verdict = link.verdict;
    return reported;
}

void report_loops(RegistrationReport& report) {
    double before = 0.0;
    double after = 0.0;
    int used = 0;
    int grown = 0;
    double worst = 0.0;
    for (const auto& link : report.links) {
        if (!link.is_accepted) continue;
        before += link.error_before * link.error_before;
        after += link.error_after * link.error_after;
        worst = std::max(worst, link.error_after);
        grown += link.error_after > link.error_before ? 1 : 0;
        ++used;
    }
    if (used == 0) return;
    report.loops_before = std::sqrt(before / used);
    report.loops_after = std::sqrt(after / used);
    report.notes.push_back(fmt::format("relaxation took the links' errors from {:.2f} to {:.2f} standard deviations "
                                       "(root mean square); of {} links {} "
                                       "gave way to others, none is off by more than {:.1f}",
                                       report.loops_before, report.loops_after, used, grown, worst));
}

RegistrationReport make_report(const ChainInput& input, const ChainResult& result, const RegisterOptions& options) {
    RegistrationReport report;
    report.method = std::string(to_word(options.method));
    report.pairs_tried = result.pairs_tried;
    for (std::size_t i = 0; i < input.scans.size(); ++i) {
        if (input.scans[i].is_asked) report.scans.push_back(report_scan(input.scans[i], result.scans[i]));
    }
    for (const auto& link : result.links) report.links.push_back(report_link(input, link));
    report_loops(report);
    report.notes.insert(report.notes.end(), result.notes.begin(), result.notes.end());
    return report;
}

} // namespace

std::string_view to_word(RegisterMethod method) noexcept {
    switch (method) {
    case RegisterMethod::Auto: return "auto";
    case RegisterMethod::Markers: return "markers";
    case RegisterMethod::Features: return "features";
    case RegisterMethod::Icp: return "icp";
    }
    return "";
}

std::optional<RegisterMethod> register_method_from_word(std::string_view word) noexcept {
    for (const auto method :
         {RegisterMethod::Auto, RegisterMethod::Markers, RegisterMethod::Features, RegisterMethod::Icp}) {
        if (to_word(method) == word) return method;
    }
    return std::nullopt;
}

RegistrationReport compute_registration(Project& project, const RegisterOptions& options, Progress& progress) {
    const ChainInput input = chain_input(project, options);
    const bool has_work =
        std::any_of(input.scans.begin(), input.scans.end(), [](const ChainScan& s) { return s.is_asked; });
    if (!has_work) {
        RegistrationReport nothing;
        nothing.method = std::string(to_word(options.method));
        nothing.notes = {"every scan is on the site grid already; --again places them anew, --day DAY those of a day"};
        return nothing;
    }
    const ChainResult result = run_chain(input, options, progress);
    return make_report(input, result, options);
}

RegistrationReport register_scans(Project& project, const RegisterOptions& options, Progress& progress) {
    RegistrationReport report = compute_registration(project, options, progress);
    if (!report.scans.empty()) keep_run(project, report, options.acceptance);
    return report;
}

} // namespace planum::app
