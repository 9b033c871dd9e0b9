// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "strat/layout/order_phase.hpp"

namespace planum::strat {

/// Moves single nodes along their levels. Keeps a reference: the graph must outlive it, and be changed by it alone.
class LevelSwitcher {
  public:
    explicit LevelSwitcher(LayeredGraph& graph);

    /// Towards `target`, another node of `level`, to the nearest place where no more edges cross than now. O(nodes
    /// passed × their edges × the node's).
    void draw_near(std::size_t level, std::uint32_t node, std::uint32_t target);

  private:
    void number(std::size_t level);
    [[nodiscard]] std::int64_t crossings(std::uint32_t left, std::uint32_t right) const;

    LayeredGraph& g_;
    Adjacency up_;
    Adjacency down_;
    std::vector<std::uint32_t> place_; // by node, within its level
};

/// Of each pair that stands on one level the node that has no edge goes beside the other one.
void draw_together(LayeredGraph& graph, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

} // namespace planum::strat
