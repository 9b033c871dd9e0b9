// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <utility>

#include "strat/checks/feedback_arcs.hpp"

namespace planum::strat {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A small graph as a matrix of cells; parallel arcs share a cell, since they are cut together.
class Contracted {
  public:
    struct Cell {
        double weight = 0.0;
        std::vector<std::uint32_t> arcs;
    };

    Contracted(std::size_t nodes, std::span<const WeightedArc> arcs)
        : nodes_(nodes), alive_(nodes, 1), cells_(nodes * nodes) {
        for (std::uint32_t i = 0; i < arcs.size(); ++i) {
            if (arcs[i].from == arcs[i].to) {
                forced_.push_back(i);
                continue;
            }
            Cell& c = cell(arcs[i].from, arcs[i].to);
            c.weight += arcs[i].weight;
            c.arcs.push_back(i);
        }
        while (contract_one()) {
        }
    }

    [[nodiscard]] Cell& cell(std::size_t from, std::size_t to) { return cells_[from * nodes_ + to]; }

    /// Arcs that some best solution contains: loops that contraction left.
    [[nodiscard]] const std::vector<std::uint32_t>& forced() const { return forced_; }

    [[nodiscard]] std::vector<std::size_t> left() const {
        std::vector<std::size_t> nodes;
        for (std::size_t v = 0; v < nodes_; ++v) {
            if (alive_[v] != 0) nodes.push_back(v);
        }
        return nodes;
    }

  private:
    std::size_t nodes_;
    std::vector<char> alive_;
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> forced_;

    struct Side {
        std::size_t neighbours = 0;
        std::size_t last = 0;
        double weight = 0.0;
    };

    template<class CellOf>
    [[nodiscard]] Side side_of(std::size_t v, CellOf cell_of) {
        Side side;
        for (std::size_t x = 0; x < nodes_; ++x) {
            if (x == v || alive_[x] == 0 || cell_of(x).arcs.empty()) continue;
            ++side.neighbours;
            side.last = x;
            side.weight += cell_of(x).weight;
        }
        return side;
    }

    // A node with one neighbour above, whose arc is at least as dear as all arcs below together: no best
    // solution needs that arc, so the node melts into its neighbour; and the same upside down.
    bool contract_one() {
        for (std::size_t v = 0; v < nodes_; ++v) {
            if (alive_[v] == 0) continue;
            const Side above = side_of(v, [&](std::size_t x) -> Cell& { return cell(x, v); });
            const Side below = side_of(v, [&](std::size_t x) -> Cell& { return cell(v, x); });
            if (above.neighbours == 0 || below.neighbours == 0) {
                alive_[v] = 0;
                return true;
            }
            if (above.neighbours == 1 && above.weight >= below.weight) {
                melt(v, above.last, cell(v, above.last));
                return true;
            }
            if (below.neighbours == 1 && below.weight >= above.weight) {
                melt(v, below.last, cell(below.last, v));
                return true;
            }
        }
        return false;
    }

    // `back` runs against the arc that holds the two together; with it uncut, `back` must go.
    void melt(std::size_t v, std::size_t into, Cell& back) {
        forced_.insert(forced_.end(), back.arcs.begin(), back.arcs.end());
        back = {};
        alive_[v] = 0;
        for (std::size_t x = 0; x < nodes_; ++x) {
            if (alive_[x] == 0 || x == into) continue;
            move(cell(v, x), cell(into, x));
            move(cell(x, v), cell(x, into));
        }
    }

    static void move(Cell& from, Cell& to) {
        to.weight += from.weight;
        to.arcs.insert(to.arcs.end(), from.arcs.begin(), from.arcs.end());
        from = {};
    }
};

// Held and Karp's programme for the order of least backward weight: f(S) is the least weight of arcs
// that run backwards when the nodes of S come first.
class SubsetProgramme {
  public:
    SubsetProgramme(Contracted& graph, std::vector<std::size_t> nodes)
        : graph_(graph), nodes_(std::move(nodes)), low_bits_(nodes_.size() / 2) {
        low_ = sums(0, low_bits_);
        high_ = sums(low_bits_, nodes_.size());
        least_low_ = least(low_, 0, low_bits_);
        least_high_ = least(high_, low_bits_, nodes_.size());
        above_.assign(nodes_.size(), 0);
        below_.assign(nodes_.size(), 0);
        for (std::size_t v = 0; v < nodes_.size(); ++v) {
            for (std::size_t x = 0; x < nodes_.size(); ++x) {
                if (graph_.cell(nodes_[v], nodes_[x]).arcs.empty()) continue;
                below_[v] |= std::size_t{1} << x;
                above_[x] |= std::size_t{1} << v;
            }
        }
    }

    /// Arcs that run backwards in a best order; empty when none is cheaper than `bound`.
    [[nodiscard]] std::vector<std::uint32_t> solve(double bound) {
        const std::size_t n = nodes_.size();
        const std::size_t all = (std::size_t{1} << n) - 1;
        const std::size_t low_mask = (std::size_t{1} << low_bits_) - 1;
        std::vector<double> best(all + 1, kInfinite);
        best[0] = 0.0;
        for (std::size_t set = 0; set < all; ++set) {
            // What the two halves of the rest cost by themselves, the rest costs at least.
            if (best[set] > bound) continue;
            const std::size_t rest = all & ~set;
            if (best[set] + least_low_[rest & low_mask] + least_high_[rest >> low_bits_] > bound) continue;
            const std::size_t next = worth_trying(rest);
            const double* low = &low_[(set & low_mask) * n];
            const double* high = &high_[(set >> low_bits_) * n];
            for (std::size_t left = next; left != 0; left &= left - 1) {
                const auto v = static_cast<std::size_t>(__builtin_ctzll(left));
                double& after = best[set | (left & (~left + 1))];
                after = std::min(after, best[set] + low[v] + high[v]);
            }
        }
        if (best[all] == kInfinite) return {};
        return backward_arcs(best, all);
    }

