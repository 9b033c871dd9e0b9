// SPDX-License-Identifier: MIT
#include "strat/layout/order_phase.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "strat/layout/path_mover.hpp"

namespace planum::strat {

namespace {

using Layers = std::vector<std::vector<std::uint32_t>>;

// Crossings of the edges of two nodes, whose ends are given in order, with `left` standing left, minus those with
// `right` there: for each end of `left` the ends of `right` below it, minus those above it. Most nodes have one.
std::int64_t inversions_saved(std::span<const std::uint32_t> left, std::span<const std::uint32_t> right) {
    if (left.size() == 1 && right.size() == 1) return (left[0] > right[0] ? 1 : 0) - (left[0] < right[0] ? 1 : 0);
    const std::uint32_t* const end = right.data() + right.size();
    const std::uint32_t* less = right.data();
    const std::uint32_t* more = less;
    std::ptrdiff_t sum = 0;
    for (const std::uint32_t a : left) {
        while (less != end && *less < a) ++less;
        while (more != end && *more <= a) ++more;
        sum += (less - right.data()) - (end - more);
    }
    return sum;
}

using EndIterator = std::vector<std::uint32_t>::iterator;

// Most nodes have one neighbour or two.
void sort_few(EndIterator first, EndIterator last) {
    if (last - first > 8) return std::sort(first, last);
    for (EndIterator i = first; i != last; ++i) {
        for (EndIterator j = i; j != first && *(j - 1) > *j; --j) std::iter_swap(j - 1, j);
    }
}

class Orderer {
  public:
    Orderer(LayeredGraph& graph, const OrderOptions& options, Progress& progress)
        : g_(graph), options_(options), progress_(progress), position_(graph.nodes, 0), layer_(graph.nodes, 0) {
        down_ = neighbours_below(g_);
        up_ = neighbours_above(g_);
        for (std::size_t l = 0; l < g_.layers.size(); ++l) {
            for (const std::uint32_t v : g_.layers[l]) layer_[v] = static_cast<std::uint32_t>(l);
        }
        number_all();
    }

    void order() {
        given_ = g_.layers;
        best_ = g_.layers;
        best_crossings_ = crossings();
        if (best_crossings_ == 0 && options_.keep_given) return;
        if (options_.keep_given) {
            switch_until_stuck(4);
            remember(crossings());
        } else {
            try_many();
        }
        g_.layers = best_;
    }

    [[nodiscard]] std::int64_t crossings() {
        std::int64_t sum = 0;
        for (std::size_t l = 0; l + 1 < g_.layers.size(); ++l) sum += crossings_below(l);
        crossed_everywhere_ = sum > std::ssize(g_.edges);
        return sum;
    }

  private:
    enum class Start { DepthFirst, BreadthFirst };
    enum class Centre { Barycentre, Median };

    void number(std::size_t l) {
        for (std::size_t i = 0; i < g_.layers[l].size(); ++i)
            position_[g_.layers[l][i]] = static_cast<std::uint32_t>(i);
    }

    void number_all() {
        for (std::size_t l = 0; l < g_.layers.size(); ++l) number(l);
    }

    // Inversions of the ends below, node by node from left to right: by insertion where there are few, which
    // costs no more than their number.
    std::int64_t crossings_below(std::size_t l) {
        constexpr std::size_t kFew = 64;
        ends_.clear();
        std::int64_t count = 0;
        for (const std::uint32_t u : g_.layers[l]) {
            const std::size_t before = ends_.size();
            for (const std::uint32_t v : down_.row(u)) ends_.push_back(position_[v]);
            if (ends_.size() > kFew) return crossings_by_tree(l);
            sort_few(ends_.begin() + static_cast<std::ptrdiff_t>(before), ends_.end());
            for (std::size_t i = before; i < ends_.size(); ++i) {
                std::size_t j = i;
                for (; j > 0 && ends_[j - 1] > ends_[j]; --j) std::swap(ends_[j - 1], ends_[j]);
                count += static_cast<std::int64_t>(i - j);
            }
        }
        return count;
    }

