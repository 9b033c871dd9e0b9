// SPDX-License-Identifier: MIT
#include "strat/layout/group_order.hpp"

#include <algorithm>
#include <numeric>

namespace planum::strat {

namespace {

class GroupOrderer {
  public:
    GroupOrderer(LayeredGraph& graph, const NodeGroups& groups, Progress& progress)
        : g_(graph), groups_(groups), progress_(progress), position_(graph.nodes, 0), key_(graph.nodes, 0.0) {
        down_ = neighbours_below(g_);
        up_ = neighbours_above(g_);
    }

    void order() {
        find_sequence();
        arrange_all();
        best_ = g_.layers;
        best_crossings_ = count_crossings(g_);
        sweep(24);
        swap_neighbouring_groups();
        g_.layers = best_;
    }

  private:
    void number(std::size_t l) {
        for (std::size_t i = 0; i < g_.layers[l].size(); ++i)
            position_[g_.layers[l][i]] = static_cast<std::uint32_t>(i);
    }

    // Groups from left to right by where their nodes stand without bounds, each level counted from 0 to 1.
    void find_sequence() {
        std::vector<double> sum(static_cast<std::size_t>(groups_.count), 0.0);
        std::vector<double> count(sum.size(), 0.0);
        for (std::size_t l = 0; l < g_.layers.size(); ++l) {
            number(l);
            const auto width = static_cast<double>(g_.layers[l].size());
            for (const std::uint32_t v : g_.layers[l]) {
                if (groups_.group[v] < 0 || (up_.row(v).empty() && down_.row(v).empty())) continue;
                sum[static_cast<std::size_t>(groups_.group[v])] += (position_[v] + 0.5) / width;
                count[static_cast<std::size_t>(groups_.group[v])] += 1.0;
            }
        }
        sequence_.resize(sum.size());
        std::iota(sequence_.begin(), sequence_.end(), 0U);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1.0, count[i]);
        std::stable_sort(sequence_.begin(), sequence_.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return sum[a] < sum[b]; });
        rank_sequence();
    }

    void rank_sequence() {
        place_in_sequence_.resize(sequence_.size());
        for (std::uint32_t i = 0; i < sequence_.size(); ++i) place_in_sequence_[sequence_[i]] = i;
    }

    // As the levels stand, but with the groups in their sequence.
    void arrange_all() {
        for (std::size_t l = 0; l < g_.layers.size(); ++l) {
            number(l);
            for (const std::uint32_t v : g_.layers[l]) key_[v] = position_[v];
            arrange(l);
        }
    }

    // A group's nodes on one level, or one node without a group.
    struct Block {
        double key = 0.0;
        double weight = 1.0;
        std::int32_t group = -1;
        std::vector<std::uint32_t> nodes;
    };

    // Sorts a level by the keys of its nodes, as far as the groups allow.
    void arrange(std::size_t l) {
        std::vector<Block> grouped;
        std::vector<Block> free;
        collect_blocks(l, grouped, free);
        make_monotone(grouped);
        std::stable_sort(free.begin(), free.end(), [](const Block& a, const Block& b) { return a.key < b.key; });
        std::vector<std::uint32_t>& layer = g_.layers[l];
        layer.clear();
        std::size_t f = 0;
        const auto put = [&](const Block& block) { layer.insert(layer.end(), block.nodes.begin(), block.nodes.end()); };
        for (const Block& block : grouped) {
            while (f < free.size() && free[f].key <= block.key) put(free[f++]);
            put(block);
        }
        while (f < free.size()) put(free[f++]);
        number(l);
    }

