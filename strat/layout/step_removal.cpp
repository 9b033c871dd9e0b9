// SPDX-License-Identifier: MIT
#include "strat/layout/step_removal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

using Run = std::vector<std::uint32_t>; // line nodes in one vertical, downwards

class StepRemover : public LevelNeighbours {
  public:
    explicit StepRemover(const LevelNeighbours& neighbours) : LevelNeighbours(neighbours), moved_by_(g_.nodes, 0) {
        relief_ = style::kLineGap - style::kLeastLineGap;
    }

    void remove(std::vector<double>& x) {
        constexpr int kRounds = 3; // a run that goes makes room for another
        for (int round = 0; round < kRounds; ++round) {
            join_steps(x);
            straighten_runs(x);
        }
    }

  private:
    // At each small step the line above or below it goes on straight.
    void join_steps(std::vector<double>& x) {
        constexpr double kHair = 14.0;
        for (std::size_t l = 1; l < g_.layers.size(); ++l) {
            for (const std::uint32_t v : g_.layers[l]) {
                const std::uint32_t u = line_above(v);
                if (u == kNone || x[u] == x[v] || std::abs(x[u] - x[v]) > kHair) continue;
                if (!shift(run_from(v, x, down_), x[u], x)) shift(run_from(u, x, up_), x[v], x);
            }
        }
    }

    // Line nodes in one vertical, from a step on.
    [[nodiscard]] Run run_from(std::uint32_t first, const std::vector<double>& x, const Adjacency& onwards) const {
        Run run = {first};
        while (onwards.row(run.back()).size() == 1) {
            const std::uint32_t next = onwards.row(run.back())[0];
            if (!extents_[next].is_line || x[next] != x[first]) break;
            run.push_back(next);
        }
        return run;
    }

    // All of the vertical that a line node is part of.
    [[nodiscard]] Run run_through(std::uint32_t node, const std::vector<double>& x) const {
        Run run = run_from(node, x, up_);
        std::reverse(run.begin(), run.end());
        const Run below = run_from(node, x, down_);
        run.insert(run.end(), below.begin() + 1, below.end());
        return run;
    }

    // Moves a run, and what stands in its way, if fewer edges than before are bent then.
    bool shift(const Run& run, double to, std::vector<double>& x) {
        moved_.clear();
        ++shifts_;
        constexpr int kMostPushed = 4; // runs, one by the other
        const bool fits = push(run, to, kMostPushed, x);
        const std::ptrdiff_t after = fits ? bent_edges(x) : 0;
        exchange(x);
        if (!fits || after >= bent_edges(x)) return false;
        exchange(x);
        return true;
    }

    // The places of now with those of before the move.
    void exchange(std::vector<double>& x) {
        for (auto& [node, other] : moved_) std::swap(x[node], other);
    }

    bool push(const Run& run, double to, int left, std::vector<double>& x) {
        const bool leftwards = to < x[run.front()];
        // Lines that become one further on share what is below: then there is nothing to push.
        if (std::any_of(run.begin(), run.end(), [&](std::uint32_t v) { return is_moved(v); })) return false;
        for (const std::uint32_t v : run) {
            moved_.emplace_back(v, x[v]);
            moved_by_[v] = shifts_;
            x[v] = to;
        }
        for (const std::uint32_t v : run) {
            if (within(v, leftwards, x)) continue;
            const std::uint32_t n = neighbour(v, leftwards);
            if (left == 0 || n == kNone || !extents_[n].is_line || extents_[n].group != extents_[v].group) return false;
            const double away = to + (leftwards ? -separation(n, v) : separation(v, n));
            if (!push(run_through(n, x), away, left - 1, x) || !within(v, leftwards, x)) return false;
        }
        return std::all_of(run.begin(), run.end(), [&](std::uint32_t v) { return within(v, !leftwards, x); });
    }

    [[nodiscard]] bool within(std::uint32_t v, bool leftwards, const std::vector<double>& x) const {
        return leftwards ? x[v] >= bound(v, x, true) : x[v] <= bound(v, x, false);
    }

    [[nodiscard]] bool is_moved(std::uint32_t node) const { return moved_by_[node] == shifts_; }

    // Edges at what moved that are not one straight vertical; both ends count where both moved, before and after alike.
    [[nodiscard]] std::ptrdiff_t bent_edges(const std::vector<double>& x) const {
        std::ptrdiff_t bent = 0;
        for (const auto& [v, other] : moved_) {
            for (const Adjacency* side : {&up_, &down_}) {
                for (const std::uint32_t w : side->row(v)) bent += std::abs(x[w] - x[v]) > reach(w) ? 1 : 0;
            }
        }
        return bent;
    }

    // How far from its centre a line can leave or enter a node.
    [[nodiscard]] double reach(std::uint32_t v) const {
        if (extents_[v].is_line) return 0.0;
        return std::max(0.0, std::floor(extents_[v].width - 2.0 * style::kPortMargin)) / 2.0;
    }

    // Where lines may leave or enter a node without a bend.
    struct Facing {
        double least = 0.0;
        double most = 0.0;

        [[nodiscard]] bool holds(double at) const noexcept { return at >= least && at <= most; }
    };

    void add_facing(std::uint32_t end, const Adjacency& onwards, const std::vector<double>& x,
                    std::vector<Facing>& all) const {
        for (const std::uint32_t w : onwards.row(end)) all.push_back({x[w] - reach(w), x[w] + reach(w)});
    }

    // Last, each straight piece goes to the nearest place with the fewest bends at its ends that the level has room
    // for.
    void straighten_runs(std::vector<double>& x) const {
        for (const Run& run : straight_runs(x)) {
            if (!extents_[run.front()].is_line) continue;
            std::vector<Facing> ends;
            add_facing(run.front(), up_, x, ends);
            add_facing(run.back(), down_, x, ends);
            const auto straight_at = [&](double at) {
                return std::count_if(ends.begin(), ends.end(), [&](const Facing& f) { return f.holds(at); });
            };
            const double now = x[run.front()];
            double best = now;
            std::ptrdiff_t most = straight_at(now);
            for (const Facing& f : ends) {
                for (const double to : {f.least, f.most}) {
                    const std::ptrdiff_t straight = straight_at(to);
                    const bool better =
                        straight > most || (straight == most && std::abs(to - now) < std::abs(best - now));
                    if (!better || !fits(run, to, x)) continue;
                    best = to;
                    most = straight;
                }
            }
            for (const std::uint32_t v : run) x[v] = best;
        }
    }

    [[nodiscard]] bool fits(const Run& run, double to, const std::vector<double>& x) const {
        return std::all_of(run.begin(), run.end(),
                           [&](std::uint32_t v) { return to >= bound(v, x, true) && to <= bound(v, x, false); });
    }

    std::vector<std::pair<std::uint32_t, double>> moved_; // by the last shift: node and its place before
    std::vector<std::uint32_t> moved_by_;                 // by node: the last shift that moved it
    std::uint32_t shifts_ = 0;
};

} // namespace

void take_out_steps(const LevelNeighbours& neighbours, std::vector<double>& x) { StepRemover(neighbours).remove(x); }

} // namespace planum::strat