  private:
    Contracted& graph_;
    std::vector<std::size_t> nodes_;
    std::size_t low_bits_;
    std::vector<double> low_; // [subset of the low half][v]: weight of arcs from v into the subset
    std::vector<double> high_;
    std::vector<double> least_low_; // least backward weight within each subset of the low half
    std::vector<double> least_high_;
    std::vector<std::size_t> above_; // nodes with an arc into v, as bits
    std::vector<std::size_t> below_;

    // Which nodes may come next in a best order. One with nothing above it in the rest can come at once, for
    // it costs the same wherever it stands; one with nothing below it in the rest can wait.
    [[nodiscard]] std::size_t worth_trying(std::size_t rest) const {
        std::size_t next = 0;
        for (std::size_t left = rest; left != 0; left &= left - 1) {
            const auto v = static_cast<std::size_t>(__builtin_ctzll(left));
            if ((above_[v] & rest) == 0) return left & (~left + 1);
            if ((below_[v] & rest) != 0) next |= left & (~left + 1);
        }
        return next;
    }

    [[nodiscard]] std::vector<double> sums(std::size_t first, std::size_t last) {
        const std::size_t n = nodes_.size();
        std::vector<double> table((std::size_t{1} << (last - first)) * n, 0.0);
        for (std::size_t set = 1; set < (std::size_t{1} << (last - first)); ++set) {
            const auto lowest = static_cast<std::size_t>(__builtin_ctzll(set));
            const std::size_t rest = set & (set - 1);
            for (std::size_t v = 0; v < n; ++v) {
                table[set * n + v] = table[rest * n + v] + graph_.cell(nodes_[v], nodes_[first + lowest]).weight;
            }
        }
        return table;
    }

    // The same programme for the subsets of one half alone.
    [[nodiscard]] std::vector<double> least(const std::vector<double>& table, std::size_t first,
                                            std::size_t last) const {
        const std::size_t n = nodes_.size();
        std::vector<double> weight(std::size_t{1} << (last - first), kInfinite);
        weight[0] = 0.0;
        for (std::size_t set = 1; set < weight.size(); ++set) {
            for (std::size_t v = 0; v < last - first; ++v) {
                const std::size_t without = set & ~(std::size_t{1} << v);
                if (without == set) continue;
                weight[set] = std::min(weight[set], weight[without] + table[without * n + first + v]);
            }
        }
        return weight;
    }

    // Which node came last in the best order of the set: the same sums in the same order give the same
    // numbers, so equality finds it.
    [[nodiscard]] std::size_t last_of(const std::vector<double>& best, std::size_t set) const {
        for (std::size_t left = set; left != 0; left &= left - 1) {
            const auto v = static_cast<std::size_t>(__builtin_ctzll(left));
            const std::size_t before = set & ~(left & (~left + 1));
            const std::size_t low = before & ((std::size_t{1} << low_bits_) - 1);
            const double weight =
                best[before] + low_[low * nodes_.size() + v] + high_[(before >> low_bits_) * nodes_.size() + v];
            if (weight == best[set]) return v;
        }
        return static_cast<std::size_t>(__builtin_ctzll(set));
    }

    [[nodiscard]] std::vector<std::uint32_t> backward_arcs(const std::vector<double>& best, std::size_t set) const {
        std::vector<std::uint32_t> arcs;
        while (set != 0) {
            const std::size_t v = last_of(best, set);
            set &= ~(std::size_t{1} << v);
            for (std::size_t x = 0; x < nodes_.size(); ++x) {
                if ((set & (std::size_t{1} << x)) == 0) continue;
                const auto& cut = graph_.cell(nodes_[v], nodes_[x]).arcs;
                arcs.insert(arcs.end(), cut.begin(), cut.end());
            }
        }
        return arcs;
    }
};

} // namespace

FeedbackSet exact_feedback_arcs(std::size_t nodes, std::span<const WeightedArc> arcs, double bound) {
    Contracted graph(nodes, arcs);
    FeedbackSet result;
    result.arcs = graph.forced();
    double forced = 0.0;
    for (const std::uint32_t arc : result.arcs) forced += arcs[arc].weight;
    std::vector<std::size_t> left = graph.left();
    if (left.size() > 1) {
        // A little room, so that rounding never cuts off the best order itself.
        const double room = bound - forced + 1e-9 * (1.0 + bound);
        const auto cut = SubsetProgramme(graph, std::move(left)).solve(room);
        result.arcs.insert(result.arcs.end(), cut.begin(), cut.end());
    }
    std::sort(result.arcs.begin(), result.arcs.end());
    for (const std::uint32_t arc : result.arcs) result.weight += arcs[arc].weight;
    return result;
}

} // namespace planum::strat
