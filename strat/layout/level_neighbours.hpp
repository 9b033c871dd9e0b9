// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "strat/layout/coordinate_phase.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

/// Who stands beside, above and below whom while the third phase places nodes, and how near they may come.
class LevelNeighbours {
  public:
    LevelNeighbours(const LayeredGraph& graph, const std::vector<NodeExtent>& extents)
        : g_(graph), extents_(extents), position_(graph.nodes, 0), layer_(graph.nodes, 0) {
        for (std::size_t l = 0; l < g_.layers.size(); ++l) {
            for (std::size_t i = 0; i < g_.layers[l].size(); ++i) {
                position_[g_.layers[l][i]] = static_cast<std::uint32_t>(i);
                layer_[g_.layers[l][i]] = static_cast<std::uint32_t>(l);
            }
        }
        down_ = sorted_neighbours(false);
        up_ = sorted_neighbours(true);
        for (const NodeExtent& extent : extents_) groups_ = std::max(groups_, extent.group + 1);
    }

  protected:
    static constexpr double kGroupPad = style::kFramePad;
    static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

    Adjacency sorted_neighbours(bool upwards) const {
        Adjacency a = upwards ? neighbours_above(g_) : neighbours_below(g_);
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            std::sort(a.values.begin() + a.begin[v], a.values.begin() + a.begin[v + 1],
                      [&](std::uint32_t x, std::uint32_t y) { return position_[x] < position_[y]; });
        }
        return a;
    }

    // The node above a line node on the same line, kNone for all others.
    [[nodiscard]] std::uint32_t line_above(std::uint32_t v) const {
        if (!extents_[v].is_line) return kNone;
        for (const std::uint32_t u : up_.row(v)) {
            if (extents_[u].is_line) return u;
        }
        return kNone;
    }

    // Boxes, and line nodes of one line in one vertical.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> straight_runs(const std::vector<double>& x) const {
        std::vector<std::vector<std::uint32_t>> runs;
        for (std::size_t l = 0; l < g_.layers.size(); ++l) {
            for (const std::uint32_t v : g_.layers[l]) {
                const std::uint32_t above = line_above(v);
                if (above != kNone && x[above] == x[v] && down_.row(above).size() == 1)
                    continue; // in the run of `above`
                runs.push_back({v});
                for (std::uint32_t w = v; extents_[w].is_line && down_.row(w).size() == 1;) {
                    const std::uint32_t below = down_.row(w)[0];
                    if (line_above(below) != w || x[below] != x[w]) break;
                    runs.back().push_back(below);
                    w = below;
                }
            }
        }
        return runs;
    }

    [[nodiscard]] double separation(std::uint32_t a, std::uint32_t b) const {
        const double room = (extents_[a].width + extents_[b].width) / 2.0 + std::min(extents_[a].gap, extents_[b].gap) -
                            (extents_[a].is_line || extents_[b].is_line ? relief_ : 0.0);
        if (extents_[a].group == extents_[b].group) return room;
        return room + (extents_[a].group >= 0 ? kGroupPad : 0.0) + (extents_[b].group >= 0 ? kGroupPad : 0.0);
    }

    [[nodiscard]] std::uint32_t neighbour(std::uint32_t v, bool leftwards) const {
        const std::vector<std::uint32_t>& layer = g_.layers[layer_[v]];
        if (leftwards) return position_[v] == 0 ? kNone : layer[position_[v] - 1];
        return position_[v] + 1 == layer.size() ? kNone : layer[position_[v] + 1];
    }

    void find_sides(const std::vector<double>& x) {
        const double infinity = std::numeric_limits<double>::infinity();
        sides_.assign(static_cast<std::size_t>(groups_), {infinity, -infinity});
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            if (extents_[v].group < 0) continue;
            Sides& sides = sides_[static_cast<std::size_t>(extents_[v].group)];
            sides.left = std::min(sides.left, x[v] - extents_[v].width / 2.0 - kGroupPad);
            sides.right = std::max(sides.right, x[v] + extents_[v].width / 2.0 + kGroupPad);
        }
    }

    // Least x of v beside its left neighbour, or most beside its right one, kept out of or inside its group.
    [[nodiscard]] double bound(std::uint32_t v, const std::vector<double>& x, bool leftwards) const {
        const double sign = leftwards ? 1.0 : -1.0;
        const std::uint32_t n = neighbour(v, leftwards);
        const std::int32_t own = extents_[v].group;
        if (own < 0 || sides_.empty()) {
            if (n == kNone) return -sign * std::numeric_limits<double>::infinity();
            if (extents_[n].group < 0 || sides_.empty()) return x[n] + sign * separation(n, v);
            const Sides& sides = sides_[static_cast<std::size_t>(extents_[n].group)];
            const double room = std::min(extents_[n].gap, extents_[v].gap) + extents_[v].width / 2.0;
            return leftwards ? sides.right + room : sides.left - room;
        }
        if (n != kNone && extents_[n].group == own) return x[n] + sign * separation(n, v);
        const Sides& sides = sides_[static_cast<std::size_t>(own)];
        const double inside = extents_[v].width / 2.0 + kGroupPad;
        return leftwards ? sides.left + inside : sides.right - inside;
    }

    struct Sides {
        double left = 0.0;
        double right = 0.0;
    };

    const LayeredGraph& g_;
    const std::vector<NodeExtent>& extents_;
    std::vector<std::uint32_t> position_; // by node, within its level
    std::vector<std::uint32_t> layer_;
    Adjacency up_; // left to right
    Adjacency down_;
    std::int32_t groups_ = 0;
    std::vector<Sides> sides_; // of each group; empty before the simplex has placed them
    double relief_ = 0.0;      // by how much lines may stand nearer than their gap [pt]
};

} // namespace planum::strat
