// SPDX-License-Identifier: MIT
#include "strat/layout/network_simplex.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/base/error.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

namespace {

constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

// Invariant between pivots: `in_tree` is a spanning forest of tight arcs, one tree a component, rooted;
// post/low number each tree in postorder, so that "x is below y" is two comparisons; cut values are those
// of the forest.
class Simplex {
  public:
    Simplex(std::uint32_t nodes, const std::vector<RankArc>& arcs) : n_(nodes), arcs_(arcs) {
        const auto identity = [](std::size_t i) { return i; };
        out_ = Adjacency::make(
            n_, arcs.size(), [&](std::size_t i) { return arcs[i].from; }, identity);
        in_ = Adjacency::make(
            n_, arcs.size(), [&](std::size_t i) { return arcs[i].to; }, identity);
    }

    std::vector<std::int32_t> solve(std::int64_t max_pivots, const std::vector<std::int32_t>& start) {
        if (start.empty()) {
            longest_paths();
        } else {
            rank_ = start;
        }
        tight_forest();
        number_forest();
        cut_values();
        for (std::int64_t pivot = 0; pivot < max_pivots; ++pivot) {
            const std::uint32_t leaving = leaving_arc();
            if (leaving == kNone) break;
            exchange(leaving, entering_arc(leaving));
        }
        normalise();
        return std::move(rank_);
    }

  private:
    [[nodiscard]] std::int32_t slack(std::uint32_t a) const {
        return rank_[arcs_[a].to] - rank_[arcs_[a].from] - arcs_[a].length;
    }

    void longest_paths() {
        rank_.assign(n_, 0);
        std::vector<std::uint32_t> waiting(n_, 0);
        for (const RankArc& a : arcs_) ++waiting[a.to];
        std::vector<std::uint32_t> open;
        for (std::uint32_t v = 0; v < n_; ++v) {
            if (waiting[v] == 0) open.push_back(v);
        }
        std::size_t done = 0;
        for (; done < open.size(); ++done) {
            for (const std::uint32_t a : out_.row(open[done])) {
                const RankArc& arc = arcs_[a];
                rank_[arc.to] = std::max(rank_[arc.to], rank_[arc.from] + arc.length);
                if (--waiting[arc.to] == 0) open.push_back(arc.to);
            }
        }
        if (done != n_) throw Error(ErrorCode::Internal, "levels were asked of a graph with a cycle");
    }

    // Grows each tree from a root by the arc of least slack that leaves it, moving the whole tree so that the arc
    // becomes tight. The move is kept apart as one number, so that slacks of waiting arcs need no update.
    void tight_forest() {
        in_tree_.assign(arcs_.size(), false);
        joined_.assign(n_, false);
        for (std::uint32_t root = 0; root < n_; ++root) {
            if (!joined_[root]) grow_tree(root);
        }
    }

    struct Waiting {
        std::int64_t key = 0; // slack, less what the tree's move does to it
        std::uint32_t arc = 0;

        bool operator>(const Waiting& o) const { return key != o.key ? key > o.key : arc > o.arc; }
    };

    using WaitingArcs = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

    void grow_tree(std::uint32_t root) {
        std::vector<std::uint32_t> tree;
        WaitingArcs leaving;  // from the tree outwards: slack = key − moved
        WaitingArcs arriving; // into the tree: slack = key + moved
        std::int32_t moved = 0;
        const auto join = [&](std::uint32_t v) {
            joined_[v] = true;
            rank_[v] -= moved;
            tree.push_back(v);
            for (const std::uint32_t a : out_.row(v)) {
                if (!joined_[arcs_[a].to]) leaving.push({slack(a), a});
            }
            for (const std::uint32_t a : in_.row(v)) {
                if (!joined_[arcs_[a].from]) arriving.push({slack(a), a});
            }
        };
        join(root);
        while (true) {
            while (!leaving.empty() && joined_[arcs_[leaving.top().arc].to]) leaving.pop();
            while (!arriving.empty() && joined_[arcs_[arriving.top().arc].from]) arriving.pop();
            if (leaving.empty() && arriving.empty()) break;
            const bool out =
                arriving.empty() || (!leaving.empty() && leaving.top().key - moved <= arriving.top().key + moved);
            const std::uint32_t a = out ? leaving.top().arc : arriving.top().arc;
            if (out) {
                moved = static_cast<std::int32_t>(leaving.top().key);
            } else {
                moved = static_cast<std::int32_t>(-arriving.top().key);
            }
            in_tree_[a] = true;
            join(out ? arcs_[a].to : arcs_[a].from);
        }
        for (const std::uint32_t v : tree) rank_[v] += moved;
    }

