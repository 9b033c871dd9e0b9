// SPDX-License-Identifier: MIT
#include "app/registration/registration_runs.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/registration/markers.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/geometry/rigid.hpp"

namespace planum::app {

namespace {

std::string next_name(const model::Record& record) {
    long long highest = 0;
    for (const auto& run : record.runs) highest = std::max(highest, text::parse_integer(run.name).value_or(0));
    return std::to_string(highest + 1);
}

const model::RegistrationRun& run_named(const model::Record& record, std::string_view name) {
    for (const auto& run : record.runs) {
        if (run.state != kSurveyState && run.name == name) return run;
    }
    const auto names = run_names(record);
    throw Error(ErrorCode::NotFound,
                names.empty() ? "there is no registration run yet: planum register SITE"
                              : fmt::format("no registration run {}; there are {}", name, text::join(names, ", ")));
}

RegistrationReport set_state(Project& project, std::string_view name, const std::string& state,
                             std::string_view label) {
    model::RegistrationRun run = run_named(project.record(), name);
    const auto& runs = project.record().runs;
    const bool is_last = std::none_of(runs.begin(), runs.end(), [&](const model::RegistrationRun& other) {
        return other.state == state && other.id != run.id && other.made_at > run.made_at;
    });
    if (run.state == state && (state != "accepted" || is_last))
        throw Error(ErrorCode::Conflict, fmt::format("registration run {} is {} already", name, state));
    RegistrationReport report = registration_report(run.report);
    report.state = state;
    run.state = state;
    run.report = to_json(report).dump();
    // Of several accepted runs the one made last holds: accepting an older one again makes it the last.
    if (state == "accepted") run.made_at = project.clock().now();
    project.change(fmt::format("{} registration run {}", label, name), [&] { project.file().update(run); });
    return report;
}

std::string reason_to_wait(const RegistrationReport& report, Acceptance acceptance) {
    if (acceptance == Acceptance::Never) return "proposed only, as asked";
    std::vector<std::string> poor;
    std::size_t placed = 0;
    for (const auto& scan : report.scans) {
        placed += scan.site_from_scan ? 1U : 0U;
        if (scan.is_poor) poor.push_back(scan.scan);
    }
    if (placed == 0) return "nothing was placed";
    if (poor.empty()) return {};
    return fmt::format("{} of {} scans are placed poorly ({})", poor.size(), placed, text::join(poor, ", "));
}

void note_state(RegistrationReport& report, Acceptance acceptance) {
    const std::string reason = reason_to_wait(report, acceptance);
    report.state = reason.empty() ? "accepted" : "proposed";
    if (reason.empty()) return;
    report.notes.push_back(
        fmt::format("the run is not in force: {}; planum register SITE --accept {} puts it in force, "
                    "--discard {} drops it",
                    reason, report.run, report.run));
}

std::map<std::string, ReportedScan> placed_in(const RegistrationReport& report) {
    std::map<std::string, ReportedScan> placed;
    for (const auto& scan : report.scans) {
        if (scan.site_from_scan) placed[scan.scan] = scan;
    }
    return placed;
}

} // namespace

std::vector<std::string> run_names(const model::Record& record) {
    std::vector<std::string> names;
    for (const auto& run : record.runs) {
        if (run.state != kSurveyState) names.push_back(run.name);
    }
    std::sort(names.begin(), names.end(), text::NaturalLess{});
    return names;
}

void keep_run(Project& project, RegistrationReport& report, Acceptance acceptance) {
    const model::Record& record = project.record();
    report.run = next_name(record);
    note_state(report, acceptance);
    model::RegistrationRun run;
    run.name = report.run;
    run.made_at = project.clock().now();
    run.method = report.method;
    run.state = report.state;
    run.report = to_json(report).dump();
    std::vector<model::ScanPose> poses;
    for (const auto& scan : report.scans) {
        if (!scan.site_from_scan) continue;
        const auto it = std::find_if(record.scans.begin(), record.scans.end(),
                                     [&](const model::Scan& s) { return s.name == scan.scan; });
        if (it == record.scans.end()) {
            throw Error(ErrorCode::Conflict,
                        fmt::format("scan {} was removed while it was registered; nothing was kept", scan.scan));
        }
        poses.push_back({it->id, {}, *scan.site_from_scan, scan.covariance, scan.rms, scan.overlap, scan.verdict});
    }
    project.change(fmt::format("Register {} scans", poses.size()), [&] {
        const model::RegistrationRunId id = project.file().insert(run);
        for (auto& pose : poses) {
            pose.run = id;
            project.file().insert(pose);
        }
    });
}

RegistrationReport accept_run(Project& project, std::string_view name) {
    return set_state(project, name, "accepted", "Accept");
}

RegistrationReport discard_run(Project& project, std::string_view name) {
    return set_state(project, name, "discarded", "Discard");
}

RunComparison compare_runs(Project& project, std::string_view first, std::string_view second) {
    const auto in_first = placed_in(registration_report(run_named(project.record(), first).report));
    const auto in_second = placed_in(registration_report(run_named(project.record(), second).report));
    std::map<std::string, ComparedScan, text::NaturalLess> compared;
    for (const auto& [name, scan] : in_first) {
        compared[name].in_first = true;
        compared[name].sigma_first = scan.sigma_position;
    }
    for (const auto& [name, scan] : in_second) {
        ComparedScan& both = compared[name];
        both.in_second = true;
        both.sigma_second = scan.sigma_position;
        if (!both.in_first) continue;
        const auto step = geometry::step_between(geometry::from_row_major(*in_first.at(name).site_from_scan),
                                                 geometry::from_row_major(*scan.site_from_scan));
        both.shift = step.tail<3>().norm();
        both.turn_deg = step.head<3>().norm() * 180.0 / std::numbers::pi;
    }
    RunComparison comparison{std::string(first), std::string(second), {}};
    for (auto& [name, scan] : compared) {
        scan.scan = name;
        comparison.scans.push_back(scan);
    }
    return comparison;
}

} // namespace planum::app
