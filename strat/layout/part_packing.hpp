// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace planum::strat {

/// A part of the matrix that no line joins to the others, and where it is put.
struct MatrixPart {
    struct Level {
        double left = 0.0; ///< of its leftmost node, from the part's own left side [pt]
        double right = 0.0;
    };

    std::vector<Level> levels; ///< top to bottom, each with at least one node
    double x = 0.0;            ///< result: its left side [pt]
    std::int32_t level = 0;    ///< result: its first level
};

/// Puts parts side by side in the given order, style::kComponentGap apart, each as far left as the outlines of those
/// before it leave room; where `free_levels`, on the level that widens the drawing least, the uppermost of these, with
/// a level of air above and below. Time: parts × levels of the deepest × levels of a part.
void pack_parts(std::vector<MatrixPart>& parts, bool free_levels);

} // namespace planum::strat
