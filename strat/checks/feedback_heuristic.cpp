// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "strat/checks/feedback_arcs.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

namespace {

constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

// Weights are compared with a little tolerance, so that rounding decides nothing.
constexpr double kTiny = 1e-12;

struct Graph {
    std::size_t nodes;
    std::span<const WeightedArc> arcs;
    Adjacency out; ///< arc positions by tail
    Adjacency in;  ///< by head

    Graph(std::size_t n, std::span<const WeightedArc> a) : nodes(n), arcs(a) {
        out = Adjacency::make(
            n, a.size(), [&](std::size_t i) { return a[i].from; }, [](std::size_t i) { return i; });
        in = Adjacency::make(
            n, a.size(), [&](std::size_t i) { return a[i].to; }, [](std::size_t i) { return i; });
    }
};

// Demetrescu and Finocchi: every cycle met pays the least weight on it; an arc that is paid off goes. One
// depth-first search does it: when an arc on the stack goes, the search falls back to its tail and goes
// on from there, nodes it fell out of are visited again.
class LocalRatio {
  public:
    LocalRatio(const Graph& graph, std::size_t first_root, bool backwards)
        : g_(graph), backwards_(backwards), first_root_(first_root), removed_(graph.arcs.size(), 0),
          residual_(graph.arcs.size()), next_(graph.nodes, 0), place_(graph.nodes, kNone), done_(graph.nodes, 0) {
        for (std::size_t i = 0; i < graph.arcs.size(); ++i) residual_[i] = graph.arcs[i].weight;
    }

    [[nodiscard]] std::vector<char> run() {
        for (std::size_t i = 0; i < g_.nodes; ++i) {
            const auto root = static_cast<std::uint32_t>((i + first_root_) % g_.nodes);
            if (done_[root] == 0) search(root);
        }
        return std::move(removed_);
    }

    /// What all cycles met have paid; no feedback set weighs less, since it must pay for each of them.
    [[nodiscard]] double paid() const { return paid_; }

  private:
    const Graph& g_;
    double paid_ = 0.0;
    bool backwards_;
    std::size_t first_root_;
    std::vector<char> removed_;
    std::vector<double> residual_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> place_; // on the stack
    std::vector<char> done_;
    std::vector<std::uint32_t> stack_;
    std::vector<std::uint32_t> entered_by_; // arc by which the stack's node was entered

    void push(std::uint32_t node, std::uint32_t arc) {
        place_[node] = static_cast<std::uint32_t>(stack_.size());
        stack_.push_back(node);
        entered_by_.push_back(arc);
    }

    void pop() {
        place_[stack_.back()] = kNone;
        stack_.pop_back();
        entered_by_.pop_back();
    }

    void search(std::uint32_t root) {
        push(root, kNone);
        while (!stack_.empty()) {
            const std::uint32_t node = stack_.back();
            const auto row = g_.out.row(node);
            if (next_[node] == row.size()) {
                done_[node] = 1;
                pop();
                continue;
            }
            const std::uint32_t arc = backwards_ ? row[row.size() - 1 - next_[node]] : row[next_[node]];
            const std::uint32_t to = g_.arcs[arc].to;
            if (removed_[arc] != 0 || done_[to] != 0) {
                ++next_[node];
            } else if (place_[to] == kNone) {
                push(to, arc);
            } else {
                pay(arc, place_[to]);
            }
        }
    }

    // The cycle is the stack from `bottom` up, closed by `arc`.
    void pay(std::uint32_t arc, std::size_t bottom) {
        double least = residual_[arc];
        for (std::size_t i = bottom + 1; i < stack_.size(); ++i) least = std::min(least, residual_[entered_by_[i]]);
        paid_ += least;
        residual_[arc] -= least;
        if (residual_[arc] <= kTiny) removed_[arc] = 1;
        std::size_t keep = stack_.size();
        for (std::size_t i = stack_.size(); i-- > bottom + 1;) {
            const std::uint32_t by = entered_by_[i];
            residual_[by] -= least;
            if (residual_[by] <= kTiny) {
                removed_[by] = 1;
                keep = i;
            }
        }
        while (stack_.size() > keep) pop();
    }
};

// An order of the nodes that arcs are put into one by one; an arc that would close a cycle is refused
// (Pearce, Kelly 2006: only the nodes between the two ends move).
class GrowingOrder {
  public:
    GrowingOrder(const Graph& graph, std::vector<char>& left_out, std::uint64_t budget)
        : g_(graph), left_out_(left_out), budget_(budget), seen_(graph.nodes, 0) {
        sort();
    }

    /// Takes the arc back in unless it closes a cycle or the budget is used up.
    bool take(std::uint32_t arc) {
        const auto [from, to, weight] = g_.arcs[arc];
        if (from == to) return false;
        if (place_[from] > place_[to]) {
            if (!rearrange(from, to)) return false;
        }
        left_out_[arc] = 0;
        return true;
    }

    [[nodiscard]] const std::vector<std::uint32_t>& place() const { return place_; }

  private:
    const Graph& g_;
    std::vector<char>& left_out_;
    std::uint64_t budget_; // arcs that may still be looked at
    std::vector<char> seen_;
    std::vector<std::uint32_t> place_;