    void collect_blocks(std::size_t l, std::vector<Block>& grouped, std::vector<Block>& free) const {
        std::vector<std::uint32_t> nodes = g_.layers[l];
        std::stable_sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
            if (groups_.leads[a] != groups_.leads[b]) return bool(groups_.leads[a]);
            return key_[a] < key_[b];
        });
        for (const std::uint32_t v : nodes) {
            const std::int32_t group = groups_.group[v];
            if (group < 0) {
                free.push_back({key_[v], 1.0, -1, {v}});
                continue;
            }
            auto block = std::find_if(grouped.begin(), grouped.end(), [&](const Block& b) { return b.group == group; });
            if (block == grouped.end()) {
                grouped.push_back({0.0, 0.0, group, {}});
                block = grouped.end() - 1;
            }
            // Headings and fillers go where the others pull.
            const double weight = up_.row(v).empty() && down_.row(v).empty() ? 1e-6 : 1.0;
            block->key += weight * key_[v];
            block->weight += weight;
            block->nodes.push_back(v);
        }
        for (Block& block : grouped) block.key /= block.weight;
        std::sort(grouped.begin(), grouped.end(), [&](const Block& a, const Block& b) {
            return place_in_sequence_[static_cast<std::size_t>(a.group)] <
                   place_in_sequence_[static_cast<std::size_t>(b.group)];
        });
    }

    // Groups keep their sequence: keys against it become one mean (pool adjacent violators).
    static void make_monotone(std::vector<Block>& blocks) {
        struct Pool {
            double sum = 0.0;
            double weight = 0.0;
            std::size_t count = 0;
        };

        std::vector<Pool> pools;
        for (const Block& b : blocks) {
            pools.push_back({b.key * b.weight, b.weight, 1});
            while (pools.size() > 1) {
                const Pool last = pools.back();
                Pool& before = pools[pools.size() - 2];
                if (before.sum / before.weight <= last.sum / last.weight) break;
                before = {before.sum + last.sum, before.weight + last.weight, before.count + last.count};
                pools.pop_back();
            }
        }
        std::size_t i = 0;
        for (const Pool& pool : pools) {
            for (std::size_t k = 0; k < pool.count; ++k) blocks[i++].key = pool.sum / pool.weight;
        }
    }

    void sweep(int rounds) {
        int stuck = 0;
        for (int round = 0; round < rounds && stuck < 5 && best_crossings_ > 0; ++round) {
            progress_.check();
            const bool downwards = round % 2 == 0;
            const std::size_t count = g_.layers.size();
            for (std::size_t step = 1; step < count; ++step) {
                const std::size_t l = downwards ? step : count - 1 - step;
                take_keys(l, downwards ? up_ : down_, g_.layers[downwards ? l - 1 : l + 1].size());
                arrange(l);
            }
            for (int again = 0; again < 3; ++again) switch_neighbours();
            const std::int64_t now = count_crossings(g_);
            ++stuck;
            if (now >= best_crossings_) continue;
            stuck = 0;
            best_crossings_ = now;
            best_ = g_.layers;
        }
    }

    // The mean place of the neighbours; without any, the own place, on the other level's scale.
    void take_keys(std::size_t l, const Adjacency& fixed, std::size_t fixed_width) {
        const double scale = static_cast<double>(fixed_width) / static_cast<double>(g_.layers[l].size());
        for (const std::uint32_t v : g_.layers[l]) {
            const auto row = fixed.row(v);
            double sum = 0.0;
            for (const std::uint32_t w : row) sum += position_[w];
            key_[v] = row.empty() ? position_[v] * scale : sum / static_cast<double>(row.size());
        }
    }

    // Crossings of two nodes' edges with a left of b, minus those with b left of a.
    [[nodiscard]] std::int64_t gain(std::uint32_t a, std::uint32_t b) const {
        std::int64_t sum = 0;
        for (const Adjacency* side : {&up_, &down_}) {
            for (const std::uint32_t v : side->row(a)) {
                for (const std::uint32_t w : side->row(b)) {
                    if (position_[v] != position_[w]) sum += position_[v] > position_[w] ? 1 : -1;
                }
            }
        }
        return sum;
    }

    // Nodes of one group, or of none, change places where that crosses less.
    void switch_neighbours() {
        for (std::vector<std::uint32_t>& layer : g_.layers) {
            for (std::size_t i = 0; i + 1 < layer.size(); ++i) {
                const std::uint32_t a = layer[i];
                const std::uint32_t b = layer[i + 1];
                if (groups_.group[a] != groups_.group[b] || groups_.leads[a] || gain(a, b) <= 0) continue;
                std::swap(layer[i], layer[i + 1]);
                std::swap(position_[a], position_[b]);
            }
        }
    }

    void swap_neighbouring_groups() {
        constexpr int kRounds = 2;
        constexpr std::size_t kMostGroups = 60;
        if (sequence_.size() > kMostGroups) return;
        for (int round = 0; round < kRounds; ++round) {
            bool better = false;
            for (std::size_t i = 0; i + 1 < sequence_.size() && best_crossings_ > 0; ++i) {
                const std::int64_t before = best_crossings_;
                std::swap(sequence_[i], sequence_[i + 1]);
                rank_sequence();
                g_.layers = best_;
                arrange_all();
                sweep(4);
                if (best_crossings_ < before) {
                    better = true;
                    continue;
                }
                std::swap(sequence_[i], sequence_[i + 1]);
                rank_sequence();
            }
            if (!better) return;
        }
    }

    LayeredGraph& g_;
    const NodeGroups& groups_;
    Progress& progress_;
    Adjacency up_;
    Adjacency down_;
    std::vector<std::uint32_t> position_;
    std::vector<double> key_;
    std::vector<std::uint32_t> sequence_; // groups, left to right
    std::vector<std::uint32_t> place_in_sequence_;
    std::vector<std::vector<std::uint32_t>> best_;
    std::int64_t best_crossings_ = 0;
};

} // namespace

void order_groups(LayeredGraph& graph, const NodeGroups& groups, Progress& progress) {
    if (groups.count == 0) return;
    GroupOrderer(graph, groups, progress).order();
}

} // namespace planum::strat
