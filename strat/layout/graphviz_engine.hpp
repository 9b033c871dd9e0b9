// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "strat/layout/layout_engine.hpp"
#include "strat/layout/layout_worker.hpp"

namespace planum::strat {

/// Automatic: orthogonal up to some hundred orders, polylines beyond, where Graphviz's orthogonal router
/// takes minutes.
enum class GraphvizLines { Automatic, Orthogonal, Polyline };

struct GraphvizOptions {
    std::filesystem::path executable = "/proc/self/exe"; ///< must call run_layout_worker_if_asked in main
    GraphvizLines lines = GraphvizLines::Automatic;
    WorkerLimits limits;
};

/// Graphviz's `dot` behind our interface: its places and lines as they are, without bands and frames, and
/// without the promise that shared lines state nothing false. For comparison; our own engine is the
/// default.
class GraphvizEngine final : public LayoutEngine {
  public:
    explicit GraphvizEngine(GraphvizOptions options = {}) : options_(std::move(options)) {}

    [[nodiscard]] std::string_view name() const noexcept override { return "graphviz"; }

    /// Throws as run_layout_worker does.
    [[nodiscard]] MatrixDrawing draw(const LayoutRequest& request, Progress& progress) const override;

  private:
    GraphvizOptions options_;
};

} // namespace planum::strat
