// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strat/exchange/imported_record.hpp"

namespace planum::app {

/// Where a point was read from; says whether its name may be a code.
enum class PointSource {
    Table,   ///< a row: the code stands in its own column, a name is a name
    Drawing, ///< a point of a drawing: the text beside it may be code and number in one
    LoneText ///< a text of a drawing without a point: one only when it reads as a code with a number
};

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
    PointSource source = PointSource::Table;
};

struct SurveyFile {
    std::vector<SurveyPoint> points;
    std::vector<strat::ReadNote> notes;
};

} // namespace planum::app