    void number_forest() {
        tree_arcs_.assign(n_, {});
        for (std::uint32_t a = 0; a < arcs_.size(); ++a) {
            if (!in_tree_[a]) continue;
            tree_arcs_[arcs_[a].from].push_back(a);
            tree_arcs_[arcs_[a].to].push_back(a);
        }
        post_.assign(n_, 0);
        low_.assign(n_, 0);
        parent_.assign(n_, kNone);
        root_.assign(n_, kNone);
        std::uint32_t next = 1;
        for (std::uint32_t v = 0; v < n_; ++v) {
            if (post_[v] != 0) continue;
            root_[v] = v;
            next = number_tree(v, kNone, next);
        }
    }

    // Postorder without recursion: chains of thousands of units are real.
    std::uint32_t number_tree(std::uint32_t start, std::uint32_t via, std::uint32_t next) {
        stack_.clear();
        stack_.push_back({start, 0});
        parent_[start] = via;
        low_[start] = next;
        while (!stack_.empty()) {
            auto& [v, at] = stack_.back();
            if (at < tree_arcs_[v].size()) {
                const std::uint32_t a = tree_arcs_[v][at++];
                if (a == parent_[v]) continue;
                const std::uint32_t child = arcs_[a].from == v ? arcs_[a].to : arcs_[a].from;
                parent_[child] = a;
                root_[child] = root_[v];
                low_[child] = next;
                stack_.push_back({child, 0});
                continue;
            }
            post_[v] = next++;
            stack_.pop_back();
        }
        return next;
    }

    // Of a tree arc's two ends, the one further from the root.
    [[nodiscard]] std::uint32_t lower_end(std::uint32_t a) const {
        return parent_[arcs_[a].from] == a ? arcs_[a].from : arcs_[a].to;
    }

    [[nodiscard]] bool below(std::uint32_t v, std::uint32_t top) const {
        return low_[top] <= post_[v] && post_[v] <= post_[top];
    }

    // From the leaves upwards: the cut value of a node's parent arc follows from its other arcs.
    void cut_values() {
        cut_.assign(arcs_.size(), 0);
        std::vector<std::uint32_t> order(n_);
        for (std::uint32_t v = 0; v < n_; ++v) order[post_[v] - 1] = v;
        for (const std::uint32_t v : order) {
            if (parent_[v] != kNone) cut_[parent_[v]] = cut_of(parent_[v], v);
        }
    }

    // Gansner et al., fig. 2-3: sum over the arcs at v, tree arcs below contributing their own cut values.
    [[nodiscard]] std::int64_t cut_of(std::uint32_t tree_arc, std::uint32_t v) const {
        const int direction = arcs_[tree_arc].from == v ? 1 : -1;
        std::int64_t sum = 0;
        for (const Adjacency* side : {&out_, &in_}) {
            for (const std::uint32_t a : side->row(v)) {
                const bool leaves = arcs_[a].from == v;
                const int sign = (leaves ? 1 : -1) * direction;
                if (a == tree_arc) {
                    sum += arcs_[a].weight;
                } else if (in_tree_[a]) {
                    sum += sign * (arcs_[a].weight - cut_[a]);
                } else {
                    sum += sign * arcs_[a].weight;
                }
            }
        }
        return sum;
    }

    // Cyclic search, as the original advises: successive pivots find different parts of the graph.
    [[nodiscard]] std::uint32_t leaving_arc() {
        std::uint32_t best = kNone;
        int found = 0;
        constexpr int kEnough = 30;
        for (std::size_t step = 0; step < arcs_.size(); ++step) {
            const auto a = static_cast<std::uint32_t>(search_);
            search_ = search_ + 1 == arcs_.size() ? 0 : search_ + 1;
            if (!in_tree_[a] || cut_[a] >= 0) continue;
            if (best == kNone || cut_[a] < cut_[best]) best = a;
            if (++found >= kEnough) break;
        }
        return best;
    }

