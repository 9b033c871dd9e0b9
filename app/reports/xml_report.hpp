// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "app/reports/report_input.hpp"

namespace planum::app {

/// Namespace of schema/xsd/planum-report-1.xsd.
inline constexpr std::string_view kReportNamespace = "urn:planum:report:1";

/// The whole record as XML after schema/xsd/planum-report-1.xsd: project, units with their fields, relations
/// with their statements, orders, phases, finds, levels, diagnostics, decisions, coverage. UTF-8, ISO dates,
/// ids are uuids; the same input gives the same bytes.
[[nodiscard]] std::string write_xml_report(const ReportInput& input);

} // namespace planum::app
