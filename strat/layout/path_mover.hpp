// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "strat/layout/order_phase.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

/// Part of the second phase. A path is a run of nodes with at most one neighbour above and one below each: a
/// long line, a chain of boxes, or both in turn. Sweeps move one node at a time and leave such runs where the
/// first sweep put them; this takes a whole run out of its levels and puts it back where it crosses least, by
/// dynamic programming over the gaps of each level: exact within `reach` places on either side.
class PathMover {
  public:
    /// All must outlive the mover; `position` is each node's place in its level and is kept up to date.
    PathMover(LayeredGraph& graph, const Adjacency& up, const Adjacency& down, std::vector<std::uint32_t>& position,
              const std::vector<std::uint32_t>& layer);

    /// Moves every path that crosses less elsewhere. Returns how many crossings that saved. `work` grows by the
    /// steps spent; nothing more is moved once it reaches `most_work`.
    std::int64_t improve(std::int64_t& work, std::int64_t most_work);

  private:
    // Gaps of one level that a path may pass: gap p is left of the p-th node, the path's own taken out.
    struct Window {
        std::int32_t own = 0; ///< where the path passes now
        std::int32_t low = 0;
        std::int32_t high = 0;

        [[nodiscard]] std::size_t width() const noexcept { return static_cast<std::size_t>(high - low + 1); }
    };

    void find_paths();
    std::int64_t move(const std::vector<std::uint32_t>& path, std::int64_t& work);
    [[nodiscard]] bool crosses(const std::vector<std::uint32_t>& path) const;
    [[nodiscard]] std::int32_t place_of(std::uint32_t node, const Window& window) const;
    void end_costs(std::uint32_t node, std::uint32_t fixed, const Adjacency& side, const Window& window,
                   std::vector<std::int32_t>& costs) const;
    void first_row(std::uint32_t upper, std::uint32_t lower, const Window& a, const Window& b);
    void next_row(std::uint32_t passed, const Window& b);
    std::int64_t step(std::uint32_t upper, std::uint32_t lower, const Window& a, const Window& b);
    void put_back(const std::vector<std::uint32_t>& path, const std::vector<std::int32_t>& gaps);

    LayeredGraph& g_;
    const Adjacency& up_;
    const Adjacency& down_;
    std::vector<std::uint32_t>& position_;
    const std::vector<std::uint32_t>& layer_;
    std::vector<std::vector<std::uint32_t>> paths_;
    // Kept between calls to save allocations.
    std::vector<Window> windows_;
    std::vector<std::int64_t> cost_;
    std::vector<std::int64_t> next_cost_;
    std::vector<std::vector<std::int32_t>> came_from_;
    std::vector<std::int32_t> row_;
    std::vector<std::int32_t> ends_;
};

} // namespace planum::strat
