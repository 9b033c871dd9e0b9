// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "strat/layout/drawing.hpp"

class QPrinter;
class QWidget;

namespace planum::gui {

class MatrixView;

/// What the view shows, in a preview in which paper, direction and printer are chosen, then printed or written as PDF.
/// Nothing as long as there is no drawing.
void print_matrix(const MatrixView& view, QWidget* parent);

/// Pages beside and below one another that the drawing needs on paper of this size [pt]: one where its words stay
/// readable on it (9 pt become no less than 5), else so many that they do.
struct PrintPages {
    int across = 1;
    int down = 1;
    double scale = 1.0; ///< of the drawing
};

[[nodiscard]] PrintPages pages_for(double drawing_width, double drawing_height, double page_width, double page_height);

/// Paints it on the pages of a printer, neighbours overlapping by 12 pt.
void print_drawing(const strat::MatrixDrawing& drawing, QPrinter& printer);

} // namespace planum::gui
