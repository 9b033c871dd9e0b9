// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/layout/text_measure.hpp"

namespace planum::app {

/// Writes the report; the ending says which form: `.xml` (schema/xsd/planum-report-1.xsd) or `.html` (one page
/// for people, with the matrix drawn in it). Throws Usage for another ending, NotFound for an unknown
/// interpretation, Io. Never writes the project.
void write_report(Project& project, const std::filesystem::path& file, const std::string& interpretation,
                  const strat::TextMeasure& measure, Progress& progress);

/// The report as one HTML page to print, without the drawing: the words of `.pdf`, which paint lays out.
[[nodiscard]] std::string printed_report(Project& project, const std::string& interpretation, Progress& progress);

} // namespace planum::app