    // The arc of least slack that joins the two halves in the opposite direction.
    [[nodiscard]] std::uint32_t entering_arc(std::uint32_t leaving) {
        const std::uint32_t top = lower_end(leaving);
        const bool enters_below = arcs_[leaving].from == top; // wanted: arcs into the lower half
        const Adjacency& side = enters_below ? in_ : out_;
        std::uint32_t best = kNone;
        stack_.clear();
        stack_.push_back({top, 0});
        while (!stack_.empty()) {
            const std::uint32_t v = stack_.back().first;
            stack_.pop_back();
            for (const std::uint32_t a : side.row(v)) {
                const std::uint32_t other = enters_below ? arcs_[a].from : arcs_[a].to;
                if (in_tree_[a] || below(other, top)) continue;
                if (best == kNone || slack(a) < slack(best)) best = a;
            }
            for (const std::uint32_t a : tree_arcs_[v]) {
                if (a == parent_[v]) continue;
                stack_.push_back({arcs_[a].from == v ? arcs_[a].to : arcs_[a].from, 0});
            }
        }
        if (best == kNone) throw Error(ErrorCode::Internal, "the levels of the drawing do not converge");
        return best;
    }

    void exchange(std::uint32_t leaving, std::uint32_t entering) {
        const std::uint32_t top = lower_end(leaving);
        const std::int32_t gap = slack(entering);
        if (gap > 0) shift_below(top, arcs_[leaving].from == top ? -gap : gap);
        const std::uint32_t common = update_cuts(leaving, entering);
        in_tree_[leaving] = false;
        in_tree_[entering] = true;
        std::erase(tree_arcs_[arcs_[leaving].from], leaving);
        std::erase(tree_arcs_[arcs_[leaving].to], leaving);
        tree_arcs_[arcs_[entering].from].push_back(entering);
        tree_arcs_[arcs_[entering].to].push_back(entering);
        cut_[leaving] = 0;
        number_tree(common, parent_[common], low_[common]);
    }

    // The lower half moves so that the entering arc becomes tight.
    void shift_below(std::uint32_t top, std::int32_t by) {
        stack_.clear();
        stack_.push_back({top, 0});
        while (!stack_.empty()) {
            const std::uint32_t v = stack_.back().first;
            stack_.pop_back();
            rank_[v] += by;
            for (const std::uint32_t a : tree_arcs_[v]) {
                if (a == parent_[v]) continue;
                stack_.push_back({arcs_[a].from == v ? arcs_[a].to : arcs_[a].from, 0});
            }
        }
    }

    // Cut values change only on the tree path between the ends of the entering arc. Returns the path's
    // highest node.
    std::uint32_t update_cuts(std::uint32_t leaving, std::uint32_t entering) {
        const std::int64_t delta = cut_[leaving];
        const std::uint32_t from = arcs_[entering].from;
        const std::uint32_t to = arcs_[entering].to;
        std::uint32_t v = from;
        while (!below(to, v)) {
            const std::uint32_t a = parent_[v];
            cut_[a] += arcs_[a].from == v ? delta : -delta;
            v = arcs_[a].from == v ? arcs_[a].to : arcs_[a].from;
        }
        const std::uint32_t common = v;
        v = to;
        while (v != common) {
            const std::uint32_t a = parent_[v];
            cut_[a] += arcs_[a].from == v ? -delta : delta;
            v = arcs_[a].from == v ? arcs_[a].to : arcs_[a].from;
        }
        cut_[entering] = -delta;
        return common;
    }

    void normalise() {
        std::vector<std::int32_t> least(n_, std::numeric_limits<std::int32_t>::max());
        for (std::uint32_t v = 0; v < n_; ++v) least[root_[v]] = std::min(least[root_[v]], rank_[v]);
        for (std::uint32_t v = 0; v < n_; ++v) rank_[v] -= least[root_[v]];
    }

    std::uint32_t n_;
    const std::vector<RankArc>& arcs_;
    Adjacency out_;
    Adjacency in_;
    std::vector<std::int32_t> rank_;
    std::vector<bool> in_tree_;
    std::vector<bool> joined_;
    std::vector<std::vector<std::uint32_t>> tree_arcs_; // by node
    std::vector<std::uint32_t> post_;
    std::vector<std::uint32_t> low_;
    std::vector<std::uint32_t> parent_; // arc to the parent
    std::vector<std::uint32_t> root_;
    std::vector<std::int64_t> cut_;
    std::vector<std::pair<std::uint32_t, std::size_t>> stack_;
    std::size_t search_ = 0;
};

} // namespace

std::vector<std::int32_t> network_simplex(std::uint32_t nodes, const std::vector<RankArc>& arcs,
                                          std::int64_t max_pivots, const std::vector<std::int32_t>& start) {
    if (nodes == 0) return {};
    return Simplex(nodes, arcs).solve(arcs.empty() ? 0 : max_pivots, start);
}

} // namespace planum::strat
