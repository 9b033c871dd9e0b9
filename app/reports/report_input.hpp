// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "core/model/record.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

/// All that a report is made from; gathered once, so that every form of the report says the same.
struct ReportInput {
    const model::Record* record = nullptr;       ///< what is printed: all, or what a day touched
    const model::Record* whole = nullptr;        ///< what the matrix was built of
    const strat::HarrisMatrix* matrix = nullptr; ///< of the whole
    std::vector<std::uint32_t> orders;           ///< immediate orders to print, by their place in the matrix
    std::string day;                             ///< ISO; empty: the whole record
    std::unordered_set<model::UnitId> of_day;    ///< units worked on that day; the others only stand beside them
    std::vector<model::Diagnostic> diagnostics;  ///< undecided ones
    std::vector<model::Diagnostic> accepted;     ///< kept silent by a decision
    model::Coverage coverage;
    std::string made_at; ///< ISO time
    std::string made_by;
    std::string interpretation; ///< empty: the field record
    std::string drawing_svg;    ///< the matrix as SVG, for HTML; empty: none
};

} // namespace planum::app
