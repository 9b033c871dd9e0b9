// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "strat/layout/drawing.hpp"

namespace planum::paint {

/// Paper; Fitted makes one page as large as the drawing.
enum class Paper { Fitted, A4, A3, A2, A1, A0 };

/// OnePage shrinks the drawing onto one sheet (never enlarges it); Poster keeps its scale and cuts it into
/// sheets.
enum class Paging { OnePage, Poster };

struct PosterOptions {
    Paper paper = Paper::A3;
    Paging paging = Paging::OnePage;
    double scale = 1.0; ///< of a poster
    double overlap =
        57.0; ///< [pt on paper] of neighbouring sheets: wider than a box, so that each box is whole somewhere
    double margin = 28.0; ///< [pt] that printers cannot use
};

/// One sheet of paper with the part of the drawing it shows.
struct Sheet {
    std::string name; ///< row letter and column number: `B3`
    std::size_t row = 0;
    std::size_t column = 0;
    strat::DrawRect part; ///< of the drawing [pt of the drawing], overlap included
};

/// Where each unit is found.
struct SheetEntry {
    std::string unit;
    std::string sheet; ///< the first on which the whole box is, else the first that shows any of it
};

struct PosterPlan {
    double page_width = 0.0; ///< [pt]
    double page_height = 0.0;
    double scale = 1.0;       ///< paper points per drawing point
    double title_block = 0.0; ///< its height at the foot of each page [pt]; a poster's has the legend in it
    strat::DrawRect content;  ///< on the page [pt]: where the part is painted
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<Sheet> sheets; ///< row by row; sheets that would be empty are left out
};

/// Height of the title block at the foot of each page, without a legend [pt].
inline constexpr double kTitleBlock = 34.0;

/// Chooses the orientation that needs fewer sheets (OnePage: less shrinking). Throws BadInput when the
/// scale is no positive number, the overlap leaves no room, or more than 2,000 sheets would be needed.
[[nodiscard]] PosterPlan plan_poster(const strat::MatrixDrawing& drawing, const PosterOptions& options);

/// Index of units by sheet, in natural order of their names.
[[nodiscard]] std::vector<SheetEntry> sheet_index(const strat::MatrixDrawing& drawing, const PosterPlan& plan);

/// `A`, `B`, …, `Z`, `AA`, ….
[[nodiscard]] std::string row_letters(std::size_t row);

} // namespace planum::paint