    void sort() {
        std::vector<std::uint32_t> waiting(g_.nodes, 0);
        for (std::size_t i = 0; i < g_.arcs.size(); ++i) {
            if (left_out_[i] == 0) ++waiting[g_.arcs[i].to];
        }
        std::vector<std::uint32_t> queue;
        for (std::uint32_t v = 0; v < g_.nodes; ++v) {
            if (waiting[v] == 0) queue.push_back(v);
        }
        place_.assign(g_.nodes, 0);
        for (std::size_t at = 0; at < queue.size(); ++at) {
            place_[queue[at]] = static_cast<std::uint32_t>(at);
            for (const std::uint32_t arc : g_.out.row(queue[at])) {
                if (left_out_[arc] == 0 && --waiting[g_.arcs[arc].to] == 0) queue.push_back(g_.arcs[arc].to);
            }
        }
    }

    // Nodes reached from `start` without leaving the places between the two ends.
    template<class Row, class Next, class Inside>
    bool reach(std::uint32_t start, std::uint32_t stop, std::vector<std::uint32_t>& found, Row row, Next next,
               Inside inside) {
        found = {start};
        seen_[start] = 1;
        for (std::size_t at = 0; at < found.size(); ++at) {
            for (const std::uint32_t arc : row(found[at])) {
                if (budget_ == 0) return false;
                --budget_;
                const std::uint32_t to = next(arc);
                if (left_out_[arc] != 0 || seen_[to] != 0 || !inside(place_[to])) continue;
                if (to == stop) return false;
                seen_[to] = 1;
                found.push_back(to);
            }
        }
        return true;
    }

    bool rearrange(std::uint32_t from, std::uint32_t to) {
        const std::uint32_t first = place_[to];
        const std::uint32_t last = place_[from];
        std::vector<std::uint32_t> after;
        std::vector<std::uint32_t> before;
        bool free = reach(
            to, from, after, [&](std::uint32_t v) { return g_.out.row(v); },
            [&](std::uint32_t arc) { return g_.arcs[arc].to; }, [&](std::uint32_t p) { return p <= last; });
        if (free) {
            free = reach(
                from, to, before, [&](std::uint32_t v) { return g_.in.row(v); },
                [&](std::uint32_t arc) { return g_.arcs[arc].from; }, [&](std::uint32_t p) { return p >= first; });
        }
        for (const std::uint32_t v : after) seen_[v] = 0;
        for (const std::uint32_t v : before) seen_[v] = 0;
        if (!free) return false;
        const auto by_place = [&](std::uint32_t a, std::uint32_t b) { return place_[a] < place_[b]; };
        std::sort(after.begin(), after.end(), by_place);
        std::sort(before.begin(), before.end(), by_place);
        std::vector<std::uint32_t> nodes = before;
        nodes.insert(nodes.end(), after.begin(), after.end());
        std::vector<std::uint32_t> places;
        places.reserve(nodes.size());
        for (const std::uint32_t v : nodes) places.push_back(place_[v]);
        std::sort(places.begin(), places.end());
        for (std::size_t i = 0; i < nodes.size(); ++i) place_[nodes[i]] = places[i];
        return true;
    }
};

// Sifting: every node in turn goes to the place among its neighbours where least weight runs backwards.
class Sifting {
  public:
    Sifting(const Graph& graph, const std::vector<std::uint32_t>& place)
        : g_(graph), key_(graph.nodes), before_(graph.nodes, kNone), after_(graph.nodes, kNone) {
        order_.resize(graph.nodes);
        for (std::uint32_t v = 0; v < graph.nodes; ++v) order_[place[v]] = v;
        renumber();
    }

    void run(int passes) {
        for (int pass = 0; pass < passes; ++pass) {
            bool moved = false;
            const std::vector<std::uint32_t> turn = order_;
            for (const std::uint32_t v : turn) moved = sift(v) || moved;
            collect();
            renumber();
            if (!moved) return;
        }
    }

    [[nodiscard]] std::vector<char> backward() const {
        std::vector<char> flags(g_.arcs.size(), 0);
        for (std::size_t i = 0; i < g_.arcs.size(); ++i) {
            flags[i] = key_[g_.arcs[i].from] >= key_[g_.arcs[i].to] ? 1 : 0;
        }
        return flags;
    }

  private:
    const Graph& g_;
    std::vector<double> key_; // place as a number with room between
    std::vector<std::uint32_t> before_;
    std::vector<std::uint32_t> after_;
    std::vector<std::uint32_t> order_;

    struct Neighbour {
        double key;
        std::uint32_t node;
        double change; // of the backward weight when v steps behind this neighbour
    };

    std::vector<Neighbour> near_;

    void renumber() {
        for (std::size_t i = 0; i < order_.size(); ++i) {
            key_[order_[i]] = static_cast<double>(i);
            before_[order_[i]] = i == 0 ? kNone : order_[i - 1];
            after_[order_[i]] = i + 1 == order_.size() ? kNone : order_[i + 1];
        }
    }

