// SPDX-License-Identifier: MIT
#pragma once

#include "strat/layout/layout_engine.hpp"

namespace planum::strat {

/// Our own engine. Its phases, each one call: rank_boxes, bundle_orders, place_on_levels (order and
/// coordinates), make_wires and route_channel. Promises what read_back checks: boxes do not overlap, no
/// line runs through a box, and the drawn lines state exactly the orders of the drawing.
class PlanumEngine final : public LayoutEngine {
  public:
    [[nodiscard]] std::string_view name() const noexcept override { return "planum"; }

    [[nodiscard]] MatrixDrawing draw(const LayoutRequest& request, Progress& progress) const override;
};

} // namespace planum::strat
