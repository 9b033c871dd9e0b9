// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "app/registration/register_scans.hpp"
#include "app/registration/registration_report.hpp"

namespace planum::app {

/// Keeps a report and its poses as a run, as one undo step; fills the report's `run`, `state` and a note that says
/// why the state is what it is. Throws Conflict when a scan that was placed is no longer in the project.
void keep_run(Project& project, RegistrationReport& report, Acceptance acceptance);

/// The run's poses hold from now on. Throws NotFound (with the runs there are) or Conflict.
[[nodiscard]] RegistrationReport accept_run(Project& project, std::string_view name);

/// The run's poses hold no longer; those of an earlier accepted run do again.
[[nodiscard]] RegistrationReport discard_run(Project& project, std::string_view name);

/// The names of all runs, in natural order.
[[nodiscard]] std::vector<std::string> run_names(const model::Record& record);

/// One scan in two runs.
struct ComparedScan {
    std::string scan;
    bool in_first = false;
    bool in_second = false;
    double shift = 0.0;       ///< of the scanner from first to second [m]
    double turn_deg = 0.0;    ///< between both
    double sigma_first = 0.0; ///< [m]
    double sigma_second = 0.0;
};

struct RunComparison {
    std::string first;
    std::string second;
    std::vector<ComparedScan> scans;
};

/// Throws NotFound.
[[nodiscard]] RunComparison compare_runs(Project& project, std::string_view first, std::string_view second);

} // namespace planum::app
