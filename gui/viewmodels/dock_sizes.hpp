// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>

namespace planum::gui {

/// How wide and high the panels around the middle of the window begin [px].
struct DockSizes {
    int units = 0; ///< width of the list at the left
    int card = 0;  ///< width of the record card at the right
    int below = 0; ///< height of problems and what stands beside them
};

/// From the font, so that as much can be read at any size of it: `digit` is the width of a digit, `line` the height of
/// a line [px]. Large letters in a small window leave the middle at least two fifths of its width and half of its
/// height.
[[nodiscard]] DockSizes dock_sizes(int digit, int line, QSize window);

} // namespace planum::gui
