// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/progress.hpp"
#include "strat/layout/drawing.hpp"

namespace planum::paint {

/// A report to print: the words as HTML (headings, paragraphs, lists, tables), then the matrix on a page of its own.
struct ReportPdf {
    std::string html;
    const strat::MatrixDrawing* drawing = nullptr; ///< none: words only
    std::string site;                              ///< at the foot of every page
    std::string date;                              ///< as the caller writes it
};

/// A4 pages of words with a foot; the matrix upright or across on the smallest paper from A4 to A0 that shows it at 60
/// % or more. The same report gives the same bytes.
[[nodiscard]] std::string render_report_pdf(const ReportPdf& report, Progress& progress);

} // namespace planum::paint
