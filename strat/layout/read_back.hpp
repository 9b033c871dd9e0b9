// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "strat/layout/drawing.hpp"

namespace planum::strat {

/// What a drawing states, read from its ink alone: boxes, straight strokes, junction dots.
struct ReadBack {
    struct Pair {
        std::size_t later = 0; ///< positions in MatrixDrawing::boxes
        std::size_t earlier = 0;

        friend auto operator<=>(const Pair&, const Pair&) = default;
    };

    std::vector<Pair> orders; ///< sorted, distinct
    /// What is wrong with the drawing itself, in sentences: boxes that overlap, a line through a box, a
    /// slanting stroke, a place that is no number, an end that hangs in the air. Empty: none.
    std::vector<std::string> faults;
};

/// Reads as a strict reader would. Strokes that overlap are one stroke. Two strokes that meet belong
/// together where one of them ends, and where both go on only if a dot says so. Of all that belongs
/// together, every box touched at its lower edge is later than every box touched at its upper edge.
/// Nothing else of the drawing is looked at, above all not which order a line was drawn for.
[[nodiscard]] ReadBack read_back(const MatrixDrawing& drawing);

} // namespace planum::strat
