// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/progress.hpp"
#include "core/model/diagnostic.hpp"
#include "core/model/evidence.hpp"
#include "core/model/record.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::strat {

struct CheckOptions {
    bool with_infos = true;            ///< isolated units, redundant relations
    std::size_t alike_become_one = 20; ///< more infos than this with one code become one
    double near = 0.5;                 ///< points this close in plan are compared directly [m]
    std::size_t exact_up_to = 20;      ///< nodes of a cycle group whose suspects are found exactly
    std::size_t suspects_shown = 12;   ///< at most this many beyond the set that breaks all cycles
};

struct CheckResult {
    std::vector<model::Diagnostic> diagnostics; ///< errors first, then by code and units
    model::Coverage coverage;
    std::vector<model::EvidenceVerdict> verdicts; ///< by position in record.relations
};

/// Everything the record itself contradicts, without scans of its own; `surfaces` may add what scans
/// say about pairs, `alterations` where ground rose or scans of one surface disagree, `overlaps` where outlines do.
/// `merged` is the matrix of the same record with same_as merged. Result and order do not depend on the order of the
/// input. O((units + relations) log units) apart from cycle groups. Throws Error{Cancelled} when asked to stop.
[[nodiscard]] CheckResult check(const model::Record& record, const HarrisMatrix& merged, const CheckOptions& options,
                                std::span<const model::SurfaceEvidence> surfaces, Progress& progress,
                                std::span<const model::GroundAlteration> alterations = {},
                                std::span<const model::OutlineOverlap> overlaps = {});

/// One code and what it means; docs/checks.md and the help are made from the same table.
struct CheckCode {
    std::string_view code;
    model::Severity severity = model::Severity::Warning;
    std::string_view rule;
};

/// Every code check() can say, in the order of the table in check.cpp.
[[nodiscard]] std::span<const CheckCode> all_check_codes() noexcept;

} // namespace planum::strat
