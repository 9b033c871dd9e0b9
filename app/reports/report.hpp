// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "app/drawing/draw_matrix.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::app {

/// What a report is about. Empty strings: no such choice.
struct ReportRequest {
    std::string interpretation; ///< this reading instead of the field record
    std::string day;            ///< ISO: only what was dug, recorded, found or scanned on it, with what that touches
};

/// The words of a report to print, and the drawing that belongs to them.
struct PrintedReport {
    std::string html;
    DrawRequest drawing;
    bool has_drawing = true; ///< false: no unit to draw
};

/// Writes the report; the ending says which form: `.xml` (schema/xsd/planum-report-1.xsd) or `.html` (one page
/// for people, with the matrix drawn in it). Throws Usage for another ending or what is no day, NotFound for an unknown
/// interpretation or a day without work, Io. Never writes the project.
void write_report(Project& project, const std::filesystem::path& file, const ReportRequest& request,
                  const strat::TextMeasure& measure, Progress& progress);

/// The report as one HTML page to print, without the drawing: the words of `.pdf`, which paint lays out.
[[nodiscard]] PrintedReport printed_report(Project& project, const ReportRequest& request, Progress& progress);

} // namespace planum::app
