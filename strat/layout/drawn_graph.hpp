// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "strat/layout/layout_engine.hpp"

namespace planum::strat {

inline constexpr std::int32_t kNoBand = -1;

/// A box before it has a place: everything but x and y of its rectangle is final.
struct GraphBox {
    DrawnBox box;
    std::vector<UnitIndex> units;
    std::string name;             ///< of its first unit, as other texts call it
    std::int32_t band = kNoBand;  ///< position in DrawnGraph::bands
    std::int32_t group = kNoBand; ///< position in DrawnGraph::groups
    bool on_top = false;          ///< topsoil: belongs on the first level
    bool at_bottom = false;       ///< natural ground: belongs on the last level
    bool has_previous = false;
    DrawPoint previous; ///< centre in the earlier drawing
};

/// An order that shall be drawn, between positions in DrawnGraph::boxes.
struct GraphOrder {
    std::uint32_t later = 0;
    std::uint32_t earlier = 0;
    DrawnLine line;                  ///< everything but its points
    std::vector<DrawPoint> previous; ///< its points in the earlier drawing; empty: not there
};

struct GraphBand {
    std::string id;
    std::string heading;
    double width = 0.0; ///< of a group's heading, as measured [pt]
};

/// What is drawn, without places: boxes in natural order, the reduced orders between them.
struct DrawnGraph {
    std::string title;
    std::string subtitle;
    std::string description;
    DrawingWords words;
    std::vector<GraphBox> boxes;
    std::vector<GraphOrder> orders; ///< sorted by later, then earlier
    std::vector<Order> contemporaries;
    std::vector<GraphBand> bands; ///< latest first
    std::vector<GraphBand> groups;
};

/// Chooses boxes and orders for a request. Where units are left out, orders that hold by way of them
/// are drawn as `through`, reduced like all others. Throws NotFound for an unknown area or unit.
[[nodiscard]] DrawnGraph make_drawn_graph(const LayoutRequest& request);

/// The drawing with all boxes and lines of the graph, in its order, still at (0, 0) and without points.
[[nodiscard]] MatrixDrawing drawing_without_places(const DrawnGraph& graph);

} // namespace planum::strat
