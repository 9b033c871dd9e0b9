// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "strat/layout/channel_router.hpp"
#include "strat/layout/layered_matrix.hpp"

namespace planum::strat {

/// The wires of one channel with what their ends belong to.
struct ChannelWires {
    struct End {
        std::uint32_t node = 0;
        double x = 0.0; ///< [pt]
    };

    struct ChannelWire {
        std::uint32_t net = 0;
        std::vector<End> tops;    ///< nodes of the level above, by node
        std::vector<End> bottoms; ///< nodes of the level below
    };

    std::vector<ChannelWire> wires;
};

/// Channel c lies above level c; the last lies below all levels. Collects each channel's wires (connected
/// pieces of one net) and decides where they leave and enter their boxes: straight down where they can,
/// else in the order of where they go, style::kPortGap apart.
[[nodiscard]] std::vector<ChannelWires> make_wires(const LayeredMatrix& matrix, const DrawnGraph& graph);

/// Least width [pt] of each box for as many lines as leave or enter it.
void widen_for_ports(DrawnGraph& graph, const std::vector<Net>& nets);

} // namespace planum::strat
