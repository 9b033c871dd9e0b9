// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "paint/poster_plan.hpp"
#include "strat/layout/drawing_words.hpp"

namespace planum::paint {

struct PdfOptions {
    PosterOptions poster;
    std::string site;
    std::string date; ///< for the title block, as the caller writes it
    strat::DrawingWords words;
    std::string created_at; ///< UTC as `2025-06-01T17:04:05…`; empty: 1970, so that equal drawings are equal files
};

/// The drawing as PDF: vectors and text, fonts embedded, every page with a title block. A poster of several sheets has
/// crop marks, says on each edge which sheet continues, and ends with a map of its sheets and an index of which unit is
/// on which. Throws as plan_poster does.
[[nodiscard]] std::string render_pdf(const strat::MatrixDrawing& drawing, const PdfOptions& options,
                                     Progress& progress);

} // namespace planum::paint
