// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "scans/surface/layer_field.hpp"

namespace planum::scans {

struct PassingRules {
    double largest = 2.5;      ///< extent in plan of what may be a person, a barrow, a bucket [m]
    double seen_beneath = 0.5; ///< share of its cells in which another scan sees ground beneath
    double smallest = 0.15;    ///< what covers less and rises above all around is no ground [m²]
    double rises = 0.5;        ///< by so much [m]
    double ground = 0.5;       ///< what covers as much is ground [m²]
};

struct PassingReport {
    std::size_t specks = 0; ///< layers of a few points that hang together with nothing
    std::size_t things = 0; ///< what stood on the ground
    double area = 0.0;      ///< covered by them [m²]
};

/// Marks in the field what is no ground: specks (mixed pixels, strays), and what stood or passed there during some
/// scans only: layers that hang together, are no larger than `largest`, end free above the ground, and beneath most of
/// which another scan sees lower ground. Sides of pits and walls reach up to ground and stay; so do things on ground
/// that no scan sees, unless they are small and rise high. `marked` gets a value for each layer, by its number.
PassingReport mark_passing(const LayerField& field, const PassingRules& rules, std::vector<bool>& marked);

} // namespace planum::scans
