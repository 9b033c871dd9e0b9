// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/layout/layout_engine.hpp"

namespace planum::strat {

/// Which nodes of the matrix become which box, and the orders left between the boxes.
struct Selection {
    static constexpr std::uint32_t kLeftOut = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> box_of; ///< by node; kLeftOut where it is not drawn
    std::uint32_t box_count = 0;
    std::vector<std::int32_t> folded; ///< by box: position of the phase, period or group it stands for, or -1

    struct Pair {
        std::uint32_t later = 0;
        std::uint32_t earlier = 0;
        bool in_cycle = false;
        bool through = false; ///< only by way of units that are left out
        friend bool operator==(const Pair&, const Pair&) = default;
    };

    std::vector<Pair> pairs; ///< reduced, sorted
};

/// Applies area, around, only and fold. Throws NotFound for an unknown area or unit.
[[nodiscard]] Selection select(const LayoutRequest& request);

/// Position of a unit's phase (Phases), period (Periods: its own, else its phase's) or top-level group
/// (Groups) in the record's lists, -1 without one.
[[nodiscard]] std::vector<std::int32_t> fold_keys(const model::Record& record, Fold fold);

} // namespace planum::strat
