// SPDX-License-Identifier: MIT
#include "strat/layout/level_balance.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "strat/layout/drawing_style.hpp"

namespace planum::strat {

namespace {

constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

// A level this much wider than the mean of its component is worth relieving.
constexpr double kMuchWider = 1.6;

class Balancer {
  public:
    Balancer(const DrawnGraph& graph, const std::vector<bool>& upwards, const std::vector<bool>& fixed,
             std::vector<std::int32_t>& rank)
        : graph_(graph), fixed_(fixed), rank_(rank), above_(graph.boxes.size()), below_(graph.boxes.size()) {
        for (std::size_t i = 0; i < graph.orders.size(); ++i) {
            const GraphOrder& o = graph.orders[i];
            // A box at a line that runs upwards stays: two entries make it none of ours.
            for (int again = upwards[i] ? 2 : 1; again > 0; --again) {
                below_[o.later].push_back(o.earlier);
                above_[o.earlier].push_back(o.later);
            }
        }
    }

    void balance(const std::vector<std::uint32_t>& boxes) {
        widths_.clear();
        chains_.clear();
        for (const std::uint32_t b : boxes) widths_[rank_[b]] += room(b);
        for (const std::uint32_t b : boxes) {
            if (starts_chain(b)) chains_[rank_[b]].push_back(chain_from(b));
        }
        double sum = 0.0;
        for (const auto& [level, width] : widths_) sum += width;
        const double mean = sum / static_cast<double>(widths_.size());
        for (std::size_t moves = 0; moves < boxes.size(); ++moves) {
            const auto widest = std::max_element(widths_.begin(), widths_.end(),
                                                 [](const auto& a, const auto& b) { return a.second < b.second; });
            if (widest->second < kMuchWider * mean || !relieve(widest->first)) return;
        }
    }

  private:
    using Chain = std::vector<std::uint32_t>;

    [[nodiscard]] double room(std::uint32_t box) const { return graph_.boxes[box].box.rect.width + style::kBoxGap; }

    [[nodiscard]] bool is_free(std::uint32_t box) const {
        return !fixed_[box] && above_[box].size() == 1 && below_[box].size() == 1;
    }

    [[nodiscard]] bool hangs_at(std::uint32_t box, std::uint32_t above) const {
        return is_free(box) && is_free(above) && above_[box][0] == above && rank_[box] == rank_[above] + 1;
    }

    [[nodiscard]] bool starts_chain(std::uint32_t box) const { return is_free(box) && !hangs_at(box, above_[box][0]); }

    [[nodiscard]] Chain chain_from(std::uint32_t box) const {
        Chain chain = {box};
        while (hangs_at(below_[chain.back()][0], chain.back())) chain.push_back(below_[chain.back()][0]);
        return chain;
    }

    struct Move {
        double widest = std::numeric_limits<double>::infinity(); // level that it would make
        std::int32_t by = 0;
        std::int32_t level = 0; // of the chain's first box
        std::size_t chain = 0;
    };

    // Moves one chain off this level to where the widest level that it joins is least wide.
    bool relieve(std::int32_t level) {
        constexpr std::int32_t kLongestChain = 64;
        Move best;
        for (std::int32_t start = level; start > level - kLongestChain; --start) {
            const auto here = chains_.find(start);
            if (here == chains_.end()) continue;
            for (std::size_t c = 0; c < here->second.size(); ++c) {
                if (static_cast<std::int32_t>(here->second[c].size()) > level - start) try_chain(level, start, c, best);
            }
        }
        if (best.by == 0) return false;
        Chain chain = std::move(chains_[best.level][best.chain]);
        chains_[best.level].erase(chains_[best.level].begin() + static_cast<std::ptrdiff_t>(best.chain));
        for (const std::uint32_t b : chain) widths_[rank_[b]] -= room(b);
        for (const std::uint32_t b : chain) {
            rank_[b] += best.by;
            widths_[rank_[b]] += room(b);
        }
        chains_[best.level + best.by].push_back(std::move(chain));
        return true;
    }

    void try_chain(std::int32_t level, std::int32_t start, std::size_t c, Move& best) const {
        const Chain& chain = chains_.at(start)[c];
        const auto length = static_cast<std::int32_t>(chain.size());
        const std::int32_t least = rank_[above_[chain.front()][0]] + 1;
        const std::int32_t most = rank_[below_[chain.back()][0]] - length;
        const double now = widths_.at(level);
        for (std::int32_t to = least; to <= most; ++to) {
            const bool still_there = to <= level && level < to + length;
            if (still_there) continue;
            double widest = 0.0;
            for (std::int32_t i = 0; i < length; ++i) {
                const bool own = to + i >= start && to + i < start + length; // part of this width is the chain's
                const auto width = widths_.find(to + i);
                const double others = width == widths_.end() ? 0.0 : width->second;
                const std::uint32_t passed = own ? chain[static_cast<std::size_t>(to + i - start)] : kNone;
                widest =
                    std::max(widest, others - (own ? room(passed) : 0.0) + room(chain[static_cast<std::size_t>(i)]));
            }
            if (widest >= now - 1.0 || widest >= best.widest) continue;
            best = {widest, to - start, start, c};
        }
    }

    const DrawnGraph& graph_;
    const std::vector<bool>& fixed_;
    std::vector<std::int32_t>& rank_;
    std::vector<std::vector<std::uint32_t>> above_;
    std::vector<std::vector<std::uint32_t>> below_;
    std::map<std::int32_t, double> widths_;             // of the component's levels [pt]
    std::map<std::int32_t, std::vector<Chain>> chains_; // by the level of the first box
};

} // namespace

void balance_levels(const DrawnGraph& graph, const std::vector<bool>& upwards,
                    const std::vector<std::uint32_t>& component, const std::vector<bool>& fixed,
                    std::vector<std::int32_t>& rank) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> boxes;
    for (std::uint32_t b = 0; b < graph.boxes.size(); ++b) {
        if (!graph.boxes[b].box.isolated) boxes[component[b]].push_back(b);
    }
    Balancer balancer(graph, upwards, fixed, rank);
    constexpr std::size_t kFew = 12;
    for (const auto& [number, members] : boxes) {
        if (members.size() >= kFew) balancer.balance(members);
    }
}

} // namespace planum::strat
