// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "core/model/record.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

/// What a day's report is about: the units worked on that day, and of the rest of the record only what they touch.
struct DaysRecord {
    model::Record record; ///< those units, the units their relations and problems name, and what belongs to the former
    std::unordered_set<model::UnitId> units; ///< worked on that day
    std::vector<std::uint32_t> orders;       ///< immediate orders of the whole matrix that touch one of them
};

/// Units worked on that day [ISO]: begun, in work, finished or recorded on it, outlined on one of its surfaces, named
/// by a relation entered by hand, or with a find or document of the day.
[[nodiscard]] std::unordered_set<model::UnitId> units_of_day(const model::Record& record, const std::string& day);

/// Keeps of the problems those that name a unit of the day, or, naming none, a scan of the day.
void keep_problems_of_day(std::vector<model::Diagnostic>& problems, const std::unordered_set<model::UnitId>& units,
                          const std::string& day);

/// The part of a record that a day's report prints. `problems` are those the report will show: the units and
/// relations they name stay in the record. Throws NotFound when nothing at all was recorded that day, naming the last
/// day before it that has something.
[[nodiscard]] DaysRecord days_record(const model::Record& whole, const strat::HarrisMatrix& matrix,
                                     const std::string& day, const std::vector<model::Diagnostic>& problems);

} // namespace planum::app
