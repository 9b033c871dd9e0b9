// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "app/survey/survey_point.hpp"

namespace planum::app {

/// Reads measured points from a table: comma, semicolon, tab, bar or blanks. With a row of headings in any of four
/// languages the order is free; without one it is `columns`, by default `name,x,y,z,code`. Rows without
/// coordinates become notes. Throws BadInput when there is no point at all, or a column is unknown or missing.
[[nodiscard]] SurveyFile read_survey_csv(std::string_view bytes, std::string_view file_name, std::string_view columns);

} // namespace planum::app
