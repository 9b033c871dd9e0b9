// SPDX-License-Identifier: MIT
#include "strat/layout/coordinate_phase.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.hpp"
#include "strat/layout/averaged_layouts.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/fan_centring.hpp"
#include "strat/layout/level_neighbours.hpp"
#include "strat/layout/network_simplex.hpp"
#include "strat/layout/step_removal.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

namespace {

// The simplex counts in half points.
constexpr double kHalves = 2.0;

class Placer : public LevelNeighbours {
  public:
    using LevelNeighbours::LevelNeighbours;

    // The averaged layout leaves steps that a little room on the level would take out: whole blocks (a box, or a
    // straight run of line nodes) move to the median of their neighbours as far as the levels allow. Each move
    // shortens the sum of horizontal ways, so this ends.
    void settle(std::vector<double>& x) const {
        const std::vector<std::vector<std::uint32_t>> blocks = straight_runs(x);
        std::vector<Pull> pulls; // kept between calls to save allocations
        constexpr int kRounds = 12;
        for (int round = 0; round < kRounds; ++round) {
            bool moved = false;
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                moved = settle_block(blocks[round % 2 == 0 ? i : blocks.size() - 1 - i], x, pulls) || moved;
            }
            if (!moved) return;
        }
    }

    std::vector<double> place() {
        std::vector<double> x = averaged_layouts(*this);
        settle(x);
        shorten(x);
        find_sides(x);
        settle(x);
        centre_over_fans(*this, x);
        take_out_steps(*this, x);
        return x;
    }

  private:
    // Node numbers of a group's left and right side, for the simplex.
    [[nodiscard]] std::uint32_t left_side(std::int32_t group) const {
        return g_.nodes + 2 * static_cast<std::uint32_t>(group);
    }

    [[nodiscard]] std::uint32_t right_side(std::int32_t group) const { return left_side(group) + 1; }

    static std::int32_t halves(double length) { return static_cast<std::int32_t>(std::ceil(length * kHalves)); }

    // What keeps neighbours apart: from node to node, or by way of the sides of the groups they belong to.
    [[nodiscard]] std::vector<RankArc> separations() const {
        std::vector<RankArc> arcs;
        const auto keep_apart = [&](std::uint32_t a, std::uint32_t b) {
            const std::int32_t group_a = extents_[a].group;
            const std::int32_t group_b = extents_[b].group;
            if (group_a == group_b) {
                arcs.push_back({a, b, halves(separation(a, b)), 0});
                return;
            }
            const double room = std::min(extents_[a].gap, extents_[b].gap);
            const double left = group_a < 0 ? extents_[a].width / 2.0 : 0.0;
            const double right = group_b < 0 ? extents_[b].width / 2.0 : 0.0;
            arcs.push_back({group_a < 0 ? a : right_side(group_a), group_b < 0 ? b : left_side(group_b),
                            halves(left + right + room), 0});
        };
        for (const std::vector<std::uint32_t>& layer : g_.layers) {
            for (std::size_t i = 0; i < layer.size(); ++i) {
                if (i > 0) keep_apart(layer[i - 1], layer[i]);
                const std::int32_t group = extents_[layer[i]].group;
                if (group < 0) continue;
                const std::int32_t inside = halves(extents_[layer[i]].width / 2.0 + kGroupPad);
                arcs.push_back({left_side(group), layer[i], inside, 0});
                arcs.push_back({layer[i], right_side(group), inside, 0});
            }
        }
        return arcs;
    }

