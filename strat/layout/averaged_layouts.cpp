// SPDX-License-Identifier: MIT
#include "strat/layout/averaged_layouts.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <unordered_set>

namespace planum::strat {

namespace {

class Averager : public LevelNeighbours {
  public:
    explicit Averager(const LevelNeighbours& neighbours) : LevelNeighbours(neighbours) { mark_conflicts(); }

    std::vector<double> average() {
        std::array<std::vector<double>, 4> layouts;
        std::size_t k = 0;
        for (const bool from_top : {true, false}) {
            for (const bool leftwards : {true, false}) {
                align(from_top, leftwards);
                layouts[k++] = compact(leftwards);
            }
        }
        return balance(layouts);
    }

  private:
    [[nodiscard]] static std::uint64_t key(std::uint32_t upper, std::uint32_t lower) {
        return (static_cast<std::uint64_t>(upper) << 32U) | lower;
    }

    // Type 1: a line's inner piece crossed by another edge; the line shall stay straight.
    void mark_conflicts() {
        for (std::size_t l = 0; l + 1 < g_.layers.size(); ++l) {
            const std::vector<std::uint32_t>& lower = g_.layers[l + 1];
            std::uint32_t left = 0;
            std::size_t scanned = 0;
            for (std::size_t i = 0; i < lower.size(); ++i) {
                const std::uint32_t inner = line_above(lower[i]);
                if (i + 1 != lower.size() && inner == kNone) continue;
                const std::uint32_t right =
                    inner == kNone ? static_cast<std::uint32_t>(g_.layers[l].size()) : position_[inner];
                for (; scanned <= i; ++scanned) {
                    for (const std::uint32_t u : up_.row(lower[scanned])) {
                        const bool is_inner = extents_[u].is_line && extents_[lower[scanned]].is_line;
                        if ((position_[u] < left || position_[u] > right) && !is_inner)
                            conflicts_.insert(key(u, lower[scanned]));
                    }
                }
                left = right;
            }
        }
    }

    [[nodiscard]] bool in_conflict(std::uint32_t v, std::uint32_t u, bool from_top) const {
        return conflicts_.contains(from_top ? key(u, v) : key(v, u));
    }

    // Blocks of nodes to be drawn in one vertical: each node with the median of its neighbours.
    void align(bool from_top, bool leftwards) {
        root_.resize(g_.nodes);
        align_.resize(g_.nodes);
        std::iota(root_.begin(), root_.end(), 0U);
        std::iota(align_.begin(), align_.end(), 0U);
        const Adjacency& fixed = from_top ? up_ : down_;
        const std::size_t count = g_.layers.size();
        for (std::size_t step = 1; step < count; ++step) {
            const std::vector<std::uint32_t>& layer = g_.layers[from_top ? step : count - 1 - step];
            std::int64_t limit = leftwards ? -1 : std::numeric_limits<std::int64_t>::max();
            for (std::size_t i = 0; i < layer.size(); ++i) {
                const std::uint32_t v = leftwards ? layer[i] : layer[layer.size() - 1 - i];
                const auto row = fixed.row(v);
                if (row.empty()) continue;
                const std::size_t low = (row.size() - 1) / 2;
                const std::size_t high = row.size() / 2;
                for (const std::size_t m : {leftwards ? low : high, leftwards ? high : low}) {
                    const std::uint32_t u = row[m];
                    const auto at = static_cast<std::int64_t>(position_[u]);
                    if (align_[v] != v || in_conflict(v, u, from_top)) continue;
                    if (leftwards ? limit >= at : limit <= at) continue;
                    align_[u] = v;
                    root_[v] = root_[u];
                    align_[v] = root_[v];
                    limit = at;
                }
            }
        }
    }

    // Longest paths over the graph of blocks, first pressed to one side, then pulled back as far as the
    // right neighbours allow, which spares the classes of the first paper and its known mistake.
    std::vector<double> compact(bool leftwards) const {
        const double sign = leftwards ? 1.0 : -1.0;
        const std::vector<std::uint32_t> order = blocks_in_order(leftwards);
        std::vector<double> x(g_.nodes, 0.0); // of roots, times sign
        for (const std::uint32_t root : order) {
            double least = 0.0;
            for (std::uint32_t w = root;;) {
                const std::uint32_t n = neighbour(w, leftwards);
                if (n != kNone) least = std::max(least, x[root_[n]] + separation(n, w));
                w = align_[w];
                if (w == root) break;
            }
            x[root] = least;
        }
        for (std::size_t i = order.size(); i-- > 0;) {
            const std::uint32_t root = order[i];
            double most = std::numeric_limits<double>::infinity();
            for (std::uint32_t w = root;;) {
                const std::uint32_t n = neighbour(w, !leftwards);
                if (n != kNone) most = std::min(most, x[root_[n]] - separation(n, w));
                w = align_[w];
                if (w == root) break;
            }
            if (most < std::numeric_limits<double>::infinity()) x[root] = std::max(x[root], most);
        }
        std::vector<double> result(g_.nodes);
        for (std::uint32_t v = 0; v < g_.nodes; ++v) result[v] = sign * x[root_[v]];
        return result;
    }

    // Roots so that every block comes after those it must stand beside.
    std::vector<std::uint32_t> blocks_in_order(bool leftwards) const {
        std::vector<std::uint32_t> waiting(g_.nodes, 0);
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            if (neighbour(v, leftwards) != kNone) ++waiting[root_[v]];
        }
        std::vector<std::uint32_t> order;
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            if (root_[v] == v && waiting[v] == 0) order.push_back(v);
        }
        for (std::size_t at = 0; at < order.size(); ++at) {
            for (std::uint32_t w = order[at];;) {
                const std::uint32_t n = neighbour(w, !leftwards);
                if (n != kNone && --waiting[root_[n]] == 0) order.push_back(root_[n]);
                w = align_[w];
                if (w == order[at]) break;
            }
        }
        return order;
    }

    // All four are moved onto the narrowest, then each node takes the mean of its two middle places.
    std::vector<double> balance(std::array<std::vector<double>, 4>& layouts) const {
        std::array<double, 4> least{};
        std::array<double, 4> most{};
        std::size_t narrowest = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            least[k] = std::numeric_limits<double>::infinity();
            most[k] = -least[k];
            for (std::uint32_t v = 0; v < g_.nodes; ++v) {
                least[k] = std::min(least[k], layouts[k][v] - extents_[v].width / 2.0);
                most[k] = std::max(most[k], layouts[k][v] + extents_[v].width / 2.0);
            }
            if (most[k] - least[k] < most[narrowest] - least[narrowest]) narrowest = k;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool leftwards = k % 2 == 0;
            const double shift = leftwards ? least[narrowest] - least[k] : most[narrowest] - most[k];
            for (double& x : layouts[k]) x += shift;
        }
        std::vector<double> x(g_.nodes);
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            std::array<double, 4> four = {layouts[0][v], layouts[1][v], layouts[2][v], layouts[3][v]};
            std::sort(four.begin(), four.end());
            x[v] = (four[1] + four[2]) / 2.0 - least[narrowest];
        }
        return x;
    }

    std::unordered_set<std::uint64_t> conflicts_;
    std::vector<std::uint32_t> root_;
    std::vector<std::uint32_t> align_;
};

} // namespace

std::vector<double> averaged_layouts(const LevelNeighbours& neighbours) { return Averager(neighbours).average(); }

} // namespace planum::strat
