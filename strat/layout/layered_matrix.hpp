// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.hpp"
#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/net_phase.hpp"
#include "strat/layout/rank_phase.hpp"

namespace planum::strat {

/// The matrix on its levels: boxes, and a node wherever a line passes a level.
struct LayeredMatrix {
    static constexpr std::uint32_t kNoBox = static_cast<std::uint32_t>(-1);

    static constexpr std::uint32_t kNoNet = static_cast<std::uint32_t>(-1);

    struct Node {
        std::int32_t level = 0;
        std::uint32_t box = kNoBox; ///< kNoBox: a line passes, or a frame's heading or empty level
        std::uint32_t net = 0;      ///< of the line; kNoNet: no line
        double x = 0.0;             ///< centre [pt]
        std::int32_t group = -1;    ///< the frame it stands in, a position in DrawnGraph::groups
        double width = 0.0;         ///< of a heading [pt]
    };

    /// The rectangle that a group has to itself.
    struct Frame {
        std::int32_t group = 0;
        double left = 0.0; ///< [pt]
        double right = 0.0;
        std::int32_t first_level = 0;
        std::int32_t last_level = 0;
    };

    /// A piece of a net's line between a level and the next.
    struct Piece {
        std::uint32_t upper = 0; ///< nodes
        std::uint32_t lower = 0;
        std::uint32_t net = 0;

        friend auto operator<=>(const Piece&, const Piece&) = default;
    };

    /// The line of one order as it passes the levels. Ordinary lines run from the later box down; those
    /// drawn upwards go out below their later box, up beside it, and into their earlier box from above.
    struct Path {
        std::vector<std::uint32_t> nodes; ///< from the later box to the earlier one
        std::uint32_t net = 0;
        bool upwards = false;
    };

    std::vector<Node> nodes;                        ///< the boxes first, isolated ones included
    std::vector<Piece> pieces;                      ///< sorted, distinct
    std::vector<Path> paths;                        ///< by order
    std::vector<std::vector<std::uint32_t>> levels; ///< left to right
    std::vector<std::int32_t> band_begin;           ///< see Ranking
    std::vector<Frame> frames;                      ///< in the order of the groups
};

/// Second and third phase for each component apart, and the components put side by side or, where there is
/// room and no bands, below one another.
[[nodiscard]] LayeredMatrix place_on_levels(const DrawnGraph& graph, const Ranking& ranking,
                                            const std::vector<Net>& nets, Progress& progress);

} // namespace planum::strat
