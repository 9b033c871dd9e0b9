// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/demo/simulator.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::app {

/// What the demo made, and what the job on it came to.
struct DemoJob {
    std::filesystem::path project;               ///< from the sheets as they should be
    std::filesystem::path mistaken_project;      ///< from the copy with mistakes
    std::vector<std::filesystem::path> drawings; ///< to look at
    std::size_t units = 0;
    std::size_t scans = 0;
    std::int64_t points = 0;
    std::size_t registered = 0; ///< scans on the site grid
    std::size_t regions = 0;    ///< outlines taken in
    std::size_t mistakes = 0;
    std::size_t errors = 0; ///< what check says about the sheets as they should be
    std::size_t warnings = 0;
    std::size_t errors_mistaken = 0; ///< and about the copy with mistakes
    std::size_t warnings_mistaken = 0;
};

/// Throws Io, with both sizes, when `available` bytes of disk do not hold a dig of this size with its projects: about
/// 100 MB when small, 600 MB when medium, 12 GB when large. Filling the disk would take minutes, and others' work with
/// it.
void require_room_for_demo(demo::DemoSize size, std::uintmax_t available);

/// Simulates a dig, writes it into `folder` (see demo::write_demo) and runs the job on it: a project from the
/// sheets with the scans, markers and outlines, one from the copy with mistakes that takes the same scans over, both
/// checked; matrix.svg, report.html, report.xml and panorama.png of the first. The scans of a small dig are registered;
/// larger ones take minutes, which are left to the user. Throws Conflict when the folder is not empty,
/// Io when the disk has not room enough (see require_room_for_demo), before anything is made.
[[nodiscard]] DemoJob run_demo_job(const std::filesystem::path& folder, const demo::SimulationOptions& options,
                                   const Session& session, const strat::TextMeasure& measure, Progress& progress);

} // namespace planum::app
