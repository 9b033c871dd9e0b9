// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"
#include "strat/layout/layout_engine.hpp"

namespace planum::app {

/// What of a project's matrix is drawn. Empty strings: no such choice.
struct DrawRequest {
    std::string engine; ///< `planum` or `graphviz`; empty: the default
    std::string interpretation;
    std::string compared_with; ///< another interpretation, `record` for the field record: only what differs
    std::string area;
    std::string around; ///< a unit
    int around_steps = 2;
    std::vector<model::UnitId> only; ///< these units; empty: all
    std::string only_what;           ///< what they are, for the subtitle
    std::string fold;                ///< `phases`, `periods` or `groups`
    bool frames = false;             ///< around the units of top-level groups
    std::string bands;               ///< `phases`, `periods` or `none`; empty: where most units have one
    std::string since;               ///< ISO day: only what was added, removed or changed since, marked
    bool problems_only = false;      ///< units with errors or warnings about their relations
    bool evidence = false;           ///< lines look as what the surfaces, finds and dates say of them
    bool titles = false;             ///< short definitions below the numbers
    std::string language;            ///< of the drawing's own words: `en`, `de`; empty: English
    std::string unit_link; ///< where a unit leads to in SVG, with `{unit}` or `{uuid}` in it (strat::unit_link_of)
    std::filesystem::path keep_places;   ///< an earlier drawing (SVG) to move as little from as can be; empty: none
    std::filesystem::path layout_worker; ///< program that runs Graphviz in a child; empty: our own
};

/// Draws it. Throws NotFound for an area, unit or interpretation that is not there, Usage for unknown words,
/// and what the engine throws.
[[nodiscard]] strat::MatrixDrawing draw_matrix(Project& project, const DrawRequest& request,
                                               const strat::TextMeasure& text, Progress& progress);

/// Counts of the matrix (docs/matrix.md).
[[nodiscard]] strat::MatrixStats matrix_stats(Project& project, const std::string& interpretation);

} // namespace planum::app
