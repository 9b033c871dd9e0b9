// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/import/merge.hpp"
#include "app/project/project.hpp"
#include "app/survey/survey_point.hpp"

namespace planum::app {

struct SurveyOptions {
    std::filesystem::path codes; ///< table of codes; empty: the built-in ones
    std::string columns;         ///< of tables without headings
    std::string area;            ///< of units whose number alone is not unique
    std::string day;             ///< finds of the file were found on it
    bool create_units = false;
    bool update = false;
    bool dry_run = false;
};

struct SurveyReport {
    std::size_t points = 0;
    std::size_t new_levels = 0;
    std::size_t new_finds = 0;
    std::size_t changed_finds = 0;
    std::vector<std::string> new_units;
    std::map<std::string, std::size_t> other_codes; ///< codes that mean nothing here, and how often
    std::vector<strat::ReadNote> notes;
    std::vector<MergeConflict> conflicts;
    bool changed = false;
};

/// Takes the points of total stations (tables) and drawings (DXF) in as levels and finds, as one undo step. The same
/// file again changes nothing. A level needs a unit of the record: from its own column, the number behind its code, or
/// its point name up to the first `.`, `/` or `_`. Those of unknown units are noted with the numbers nearby, and stay
/// noted until the unit comes. Throws BadInput naming the file, Usage when `day` is no day.
SurveyReport import_survey(Project& project, const std::vector<std::filesystem::path>& files,
                           const SurveyOptions& options);

} // namespace planum::app
