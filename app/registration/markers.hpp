// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/record.hpp"
#include "scans/registration/markers.hpp"

namespace planum::app {

/// The state of the run that holds the surveyed markers; no other run has it.
inline constexpr std::string_view kSurveyState = "survey";

/// All markers of a project: as surveyed, and as each scan measured them (by the name of the scan).
struct MarkerTable {
    std::vector<scans::Marker> survey;
    std::map<std::string, std::vector<scans::Marker>> in_scan;

    [[nodiscard]] std::size_t size() const;
};

/// The table of a CSV with the columns `scan,marker,x,y,z` in any order, rows of scan `site` being the survey; commas,
/// semicolons or tabs between, decimal commas where those do not separate. Throws BadInput with file and line.
[[nodiscard]] MarkerTable read_markers(const std::filesystem::path& file);

/// The markers that were imported.
[[nodiscard]] MarkerTable project_markers(const model::Record& record);

} // namespace planum::app
