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

// Invariant between pivots: `in_tree` is a spanning forest of tight arcs, one tree a component, rooted; `size`
// counts the nodes of each subtree; cut values are those of the forest. A pivot walks only over the smaller of
// the two parts that the leaving arc separates, and along the ring that the entering arc closes: numbering the
// nodes in postorder, as the original does, would touch nearly all of them each time.
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
        root_forest();
        cut_values();
        for (std::int64_t pivots = 0; pivots < max_pivots; ++pivots) {
            const std::uint32_t leaving = leaving_arc();
            if (leaving == kNone) break;
            pivot(leaving);
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
        in_tree_.assign(arcs_.size(), 0);
        joined_.assign(n_, 0);
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
            joined_[v] = 1;
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
            in_tree_[a] = 1;
            join(out ? arcs_[a].to : arcs_[a].from);
        }
        for (const std::uint32_t v : tree) rank_[v] += moved;
    }

    void root_forest() {
        first_link_.assign(n_, kNone);
        links_.assign(2 * arcs_.size(), {});
        for (std::uint32_t a = 0; a < arcs_.size(); ++a) {
            if (in_tree_[a]) link(a);
        }
        parent_.assign(n_, kNone);
        root_.assign(n_, kNone);
        size_.assign(n_, 1);
        seen_.assign(n_, 0);
        parents_first_.clear();
        for (std::uint32_t v = 0; v < n_; ++v) {
            if (root_[v] == kNone) root_tree(v);
        }
        for (std::size_t i = n_; i-- > 0;) {
            const std::uint32_t v = parents_first_[i];
            if (parent_[v] != kNone) size_[other_end(parent_[v], v)] += size_[v];
        }
    }

    // A tree arc in the list of one of its ends.
    struct Link {
        std::uint32_t next = kNone;
        std::uint32_t previous = kNone;
        std::uint32_t end = kNone; // the other end
    };

    void link(std::uint32_t a) {
        for (const std::uint32_t side : {0U, 1U}) {
            const std::uint32_t node = side == 0 ? arcs_[a].from : arcs_[a].to;
            const std::uint32_t l = 2 * a + side;
            links_[l] = {first_link_[node], kNone, side == 0 ? arcs_[a].to : arcs_[a].from};
            if (links_[l].next != kNone) links_[links_[l].next].previous = l;
            first_link_[node] = l;
        }
    }

    void unlink(std::uint32_t a) {
        for (const std::uint32_t side : {0U, 1U}) {
            const Link& l = links_[2 * a + side];
            if (l.next != kNone) links_[l.next].previous = l.previous;
            if (l.previous != kNone) links_[l.previous].next = l.next;
            if (l.previous == kNone) first_link_[side == 0 ? arcs_[a].from : arcs_[a].to] = l.next;
        }
    }

    void root_tree(std::uint32_t root) {
        std::size_t at = parents_first_.size();
        root_[root] = root;
        parents_first_.push_back(root);
        for (; at < parents_first_.size(); ++at) {
            const std::uint32_t v = parents_first_[at];
            for (std::uint32_t l = first_link_[v]; l != kNone; l = links_[l].next) {
                if (l / 2 == parent_[v]) continue;
                const std::uint32_t child = links_[l].end;
                parent_[child] = l / 2;
                root_[child] = root;
                parents_first_.push_back(child);
            }
        }
    }

    [[nodiscard]] std::uint32_t other_end(std::uint32_t a, std::uint32_t v) const {
        return arcs_[a].from == v ? arcs_[a].to : arcs_[a].from;
    }

    // Of a tree arc's two ends, the one further from the root.
    [[nodiscard]] std::uint32_t lower_end(std::uint32_t a) const {
        return parent_[arcs_[a].from] == a ? arcs_[a].from : arcs_[a].to;
    }

    // From the leaves upwards: the cut value of a node's parent arc follows from its other arcs.
    void cut_values() {
        cut_.assign(arcs_.size(), 0);
        for (std::size_t i = n_; i-- > 0;) {
            const std::uint32_t v = parents_first_[i];
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

    // Cyclic search, as the original advises: successive pivots find different parts of the graph. Of the first few
    // found the one that wins most for each node that the pivot walks over. Cut values outside the forest are 0.
    [[nodiscard]] std::uint32_t leaving_arc() {
        std::uint32_t best = kNone;
        double best_worth = 0.0;
        int found = 0;
        constexpr int kEnough = 8;
        constexpr double kAnyPivot = 8.0; // what a pivot costs besides, in nodes walked over
        const auto search = [&](std::size_t first, std::size_t last) {
            for (std::size_t a = first; a < last; ++a) {
                if (cut_[a] >= 0) continue;
                search_ = a + 1;
                const auto arc = static_cast<std::uint32_t>(a);
                const double worth = static_cast<double>(-cut_[a]) / (kAnyPivot + smaller_part(arc));
                if (worth > best_worth) {
                    best = arc;
                    best_worth = worth;
                }
                if (++found >= kEnough) return;
            }
        };
        const std::size_t from = search_;
        search(from, arcs_.size());
        if (found < kEnough) search(0, from);
        return best;
    }

    // Nodes of the smaller of the two parts that a tree arc joins.
    [[nodiscard]] std::uint32_t smaller_part(std::uint32_t tree_arc) const {
        const std::uint32_t top = lower_end(tree_arc);
        return std::min(size_[top], size_[root_[top]] - size_[top]);
    }

    // The smaller of the two parts of the tree without the leaving arc, marked as seen. Returns the leaving arc's
    // end in it.
    std::uint32_t collect_part(std::uint32_t leaving) {
        const std::uint32_t top = lower_end(leaving);
        const bool lower = 2 * size_[top] <= size_[root_[top]];
        const std::uint32_t start = lower ? top : other_end(leaving, top);
        ++mark_;
        part_.assign(1, start);
        seen_[start] = mark_;
        for (std::size_t at = 0; at < part_.size(); ++at) {
            const std::uint32_t v = part_[at];
            for (std::uint32_t l = first_link_[v]; l != kNone; l = links_[l].next) {
                const std::uint32_t w = links_[l].end;
                if (seen_[w] == mark_ || l / 2 == leaving) continue;
                seen_[w] = mark_;
                part_.push_back(w);
            }
        }
        return start;
    }

    // The arc of least slack that joins the two parts in the opposite direction.
    [[nodiscard]] std::uint32_t entering_arc(bool leaves_part) const {
        const Adjacency& side = leaves_part ? in_ : out_;
        std::uint32_t best = kNone;
        for (const std::uint32_t v : part_) {
            for (const std::uint32_t a : side.row(v)) {
                if (seen_[leaves_part ? arcs_[a].from : arcs_[a].to] == mark_) continue;
                if (best == kNone || slack(a) < slack(best)) best = a;
            }
        }
        if (best == kNone) throw Error(ErrorCode::Internal, "the levels of the drawing do not converge");
        return best;
    }

    void pivot(std::uint32_t leaving) {
        const bool leaves_part = arcs_[leaving].from == collect_part(leaving);
        const std::uint32_t entering = entering_arc(leaves_part);
        const std::int32_t gap = slack(entering);
        for (const std::uint32_t v : part_) rank_[v] += leaves_part ? -gap : gap;
        const std::uint32_t common = update_cuts(leaving, entering);
        in_tree_[leaving] = 0;
        in_tree_[entering] = 1;
        unlink(leaving);
        link(entering);
        cut_[leaving] = 0;
        hang_over(leaving, entering, common);
    }

    [[nodiscard]] std::uint32_t common_ancestor(std::uint32_t a, std::uint32_t b) {
        ++mark_;
        while (true) {
            for (std::uint32_t* v : {&a, &b}) {
                if (*v == kNone) continue;
                if (seen_[*v] == mark_) return *v;
                seen_[*v] = mark_;
                *v = parent_[*v] == kNone ? kNone : other_end(parent_[*v], *v);
            }
        }
    }

    // Cut values change only on the tree path between the ends of the entering arc. Returns the path's
    // highest node.
    std::uint32_t update_cuts(std::uint32_t leaving, std::uint32_t entering) {
        const std::int64_t delta = cut_[leaving];
        const std::uint32_t common = common_ancestor(arcs_[entering].from, arcs_[entering].to);
        for (const bool from : {true, false}) {
            for (std::uint32_t v = from ? arcs_[entering].from : arcs_[entering].to; v != common;) {
                const std::uint32_t a = parent_[v];
                cut_[a] += (arcs_[a].from == v) == from ? delta : -delta;
                v = other_end(a, v);
            }
        }
        cut_[entering] = -delta;
        return common;
    }

    // The part below the leaving arc hangs from the entering one now: parents turn round on the way from there to
    // its old top, and only subtrees on the ring change their size.
    void hang_over(std::uint32_t leaving, std::uint32_t entering, std::uint32_t common) {
        const std::uint32_t top = lower_end(leaving);
        const std::uint32_t moved = size_[top];
        const std::uint32_t inside =
            below(arcs_[entering].from, top, common) ? arcs_[entering].from : arcs_[entering].to;
        for (std::uint32_t v = other_end(leaving, top); v != common; v = other_end(parent_[v], v)) size_[v] -= moved;
        for (std::uint32_t v = other_end(entering, inside); v != common; v = other_end(parent_[v], v))
            size_[v] += moved;
        std::uint32_t via = entering;
        std::uint32_t passed = 0; // old size of the subtree that now hangs from above
        for (std::uint32_t v = inside;;) {
            const std::uint32_t old = size_[v];
            size_[v] = moved - passed;
            passed = old;
            const std::uint32_t up = parent_[v];
            parent_[v] = via;
            if (v == top) break;
            via = up;
            v = other_end(up, v);
        }
    }

    // Whether the way up from v to the common ancestor passes `top`.
    [[nodiscard]] bool below(std::uint32_t v, std::uint32_t top, std::uint32_t common) const {
        for (; v != common; v = other_end(parent_[v], v)) {
            if (v == top) return true;
        }
        return false;
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
    std::vector<char> in_tree_;
    std::vector<char> joined_;
    std::vector<Link> links_;               // of arc a: 2a at its `from`, 2a + 1 at its `to`
    std::vector<std::uint32_t> first_link_; // by node
    std::vector<std::uint32_t> parents_first_;
    std::vector<std::uint32_t> parent_; // arc to the parent
    std::vector<std::uint32_t> size_;
    std::vector<std::uint32_t> root_;
    std::vector<std::int64_t> cut_;
    std::vector<std::uint64_t> seen_; // by node: the last mark it got
    std::uint64_t mark_ = 0;
    std::vector<std::uint32_t> part_;
    std::size_t search_ = 0;
};

} // namespace

std::vector<std::int32_t> network_simplex(std::uint32_t nodes, const std::vector<RankArc>& arcs,
                                          std::int64_t max_pivots, const std::vector<std::int32_t>& start) {
    if (nodes == 0) return {};
    return Simplex(nodes, arcs).solve(arcs.empty() ? 0 : max_pivots, start);
}

} // namespace planum::strat
