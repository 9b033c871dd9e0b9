// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strat/exchange/imported_record.hpp"

namespace planum::app {

/// One measured point as a total station or a drawing has it; site grid [m].
struct SurveyPoint {
    std::string name; ///< point number
    std::string code; ///< `TOP`, `TOP 1042`, `FIND`; layer or block of a drawing
    std::string unit; ///< where a column or an attribute says it
    std::string find; ///< likewise
    std::string text; ///< description
    double x = 0.0;
    double y = 0.0;
    std::optional<double> z;
    std::int64_t line = 0; ///< in the file, from 1
};

struct SurveyFile {
    std::vector<SurveyPoint> points;
    std::vector<strat::ReadNote> notes;
};

} // namespace planum::app