    // Barth, Jünger and Mutzel 2002: inversions counted with an accumulator tree.
    std::int64_t crossings_by_tree(std::size_t l) {
        const std::size_t width = g_.layers[l + 1].size();
        std::size_t leaves = 1;
        while (leaves < width) leaves *= 2;
        tree_.assign(2 * leaves, 0);
        std::int64_t count = 0;
        for (const std::uint32_t u : g_.layers[l]) {
            ends_.clear();
            for (const std::uint32_t v : down_.row(u)) ends_.push_back(position_[v]);
            std::sort(ends_.begin(), ends_.end());
            for (const std::uint32_t end : ends_) {
                for (std::size_t i = end + leaves; i > 1; i /= 2) {
                    if (i % 2 == 0) count += tree_[i + 1];
                }
            }
            for (const std::uint32_t end : ends_) {
                for (std::size_t i = end + leaves; i > 0; i /= 2) ++tree_[i];
            }
        }
        return count;
    }

    void remember(std::int64_t now) {
        if (now >= best_crossings_) return;
        best_crossings_ = now;
        best_ = g_.layers;
    }

    // Sweeps end in the valley nearest to where they began, and on sparse graphs valleys differ by factors. So
    // many beginnings get a few sweeps each, and the best of them are worked out.
    void try_many() {
        struct Beginning {
            std::int64_t crossings = 0;
            Layers layers;
        };

        std::vector<Beginning> beginnings;
        const auto edges = static_cast<std::int64_t>(g_.edges.size());
        const auto starts = std::clamp<std::int64_t>(24'000 / std::max<std::int64_t>(1, edges), 24, 160);
        constexpr std::int64_t kEnoughForDense = 8; // where edges cross everywhere, valleys are alike
        constexpr std::int64_t kHopeless = 2;       // times the best, which has had more sweeps
        std::int64_t best_of_beginnings = best_crossings_;
        for (std::int64_t start = 0; start < starts; ++start) {
            if (start > 1 && !spend(0)) break;
            if (start == kEnoughForDense && best_of_beginnings > edges) break;
            progress_.check();
            walk(start % 2 == 0 ? Start::DepthFirst : Start::BreadthFirst, start > 1);
            for (int sweep = 0; sweep < 4; ++sweep) sweep_once(sweep % 2 == 0, Centre::Barycentre);
            spend(edges * 40);
            if (start > 1 && crossings() > kHopeless * best_of_beginnings) continue;
            for (int sweep = 0; sweep < 4; ++sweep) sweep_once(sweep % 2 == 0, Centre::Barycentre);
            switch_until_stuck(3);
            beginnings.push_back({crossings(), g_.layers});
            spend(edges * 40);
            best_of_beginnings = std::min(best_of_beginnings, beginnings.back().crossings);
            if (best_of_beginnings == 0) break;
        }
        std::stable_sort(beginnings.begin(), beginnings.end(),
                         [](const Beginning& a, const Beginning& b) { return a.crossings < b.crossings; });
        constexpr std::int64_t kSmall = 600; // edges: there a third beginning costs nothing that anybody waits for
        const std::size_t worth = best_of_beginnings > edges ? 1 : edges > kSmall ? 2 : 3;
        const std::size_t worked_out = std::min(worth, beginnings.size());
        std::int64_t least_worked_out = std::numeric_limits<std::int64_t>::max();
        for (std::size_t i = 0; i < worked_out && best_crossings_ > 0; ++i) {
            // What is well behind the best seldom comes first in the end.
            if (edges > kSmall && 10 * beginnings[i].crossings > 11 * beginnings.front().crossings) break;
            g_.layers = beginnings[i].layers;
            number_all();
            work_out();
            if (edges > kSmall && i > 0 && 10 * round_crossings_ > 11 * least_worked_out) continue;
            least_worked_out = std::min(least_worked_out, round_crossings_);
            polish();
        }
    }

    void work_out() {
        round_best_ = g_.layers;
        round_crossings_ = crossings();
        int stuck = 0;
        constexpr int kMostSweeps = 24;
        constexpr int kPatience = 4;
        for (int sweep = 0; sweep < kMostSweeps && stuck < kPatience && round_crossings_ > 0; ++sweep) {
            progress_.check();
            sweep_once(sweep % 2 == 0, sweep % 4 < 2 ? Centre::Barycentre : Centre::Median);
            switch_until_stuck(3, sweep % 4 >= 2);
            const std::int64_t now = crossings();
            ++stuck;
            if (now < round_crossings_) {
                stuck = 0;
                round_crossings_ = now;
                round_best_ = g_.layers;
            }
            if (!spend(static_cast<std::int64_t>(g_.edges.size()) * 30)) break;
        }
        g_.layers = round_best_;
        number_all();
    }

    // What sweeps cannot do: whole paths to where they cross least, single nodes along their levels.
    void polish() {
        PathMover paths(g_, up_, down_, position_, layer_);
        constexpr int kRounds = 8;
        std::int64_t before = round_crossings_;
        for (int round = 0; round < kRounds && before > 0; ++round) {
            progress_.check();
            std::int64_t work = 0;
            paths.improve(work, 20'000'000 + 2'000 * static_cast<std::int64_t>(g_.edges.size()));
            sift_until_stuck();
            switch_until_stuck(10);
            const std::int64_t now = crossings();
            if (now >= before) break;
            before = now;
        }
        remember(crossings());
    }

    // False when no work is left.
    bool spend(std::int64_t work) {
        spent_ += work;
        const std::int64_t by_size = 20'000'000 + 1'000 * static_cast<std::int64_t>(g_.edges.size());
        return spent_ < (options_.work > 0 ? options_.work : by_size);
    }

    // Made, not drawn by chance: same input, same drawing.
    std::size_t draw(std::size_t below) {
        seed_ = seed_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<std::size_t>(seed_ >> 33U) % below;
    }

    // Neighbours found one after another stand side by side.
    void walk(Start start, bool shuffled) {
        std::vector<bool> seen(g_.nodes, false);
        for (std::vector<std::uint32_t>& layer : g_.layers) layer.clear();
        std::vector<std::uint32_t> open;
        std::vector<std::uint32_t> roots;
        roots.reserve(g_.nodes);
        for (const std::vector<std::uint32_t>& layer : given_) roots.insert(roots.end(), layer.begin(), layer.end());
        if (shuffled) std::swap(roots.front(), roots[draw(roots.size())]);
        for (const std::uint32_t root : roots) {
            if (seen[root]) continue;
            open.assign(1, root);
            for (std::size_t at = 0; at < open.size();) {
                std::uint32_t v = 0;
                if (start == Start::DepthFirst) {
                    v = open.back();
                    open.pop_back();
                } else {
                    v = open[at++];
                }
                if (seen[v]) continue;
                seen[v] = true;
                g_.layers[layer_[v]].push_back(v);
                const std::size_t first = open.size();
                for (const Adjacency* side : {&up_, &down_}) {
                    const auto row = side->row(v);
                    for (std::size_t i = row.size(); i-- > 0;) {
                        if (!seen[row[i]]) open.push_back(row[i]);
                    }
                }
                for (std::size_t i = open.size(); shuffled && i > first + 1; --i)
                    std::swap(open[i - 1], open[first + draw(i - first)]);
            }
        }
        number_all();
    }

    void sweep_once(bool downwards, Centre centre) {
        const std::size_t count = g_.layers.size();
        for (std::size_t step = 1; step < count; ++step) {
            sort_layer(downwards ? step : count - 1 - step, downwards ? up_ : down_, centre);
        }
    }

    // Nodes without a neighbour on the fixed side keep their places; the others are sorted around them.
    void sort_layer(std::size_t l, const Adjacency& fixed, Centre centre) {
        std::vector<std::uint32_t>& layer = g_.layers[l];
        keyed_.clear();
        for (const std::uint32_t v : layer) {
            const auto row = fixed.row(v);
            if (row.size() == 1) {
                keyed_.push_back({position_[row[0]], v});
            } else if (!row.empty()) {
                keyed_.push_back({centre_of(row, centre), v});
            }
        }
        if (!sort_keyed()) return;
        std::size_t next = 0;
        for (std::uint32_t& v : layer) {
            if (!fixed.row(v).empty()) v = keyed_[next++].second;
        }
        number(l);
    }

    // Levels are small and, after the first sweeps, nearly sorted. False if they were sorted already.
    bool sort_keyed() {
        constexpr std::size_t kSmall = 96;
        const auto by_key = [](const auto& a, const auto& b) { return a.first < b.first; };
        if (keyed_.size() > kSmall) {
            if (std::is_sorted(keyed_.begin(), keyed_.end(), by_key)) return false;
            std::stable_sort(keyed_.begin(), keyed_.end(), by_key);
            return true;
        }
        bool moved_any = false;
        for (std::size_t i = 1; i < keyed_.size(); ++i) {
            if (keyed_[i - 1].first <= keyed_[i].first) continue;
            const auto moved = keyed_[i];
            std::size_t j = i;
            for (; j > 0 && keyed_[j - 1].first > moved.first; --j) keyed_[j] = keyed_[j - 1];
            keyed_[j] = moved;
            moved_any = true;
        }
        return moved_any;
    }

    double centre_of(std::span<const std::uint32_t> neighbours, Centre centre) {
        if (centre == Centre::Barycentre) {
            double sum = 0.0;
            for (const std::uint32_t v : neighbours) sum += position_[v];
            return sum / static_cast<double>(neighbours.size());
        }
        ends_.clear();
        for (const std::uint32_t v : neighbours) ends_.push_back(position_[v]);
        std::sort(ends_.begin(), ends_.end());
        const std::size_t n = ends_.size();
        const std::size_t m = n / 2;
        if (n % 2 == 1) return ends_[m];
        if (n == 2) return (ends_[0] + ends_[1]) / 2.0;
        // Gansner et al. 1993: between the two medians, towards the side where the others stand closer.
        const double left = ends_[m - 1] - ends_.front();
        const double right = ends_.back() - ends_[m];
        if (left + right == 0.0) return (ends_[m - 1] + ends_[m]) / 2.0;
        return (ends_[m - 1] * right + ends_[m] * left) / (left + right);
    }

    // Sorted positions of the neighbours above and below of each node of one level.
    struct Ends {
        Adjacency up;
        Adjacency down;
    };

    void collect_ends(std::size_t l, Ends& ends) const {
        const std::vector<std::uint32_t>& layer = g_.layers[l];
        const auto fill = [&](Adjacency& out, const Adjacency& in) {
            std::size_t count = 0;
            for (const std::uint32_t v : layer) count += in.row(v).size();
            out.begin.resize(layer.size() + 1);
            out.values.resize(count);
            const auto values = out.values.begin();
            std::ptrdiff_t at = 0;
            for (std::size_t i = 0; i < layer.size(); ++i) {
                const std::ptrdiff_t first = at;
                out.begin[i] = static_cast<std::uint32_t>(at);
                for (const std::uint32_t w : in.row(layer[i])) values[at++] = position_[w];
                if (at - first > 1) sort_few(values + first, values + at);
            }
            out.begin[layer.size()] = static_cast<std::uint32_t>(at);
        };
        fill(ends.up, up_);
        fill(ends.down, down_);
    }

    // Crossings of two nodes (by their places when the ends were collected) with a left of b, minus those
    // with b left of a.
    [[nodiscard]] static std::int64_t gain(const Ends& ends, std::size_t a, std::size_t b) {
        return inversions_saved(ends.up.row(a), ends.up.row(b)) + inversions_saved(ends.down.row(a), ends.down.row(b));
    }

    // Marks the nodes of a level that have an edge which is crossed; only they have something to win. Ends go into
    // order by insertion, so that this costs no more than there are crossings. False if there are none.
    bool mark_crossed(const Ends& ends) {
        const std::size_t n = ends.up.rows();
        crossed_.assign(n, crossed_everywhere_ ? 1 : 0);
        if (crossed_everywhere_) return true;
        bool any = false;
        for (const Adjacency* side : {&ends.up, &ends.down}) {
            const std::size_t most = 6 * side->values.size(); // beyond, nearly all are
            std::size_t met = 0;
            sorted_.clear();
            for (std::uint32_t i = 0; i < n; ++i) {
                for (const std::uint32_t end : side->row(i)) {
                    sorted_.push_back({end, i});
                    std::size_t j = sorted_.size() - 1;
                    for (; j > 0 && sorted_[j - 1].first > end; --j) {
                        crossed_[i] = crossed_[sorted_[j - 1].second] = 1;
                        sorted_[j] = sorted_[j - 1];
                        ++met;
                    }
                    sorted_[j] = {end, i};
                }
                if (met <= most) continue;
                crossed_.assign(n, 1);
                return true;
            }
            any = any || met > 0;
        }
        return any;
    }

    // `also_equal` swaps neighbours in the first round even where nothing is won, which leads out of plains.
    void switch_until_stuck(int most_rounds, bool also_equal = false) {
        Ends ends;
        const std::size_t count = g_.layers.size();
        changed_.assign(count + 2, 1); // by level + 1: in the round before or in this one
        for (int round = 0; round < most_rounds; ++round) {
            bool better = false;
            for (std::size_t l = 0; l < count; ++l) {
                // Only where a neighbouring level changed can there be something to win again.
                if (round > 0 && changed_[l] == 0 && changed_[l + 1] == 0 && changed_[l + 2] == 0) continue;
                const bool switched = switch_layer(l, ends, also_equal && round == 0);
                changed_[l + 1] = switched ? 1 : 0;
                better = switched || better;
            }
            if (!better) return;
            if (!spend(static_cast<std::int64_t>(g_.edges.size()) * 10)) return;
        }
    }

    bool switch_layer(std::size_t l, Ends& ends, bool also_equal) {
        std::vector<std::uint32_t>& layer = g_.layers[l];
        if (layer.size() < 2) return false;
        collect_ends(l, ends);
        if (!also_equal && !mark_crossed(ends)) return false;
        std::vector<std::size_t>& row = rows_; // row of `ends` of the node at each place
        row.resize(layer.size());
        std::iota(row.begin(), row.end(), std::size_t{0});
        bool any = false;
        constexpr int kRounds = 6;
        for (int round = 0; round < kRounds; ++round) {
            bool better = false;
            for (std::size_t i = 0; i + 1 < layer.size(); ++i) {
                if (!also_equal && (crossed_[row[i]] == 0 || crossed_[row[i + 1]] == 0)) continue;
                if (is_held(layer[i]) && is_held(layer[i + 1])) continue;
                const std::int64_t won = gain(ends, row[i], row[i + 1]);
                if (won < 0 || (won == 0 && !(also_equal && round == 0))) continue;
                std::swap(row[i], row[i + 1]);
                std::swap(layer[i], layer[i + 1]);
                better = true;
            }
            any = any || better;
            if (!better) break;
        }
        if (any) number(l);
        return any;
    }

    [[nodiscard]] bool is_held(std::uint32_t node) const { return !options_.held.empty() && options_.held[node]; }

    void sift_until_stuck() {
        constexpr int kRounds = 6;
        Ends ends;
        for (int round = 0; round < kRounds; ++round) {
            progress_.check();
            bool better = false;
            for (std::size_t l = 0; l < g_.layers.size(); ++l) better = sift_layer(l, ends) || better;
            if (!better) return;
        }
    }

    // Each node is carried along its level to the place where its edges cross least (Matuszewski 1999).
    bool sift_layer(std::size_t l, Ends& ends) {
        std::vector<std::uint32_t>& layer = g_.layers[l];
        const std::size_t n = layer.size();
        if (n < 3) return false;
        if (!spend(static_cast<std::int64_t>(n * n) * 12)) return false;
        collect_ends(l, ends);
        if (!mark_crossed(ends)) return false;
        rows_.resize(n);
        std::iota(rows_.begin(), rows_.end(), std::size_t{0});
        bool any = false;
        for (std::size_t moved = 0; moved < n; ++moved) any = (crossed_[moved] != 0 && sift_node(moved, ends)) || any;
        if (!any) return false;
        const std::vector<std::uint32_t> before = layer;
        for (std::size_t i = 0; i < n; ++i) layer[i] = before[rows_[i]];
        number(l);
        return true;
    }

    bool sift_node(std::size_t moved, const Ends& ends) {
        const auto at = static_cast<std::size_t>(std::find(rows_.begin(), rows_.end(), moved) - rows_.begin());
        std::int64_t delta = 0; // crossings saved so far
        std::int64_t best = 0;
        std::size_t to = at;
        for (std::size_t i = at + 1; i < rows_.size(); ++i) {
            delta += gain(ends, moved, rows_[i]);
            if (delta > best) {
                best = delta;
                to = i;
            }
        }
        delta = 0;
        for (std::size_t i = at; i-- > 0;) {
            delta += gain(ends, rows_[i], moved);
            if (delta > best) {
                best = delta;
                to = i;
            }
        }
        if (to == at) return false;
        for (std::size_t i = std::min(at, to); i <= std::max(at, to); ++i) crossed_[rows_[i]] = 1; // some may be now
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(at));
        rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(to), moved);
        return true;
    }

