// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/reports/report_input.hpp"

namespace planum::app {

/// A screen shows links and the drawing; paper is laid out by Qt, whose rich text knows few styles and no SVG.
enum class HtmlFor { Screen, Paper };

/// One HTML page for people: problems with their suspects, coverage, the matrix, then a sheet a unit with its
/// relations, levels and finds, linked to each other. No script, nothing from outside; text is escaped.
[[nodiscard]] std::string write_html_report(const ReportInput& input, HtmlFor medium);

} // namespace planum::app
