// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "core/model/record.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

/// All that a report is made from; gathered once, so that every form of the report says the same.
struct ReportInput {
    const model::Record* record = nullptr;
    const strat::HarrisMatrix* matrix = nullptr;
    std::vector<model::Diagnostic> diagnostics; ///< undecided ones
    std::vector<model::Diagnostic> accepted;    ///< kept silent by a decision
    model::Coverage coverage;
    std::string made_at; ///< ISO time
    std::string made_by;
    std::string interpretation; ///< empty: the field record
    std::string drawing_svg;    ///< the matrix as SVG, for HTML; empty: none
};

} // namespace planum::app
