// SPDX-License-Identifier: MIT
#include "app/checks/daily_check.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/evidence/section_evidence.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/checks/check.hpp"
#include "strat/checks/decisions.hpp"

namespace planum::app {

namespace {

strat::CheckResult run_checks(const model::Record& record, std::span<const model::SurfaceEvidence> surfaces,
                              std::span<const model::GroundAlteration> alterations,
                              std::span<const model::OutlineOverlap> overlaps, Progress& progress) {
    progress.step("building the matrix");
    const auto matrix = strat::HarrisMatrix::build(record);
    progress.step("checking");
    return strat::check(record, matrix, strat::CheckOptions{}, surfaces, progress, alterations, overlaps);
}

const model::Decision* last_sign_off(const model::Record& record) {
    const model::Decision* last = nullptr;
    for (const model::Decision& decision : record.decisions) {
        if (decision.kind == "sign-off" && (last == nullptr || decision.made_at >= last->made_at)) last = &decision;
    }
    return last;
}

DailyCheck reviewed(strat::CheckResult result, const model::Record& record) {
    DailyCheck check;
    check.coverage = std::move(result.coverage);
    check.verdicts = std::move(result.verdicts);
    if (const model::Decision* signed_off = last_sign_off(record)) {
        check.signed_off_at = signed_off->made_at;
        check.signed_off_by = signed_off->author;
    }
    for (strat::ReviewedDiagnostic& one : strat::review(std::move(result.diagnostics), record.decisions)) {
        if (one.accepted) {
            check.accepted.push_back(std::move(one.diagnostic));
            continue;
        }
        // Before the first sign-off everything is new, so the word would say nothing.
        if (one.is_new && !check.signed_off_at.empty()) check.new_ids.insert(one.diagnostic.id);
        check.problems.push_back(std::move(one.diagnostic));
    }
    std::stable_partition(check.problems.begin(), check.problems.end(),
                          [&](const model::Diagnostic& d) { return check.new_ids.contains(d.id); });
    return check;
}

// As people name the problem: by its check and the units it is about.
std::string acceptance_label(Project& project, const model::Diagnostic& problem) {
    constexpr std::size_t kNamed = 4;
    std::vector<std::string> units;
    for (const model::UnitId unit : problem.units) {
        if (units.size() < kNamed) units.push_back(project.index().name(unit));
    }
    if (units.empty()) return "Accept problem " + problem.code;
    const std::size_t more = problem.units.size() - units.size();
    return fmt::format("Accept problem {} of {}{}", problem.code, text::join(units, ", "),
                       more == 0 ? "" : fmt::format(" and {} more", more));
}

} // namespace

DailyCheck check_record(const model::Record& record, std::span<const model::SurfaceEvidence> surfaces,
                        Progress& progress) {
    return reviewed(run_checks(record, surfaces, {}, {}, progress), record);
}

DailyCheck check_record(const model::Record& record, const model::Measurements& measured, Progress& progress) {
    return reviewed(run_checks(record, measured.pairs, measured.alterations, measured.overlaps, progress), record);
}

DailyCheck check_record(const model::Record& record, Progress& progress) {
    return reviewed(run_checks(record, {}, {}, {}, progress), record);
}

std::size_t DailyCheck::count(model::Severity severity) const noexcept {
    return static_cast<std::size_t>(std::count_if(problems.begin(), problems.end(),
                                                  [&](const model::Diagnostic& d) { return d.severity == severity; }));
}

DailyCheck check_project(Project& project, const std::string& interpretation, Progress& progress) {
    const model::Measurements measured = measured_evidence(project, progress);
    if (interpretation.empty()) return check_record(project.record(), measured, progress);
    return check_record(interpreted(project.record(), interpretation), measured, progress);
}

void accept_problem(Project& project, std::string_view id, std::string_view because, Progress& progress) {
    if (text::trim(because).empty()) {
        throw Error(ErrorCode::Usage, "a problem is accepted with a reason: --accept ID --because TEXT");
    }
    const DailyCheck check = check_project(project, {}, progress);
    const auto it = std::find_if(check.problems.begin(), check.problems.end(),
                                 [&](const model::Diagnostic& d) { return d.id == id; });
    if (it == check.problems.end()) {
        throw Error(ErrorCode::NotFound,
                    fmt::format("no undecided problem has the id {}; planum check lists them", id));
    }
    model::Decision decision = strat::accept(*it, std::string(text::trim(because)));
    decision.author = project.author();
    decision.made_at = project.clock().now();
    project.change(acceptance_label(project, *it), [&] { project.file().insert(decision); });
}

void sign_off(Project& project, Progress& progress) {
    const DailyCheck check = check_project(project, {}, progress);
    std::vector<model::Decision> decisions = strat::sign_off(check.problems, project.clock().now());
    project.change(kSignOffLabel, [&] {
        for (model::Decision& decision : decisions) {
            decision.author = project.author();
            project.file().insert(decision);
        }
    });
}

} // namespace planum::app
