// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/model/diagnostic.hpp"
#include "core/model/interpretation.hpp"

namespace planum::strat {

/// A diagnostic beside what was decided about it.
struct ReviewedDiagnostic {
    model::Diagnostic diagnostic;
    bool accepted = false; ///< silent: somebody accepted it and nothing that matters has changed
    bool reopened = false; ///< was accepted, but units or a sign changed or its area grew by half
    bool is_new = true;    ///< was not there at the last sign-off, or was another then
    std::string because;   ///< the reason given when it was accepted
};

/// Sets the decisions beside the diagnostics; keeps their order. Of several decisions on one diagnostic
/// the last by time counts. Without a sign-off everything is new.
[[nodiscard]] std::vector<ReviewedDiagnostic> review(std::vector<model::Diagnostic> diagnostics,
                                                     std::span<const model::Decision> decisions);

/// The decision that keeps a diagnostic silent. Id, author and time are the caller's.
[[nodiscard]] model::Decision accept(const model::Diagnostic& diagnostic, std::string because);

/// What a sign-off writes: one decision of kind `sign-off` a diagnostic, all with the same time, and one
/// with an empty subject that marks the sign-off itself, so that an empty list can be signed off too.
[[nodiscard]] std::vector<model::Decision> sign_off(std::span<const model::Diagnostic> diagnostics,
                                                    const std::string& made_at);

/// Area a diagnostic's evidence covers [m²]; 0 when it is not about areas.
[[nodiscard]] double evidence_area(const model::Diagnostic& diagnostic) noexcept;

} // namespace planum::strat