    // Moves to the right what stands too near to its left neighbour.
    [[nodiscard]] std::vector<std::int32_t> feasible_start(const std::vector<double>& x,
                                                           const std::vector<RankArc>& arcs) const {
        const std::uint32_t nodes = g_.nodes + 2 * static_cast<std::uint32_t>(groups_);
        std::vector<std::int32_t> start(nodes, std::numeric_limits<std::int32_t>::min());
        for (std::uint32_t v = 0; v < g_.nodes; ++v) start[v] = static_cast<std::int32_t>(std::lround(x[v] * kHalves));
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            const std::int32_t group = extents_[v].group;
            if (group < 0) continue;
            const std::int32_t inside = halves(extents_[v].width / 2.0 + kGroupPad);
            std::int32_t& left = start[left_side(group)];
            std::int32_t& right = start[right_side(group)];
            const bool first = right == std::numeric_limits<std::int32_t>::min();
            left = first ? start[v] - inside : std::min(left, start[v] - inside);
            right = std::max(right, start[v] + inside);
        }
        for (std::size_t v = g_.nodes; v < nodes; ++v) { // sides of groups that have no node here
            if (start[v] == std::numeric_limits<std::int32_t>::min()) start[v] = 0;
        }
        const Adjacency out = Adjacency::make(
            nodes, arcs.size(), [&](std::size_t i) { return arcs[i].from; }, [](std::size_t i) { return i; });
        std::vector<std::uint32_t> waiting(nodes, 0);
        for (const RankArc& arc : arcs) ++waiting[arc.to];
        std::vector<std::uint32_t> open;
        for (std::uint32_t v = 0; v < nodes; ++v) {
            if (waiting[v] == 0) open.push_back(v);
        }
        for (std::size_t at = 0; at < open.size(); ++at) {
            for (const std::uint32_t a : out.row(open[at])) {
                const RankArc& arc = arcs[a];
                start[arc.to] = std::max(start[arc.to], start[arc.from] + arc.length);
                if (--waiting[arc.to] == 0) open.push_back(arc.to);
            }
        }
        if (open.size() != nodes) throw Error(ErrorCode::Internal, "the groups of the drawing stand in a ring");
        return start;
    }

    // Least sum of horizontal ways with all separations kept, as Gansner et al. 1993 place their nodes: each edge
    // gets a node of its own left of both its ends. Keeps the page narrow, which four averaged layouts do not;
    // they are the start, so that few steps are needed.
    void shorten(std::vector<double>& x) const {
        constexpr std::int64_t kWork = 300'000'000; // a pivot costs up to a step a node; the first win most
        constexpr std::int64_t kMany = 100'000;     // nodes: twice the work made sparse 20,000 units wider
        if (g_.edges.empty() && groups_ == 0) return;
        std::vector<RankArc> arcs = separations();
        std::vector<std::int32_t> placed = feasible_start(x, arcs);
        for (const auto& [u, v] : g_.edges) {
            const auto middle = static_cast<std::uint32_t>(placed.size());
            const std::int32_t weight = weight_of(u, v);
            arcs.push_back({middle, u, 0, weight});
            arcs.push_back({middle, v, 0, weight});
            placed.push_back(std::min(placed[u], placed[v]));
        }
        for (std::int32_t group = 0; group < groups_; ++group) {
            constexpr std::int32_t kTight = 1;
            arcs.push_back({left_side(group), right_side(group), 0, kTight});
        }
        const std::int64_t work = std::ssize(placed) < kMany ? kWork : kWork / 2;
        placed = network_simplex(static_cast<std::uint32_t>(placed.size()), arcs, work / std::ssize(placed), placed);
        for (std::uint32_t v = 0; v < g_.nodes; ++v) x[v] = static_cast<double>(placed[v]) / kHalves;
    }

    // Long lines first of all straight, into and out of boxes where they are the only ones there, then boxes that have
    // only each other.
    [[nodiscard]] std::int32_t weight_of(std::uint32_t upper, std::uint32_t lower) const {
        const int lines = (extents_[upper].is_line ? 1 : 0) + (extents_[lower].is_line ? 1 : 0);
        if (lines == 2) return 16;
        const bool pair = down_.row(upper).size() == 1 && up_.row(lower).size() == 1;
        if (pair) return lines == 1 ? 16 : 4;
        return lines == 1 ? 2 : 1;
    }

    struct Pull {
        double x;
        double weight;
    };

    // An end that has one partner only, which has no other, can become straight.
    void add_pulls(const std::vector<std::uint32_t>& block, const std::vector<double>& x,
                   std::vector<Pull>& pulls) const {
        constexpr double kStraight = 3.0;
        const auto add = [&](std::uint32_t v, const Adjacency& side, const Adjacency& back) {
            for (const std::uint32_t w : side.row(v)) {
                if (std::find(block.begin(), block.end(), w) != block.end()) continue;
                const bool pair = side.row(v).size() == 1 && back.row(w).size() == 1;
                pulls.push_back({x[w], pair ? kStraight : 1.0});
            }
        };
        add(block.front(), up_, down_);
        add(block.back(), down_, up_);
    }

    bool settle_block(const std::vector<std::uint32_t>& block, std::vector<double>& x, std::vector<Pull>& pulls) const {
        pulls.clear();
        add_pulls(block, x, pulls);
        if (pulls.empty()) return false;
        std::sort(pulls.begin(), pulls.end(), [](const Pull& a, const Pull& b) { return a.x < b.x; });
        double total = 0.0;
        for (const Pull& p : pulls) total += p.weight;
        // Weighted median; where it is a whole stretch, the nearest end of it that is not passed already.
        double sum = 0.0;
        double low = pulls.front().x;
        double high = pulls.back().x;
        for (const Pull& p : pulls) {
            sum += p.weight;
            if (sum >= total / 2.0) {
                low = p.x;
                break;
            }
        }
        sum = 0.0;
        for (std::size_t i = pulls.size(); i-- > 0;) {
            if (sum + pulls[i].weight >= total / 2.0) {
                high = pulls[i].x;
                break;
            }
            sum += pulls[i].weight;
        }
        double least = -std::numeric_limits<double>::infinity();
        double most = -least;
        for (const std::uint32_t v : block) {
            least = std::max(least, bound(v, x, true));
            most = std::min(most, bound(v, x, false));
        }
        const double now = x[block.front()];
        const double wanted = std::clamp(now, std::min(low, high), std::max(low, high));
        if (least > most) return false; // rounding left no room at all
        const double target = std::clamp(wanted, least, most);
        if (std::abs(target - now) < 0.01) return false;
        for (const std::uint32_t v : block) x[v] = target;
        return true;
    }
};

} // namespace

std::vector<double> place_nodes(const LayeredGraph& graph, const std::vector<NodeExtent>& extents) {
    if (graph.nodes == 0) return {};
    return Placer(graph, extents).place();
}

} // namespace planum::strat
