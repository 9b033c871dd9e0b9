// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/evidence/evidence.hpp"
#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "core/model/suggestion.hpp"

namespace planum::app {

/// A surface with outlines from which nothing, or less than all, could be concluded.
struct UnusedSurface {
    std::string surface; ///< its name
    std::string why;

    friend bool operator==(const UnusedSurface&, const UnusedSurface&) = default;
};

struct SuggestionList {
    std::vector<model::Suggestion> suggestions;
    std::vector<UnusedSurface> unused;
    std::size_t compared = 0;     ///< pairs of successive surfaces
    std::size_t without_kind = 0; ///< outlined units of which nobody said what they are: less is concluded of them
};

/// All that the surfaces propose: open ones first, relations before questions, the largest contacts first. Questions
/// that the record answers already are left out. Never writes the project.
[[nodiscard]] SuggestionList list_suggestions(Project& project, Progress& progress);

/// The same from evidence that is at hand.
[[nodiscard]] std::vector<model::Suggestion> suggestions_from(Project& project,
                                                              const std::vector<AreaEvidence>& evidence);

/// Whether a surface of that day takes part.
[[nodiscard]] bool concerns_day(const model::Record& record, const model::Suggestion& suggestion, std::string_view day);

/// Takes proposed relations into the record, each as a statement of its own with the reason for a raw text; one undo
/// step. Throws NotFound for an id that no open suggestion has, Conflict for a question, which is answered by
/// stating the relation.
void accept_suggestions(Project& project, std::span<const std::string> ids, Progress& progress);

/// Keeps suggestions silent until their area grows by half. Throws NotFound, Usage without a reason.
void reject_suggestions(Project& project, std::span<const std::string> ids, std::string_view because,
                        Progress& progress);

/// Makes an interpretation of that name, a reading of the field record from scans and outlines alone: it has all
/// proposed relations that are not rejected, and no other. Returns how many. Throws Conflict when the name is taken or
/// nothing is proposed.
std::size_t compile_interpretation(Project& project, const std::string& name, Progress& progress);

} // namespace planum::app