    void collect() {
        std::uint32_t first = order_.front();
        while (before_[first] != kNone) first = before_[first];
        order_.clear();
        for (std::uint32_t v = first; v != kNone; v = after_[v]) order_.push_back(v);
    }

    bool sift(std::uint32_t v) {
        near_.clear();
        for (const std::uint32_t arc : g_.out.row(v))
            near_.push_back({key_[g_.arcs[arc].to], g_.arcs[arc].to, g_.arcs[arc].weight});
        double front = 0.0; // backward weight with v before all neighbours
        for (const std::uint32_t arc : g_.in.row(v)) {
            near_.push_back({key_[g_.arcs[arc].from], g_.arcs[arc].from, -g_.arcs[arc].weight});
            front += g_.arcs[arc].weight;
        }
        if (near_.empty()) return false;
        std::sort(near_.begin(), near_.end(), [](const Neighbour& a, const Neighbour& b) { return a.key < b.key; });
        double weight = front;
        double best = front;
        double now = front;
        std::size_t best_behind = 0; // how many neighbours v stands behind
        for (std::size_t i = 0; i < near_.size(); ++i) {
            weight += near_[i].change;
            if (near_[i].key < key_[v]) now = weight;
            const bool gap = i + 1 == near_.size() || near_[i + 1].key > near_[i].key;
            if (gap && weight < best - 1e-9) {
                best = weight;
                best_behind = i + 1;
            }
        }
        if (best >= now - 1e-9) return false;
        move(v, best_behind);
        return true;
    }

    void move(std::uint32_t v, std::size_t behind) {
        unlink(v);
        std::uint32_t left = kNone;
        std::uint32_t right = kNone;
        if (behind == 0) {
            right = near_.front().node;
            left = before_[right];
        } else {
            left = near_[behind - 1].node;
            right = after_[left];
        }
        const double low = left == kNone ? key_[right] - 2.0 : key_[left];
        const double high = right == kNone ? key_[left] + 2.0 : key_[right];
        key_[v] = low + (high - low) / 2.0;
        before_[v] = left;
        after_[v] = right;
        if (left != kNone) after_[left] = v;
        if (right != kNone) before_[right] = v;
        if (key_[v] <= low || key_[v] >= high) {
            collect();
            renumber();
        }
    }

    void unlink(std::uint32_t v) {
        if (before_[v] != kNone) after_[before_[v]] = after_[v];
        if (after_[v] != kNone) before_[after_[v]] = before_[v];
        // collect() starts from any node and must not start from one that is out of the chain.
        if (order_.front() == v) std::swap(order_.front(), order_.back());
    }
};

double weight_of(std::span<const WeightedArc> arcs, const std::vector<char>& flags) {
    double weight = 0.0;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (flags[i] != 0) weight += arcs[i].weight;
    }
    return weight;
}

// Takes arcs back in, dearest first, as long as no cycle closes.
std::vector<std::uint32_t> make_minimal(const Graph& g, std::vector<char>& left_out) {
    std::vector<std::uint32_t> candidates;
    for (std::uint32_t i = 0; i < left_out.size(); ++i) {
        if (left_out[i] != 0) candidates.push_back(i);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return g.arcs[a].weight > g.arcs[b].weight; });
    constexpr std::uint64_t kArcsLookedAt = 100'000'000;
    GrowingOrder order(g, left_out, kArcsLookedAt);
    for (const std::uint32_t arc : candidates) order.take(arc);
    return order.place();
}

} // namespace

FeedbackSet heuristic_feedback_arcs(std::size_t nodes, std::span<const WeightedArc> arcs) {
    const Graph g(nodes, arcs);
    // Small groups can afford to start from many roots; the largest only from two.
    const std::size_t starts = nodes <= 400 ? 12 : 2;
    FeedbackSet result;
    result.exact = false;
    std::vector<char> best;
    double best_weight = std::numeric_limits<double>::infinity();
    for (std::size_t start = 0; start < starts; ++start) {
        LocalRatio local_ratio(g, start / 2 * nodes * 2 / starts, start % 2 == 1);
        std::vector<char> flags = local_ratio.run();
        result.at_least = std::max(result.at_least, local_ratio.paid());
        const std::vector<std::uint32_t> place = make_minimal(g, flags);
        double weight = weight_of(arcs, flags);
        Sifting sifting(g, place);
        sifting.run(nodes <= 400 ? 12 : 4);
        std::vector<char> sifted = sifting.backward();
        make_minimal(g, sifted);
        if (const double sifted_weight = weight_of(arcs, sifted); sifted_weight < weight - 1e-9) {
            flags = std::move(sifted);
            weight = sifted_weight;
        }
        if (weight < best_weight - 1e-9) {
            best = std::move(flags);
            best_weight = weight;
        }
        if (best_weight <= result.at_least + 1e-9) break; // nothing can be better
    }
    for (std::uint32_t i = 0; i < best.size(); ++i) {
        if (best[i] != 0) result.arcs.push_back(i);
    }
    result.weight = best.empty() ? 0.0 : best_weight;
    result.exact = result.weight <= result.at_least + 1e-9;
    return result;
}

} // namespace planum::strat