    LayeredGraph& g_;
    const OrderOptions& options_;
    Progress& progress_;
    Adjacency up_;
    Adjacency down_;
    std::vector<std::uint32_t> position_; // by node, within its level
    std::vector<std::uint32_t> layer_;
    Layers given_;
    Layers best_;
    Layers round_best_;
    std::int64_t round_crossings_ = 0;
    std::int64_t best_crossings_ = 0;
    std::int64_t spent_ = 0;
    std::uint64_t seed_ = 1;
    // Kept between calls to save allocations.
    std::vector<std::uint32_t> tree_;
    std::vector<std::uint32_t> ends_;
    std::vector<std::pair<double, std::uint32_t>> keyed_;
    std::vector<std::size_t> rows_;
    bool crossed_everywhere_ = false; // when last counted
    std::vector<char> crossed_;       // by row of the level's ends
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted_;
    std::vector<char> changed_;
};

} // namespace

Adjacency neighbours_below(const LayeredGraph& graph) {
    return Adjacency::make(
        graph.nodes, graph.edges.size(), [&](std::size_t i) { return graph.edges[i].first; },
        [&](std::size_t i) { return graph.edges[i].second; });
}

Adjacency neighbours_above(const LayeredGraph& graph) {
    return Adjacency::make(
        graph.nodes, graph.edges.size(), [&](std::size_t i) { return graph.edges[i].second; },
        [&](std::size_t i) { return graph.edges[i].first; });
}

void order_layers(LayeredGraph& graph, const OrderOptions& options, Progress& progress) {
    Orderer(graph, options, progress).order();
}

std::int64_t count_crossings(const LayeredGraph& graph) {
    LayeredGraph copy = graph;
    const OrderOptions options;
    return Orderer(copy, options, Progress::none()).crossings();
}

} // namespace planum::strat
