// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/diagnostic.hpp"
#include "core/model/evidence.hpp"
#include "strat/matrix/harris_matrix.hpp"

namespace planum::app {

/// How the history calls the change that signs a day off.
inline constexpr std::string_view kSignOffLabel = "Sign the day off";

/// The evening's check: what is wrong and undecided, what was decided, how much could be judged.
struct DailyCheck {
    std::vector<model::Diagnostic> problems; ///< undecided; new since the last sign-off first
    std::set<std::string> new_ids;           ///< of them, those that were not there then
    std::vector<model::Diagnostic> accepted; ///< silent by a decision that still holds
    model::Coverage coverage;
    std::vector<model::EvidenceVerdict> verdicts; ///< what is said about each relation, by position in the record
    std::string signed_off_at;                    ///< empty: never
    std::string signed_off_by;

    [[nodiscard]] std::size_t count(model::Severity severity) const noexcept;
};

/// Checks the field record, or an interpretation of it by name. Never writes.
[[nodiscard]] DailyCheck check_project(Project& project, const std::string& interpretation, Progress& progress);

/// The same of a record in memory, without surfaces.
[[nodiscard]] DailyCheck check_record(const model::Record& record, Progress& progress);

/// The same of a record in memory, with what the surfaces say where that is at hand.
[[nodiscard]] DailyCheck check_record(const model::Record& record, std::span<const model::SurfaceEvidence> surfaces,
                                      Progress& progress);

/// The same with all that is measured.
[[nodiscard]] DailyCheck check_record(const model::Record& record, const model::Measurements& measured,
                                      Progress& progress);

/// Keeps a problem silent until its units or evidence change. Throws NotFound when no undecided problem has
/// the id, Usage without a reason.
void accept_problem(Project& project, std::string_view id, std::string_view because, Progress& progress);

/// Signs the day off by name: what is undecided now is no longer new tomorrow.
void sign_off(Project& project, Progress& progress);

/// The interpretation of that name, its parent, and so on to the root. A ring of parents, as another program may make
/// one, ends the walk. Throws NotFound.
[[nodiscard]] std::vector<const model::Interpretation*> lineage(const model::Record& record, const std::string& name);

/// The record as an interpretation reads it: relations of its parents, plus added, less dropped. An empty name
/// is the field record. Throws NotFound.
[[nodiscard]] model::Record interpreted(const model::Record& record, const std::string& interpretation);

} // namespace planum::app
