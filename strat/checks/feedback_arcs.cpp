// SPDX-License-Identifier: MIT
#include "strat/checks/feedback_arcs.hpp"

#include <algorithm>
#include <limits>

#include "strat/matrix/condensation.hpp"

namespace planum::strat {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A strong component with its own numbering.
struct Part {
    std::size_t nodes = 0;
    std::vector<WeightedArc> arcs;
    std::vector<std::uint32_t> positions; ///< of the arcs in the whole graph
};

std::vector<Part> strong_parts(std::size_t nodes, std::span<const WeightedArc> arcs) {
    std::vector<Order> orders;
    orders.reserve(arcs.size());
    for (const WeightedArc& arc : arcs) orders.push_back({arc.from, arc.to});
    std::sort(orders.begin(), orders.end());
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    const Condensation c = condense(nodes, orders);
    std::vector<std::uint32_t> part_of(c.members.rows(), static_cast<std::uint32_t>(-1));
    std::vector<std::uint32_t> local(nodes, 0);
    std::vector<Part> parts;
    for (std::uint32_t i = 0; i < arcs.size(); ++i) {
        const std::uint32_t component = c.component_of[arcs[i].from];
        if (component != c.component_of[arcs[i].to]) continue;
        if (part_of[component] == static_cast<std::uint32_t>(-1)) {
            part_of[component] = static_cast<std::uint32_t>(parts.size());
            const auto members = c.members.row(component);
            for (std::uint32_t m = 0; m < members.size(); ++m) local[members[m]] = m;
            parts.push_back({members.size(), {}, {}});
        }
        Part& part = parts[part_of[component]];
        part.arcs.push_back({local[arcs[i].from], local[arcs[i].to], arcs[i].weight});
        part.positions.push_back(i);
    }
    return parts;
}

FeedbackSet solve_part(const Part& part, const FeedbackOptions& options) {
    if (part.nodes == 1) {
        FeedbackSet loops;
        for (std::uint32_t i = 0; i < part.arcs.size(); ++i) {
            loops.arcs.push_back(i);
            loops.weight += part.arcs[i].weight;
        }
        return loops;
    }
    FeedbackSet heuristic = heuristic_feedback_arcs(part.nodes, part.arcs);
    if (heuristic.exact || part.nodes > options.exact_up_to) return heuristic;
    FeedbackSet exact = exact_feedback_arcs(part.nodes, part.arcs, heuristic.weight);
    if (heuristic.weight <= exact.weight + 1e-9) {
        heuristic.exact = true;
        return heuristic;
    }
    return exact;
}

// For arcs that lie on every path from the end of a cut arc back to its start: cutting them instead would
// do as well.
class Exchanges {
  public:
    Exchanges(const Part& part, const std::vector<char>& cut) : part_(part), cut_(cut) {
        out_ = Adjacency::make(
            part.nodes, part.arcs.size(), [&](std::size_t i) { return part.arcs[i].from; },
            [](std::size_t i) { return i; });
        in_ = Adjacency::make(
            part.nodes, part.arcs.size(), [&](std::size_t i) { return part.arcs[i].to; },
            [](std::size_t i) { return i; });
        sort();
    }

    /// Arcs that alone carry the paths from `from` to `to`.
    [[nodiscard]] std::vector<std::uint32_t> between(std::uint32_t from, std::uint32_t to) {
        std::vector<std::uint32_t> reached = mark(from, to, kDown);
        const std::vector<std::uint32_t> up = mark(to, from, kUp);
        std::sort(reached.begin(), reached.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return place_[a] < place_[b]; });
        std::vector<std::uint32_t> carriers;
        std::size_t open = 0;
        for (const std::uint32_t node : reached) {
            if ((flags_[node] & kUp) == 0) continue;
            for (const std::uint32_t arc : in_.row(node)) open -= inside(arc) ? 1U : 0U;
            std::uint32_t last = 0;
            std::size_t leaving = 0;
            for (const std::uint32_t arc : out_.row(node)) {
                if (!inside(arc)) continue;
                ++leaving;
                last = arc;
            }
            open += leaving;
            if (open == 1 && leaving == 1) carriers.push_back(last);
        }
        for (const std::uint32_t node : reached) flags_[node] = 0;
        for (const std::uint32_t node : up) flags_[node] = 0;
        return carriers;
    }

  private:
    static constexpr std::uint8_t kDown = 1;
    static constexpr std::uint8_t kUp = 2;
    const Part& part_;
    const std::vector<char>& cut_;
    Adjacency out_;
    Adjacency in_;
    std::vector<std::uint32_t> place_;
    std::vector<std::uint8_t> flags_;

    [[nodiscard]] bool inside(std::uint32_t arc) const {
        const WeightedArc& a = part_.arcs[arc];
        return cut_[arc] == 0 && flags_[a.from] == (kDown | kUp) && flags_[a.to] == (kDown | kUp);
    }

    std::vector<std::uint32_t> mark(std::uint32_t start, std::uint32_t stop, std::uint8_t flag) {
        std::vector<std::uint32_t> reached = {start};
        flags_[start] |= flag;
        for (std::size_t at = 0; at < reached.size(); ++at) {
            if (reached[at] == stop) continue;
            for (const std::uint32_t arc : flag == kDown ? out_.row(reached[at]) : in_.row(reached[at])) {
                const std::uint32_t to = flag == kDown ? part_.arcs[arc].to : part_.arcs[arc].from;
                if (cut_[arc] != 0 || (flags_[to] & flag) != 0) continue;
                flags_[to] |= flag;
                reached.push_back(to);
            }
        }
        return reached;
    }

    void sort() {
        flags_.assign(part_.nodes, 0);
        place_.assign(part_.nodes, 0);
        std::vector<std::uint32_t> waiting(part_.nodes, 0);
        for (std::size_t i = 0; i < part_.arcs.size(); ++i) {
            if (cut_[i] == 0) ++waiting[part_.arcs[i].to];
        }
        std::vector<std::uint32_t> queue;
        for (std::uint32_t v = 0; v < part_.nodes; ++v) {
            if (waiting[v] == 0) queue.push_back(v);
        }
        for (std::size_t at = 0; at < queue.size(); ++at) {
            place_[queue[at]] = static_cast<std::uint32_t>(at);
            for (const std::uint32_t arc : out_.row(queue[at])) {
                if (cut_[arc] == 0 && --waiting[part_.arcs[arc].to] == 0) queue.push_back(part_.arcs[arc].to);
            }
        }
    }
};

std::vector<double> by_exchange(const Part& part, const FeedbackSet& best) {
    std::vector<char> cut(part.arcs.size(), 0);
    for (const std::uint32_t arc : best.arcs) cut[arc] = 1;
    std::vector<double> saved(part.arcs.size(), 0.0);
    Exchanges exchanges(part, cut);
    // The least trusted arcs first; each costs a walk through the whole part.
    constexpr std::size_t kExchanged = 64;
    std::vector<std::uint32_t> order = best.arcs;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return part.arcs[a].weight < part.arcs[b].weight; });
    if (order.size() > kExchanged) order.resize(kExchanged);
    for (const std::uint32_t arc : order) {
        for (const std::uint32_t carrier : exchanges.between(part.arcs[arc].to, part.arcs[arc].from)) {
            saved[carrier] += part.arcs[arc].weight;
        }
    }
    std::vector<double> cheapest(part.arcs.size());
    for (std::size_t i = 0; i < cheapest.size(); ++i) {
        cheapest[i] = cut[i] != 0 ? best.weight : best.weight + part.arcs[i].weight - saved[i];
    }
    return cheapest;
}

// Solves the part again without the arc, for every arc that could still compete.
void refine(const Part& part, const FeedbackSet& best, const FeedbackOptions& options, std::vector<double>& cheapest) {
    constexpr double kStillOfInterest = 6.0; // e⁶ times less suspect than the best: nobody looks at that
    FeedbackOptions again = options;
    for (std::uint32_t i = 0; i < part.arcs.size(); ++i) {
        if (std::binary_search(best.arcs.begin(), best.arcs.end(), i)) continue;
        if (part.arcs[i].weight > best.weight + kStillOfInterest) continue;
        std::vector<WeightedArc> rest;
        for (std::uint32_t j = 0; j < part.arcs.size(); ++j) {
            if (j != i) rest.push_back(part.arcs[j]);
        }
        const FeedbackSet without = minimum_feedback_arcs(part.nodes, rest, again);
        cheapest[i] = std::min(cheapest[i], part.arcs[i].weight + without.weight);
    }
}

} // namespace

FeedbackSet minimum_feedback_arcs(std::size_t nodes, std::span<const WeightedArc> arcs,
                                  const FeedbackOptions& options) {
    FeedbackSet result;
    for (const Part& part : strong_parts(nodes, arcs)) {
        const FeedbackSet solved = solve_part(part, options);
        for (const std::uint32_t arc : solved.arcs) result.arcs.push_back(part.positions[arc]);
        result.weight += solved.weight;
        result.exact = result.exact && solved.exact;
        result.at_least += solved.exact ? solved.weight : solved.at_least;
    }
    std::sort(result.arcs.begin(), result.arcs.end());
    return result;
}

std::vector<double> cheapest_with_each(std::size_t nodes, std::span<const WeightedArc> arcs, const FeedbackSet& best,
                                       const FeedbackOptions& options) {
    std::vector<double> cheapest(arcs.size(), kInfinite);
    std::vector<char> chosen(arcs.size(), 0);
    for (const std::uint32_t arc : best.arcs) chosen[arc] = 1;
    // Small and sparse parts are solved again for each arc; the rest is exchanged.
    constexpr std::size_t kSolveAgain = 13;
    constexpr std::size_t kSparse = 60;
    for (const Part& part : strong_parts(nodes, arcs)) {
        FeedbackSet own;
        for (std::uint32_t i = 0; i < part.arcs.size(); ++i) {
            if (chosen[part.positions[i]] == 0) continue;
            own.arcs.push_back(i);
            own.weight += part.arcs[i].weight;
        }
        std::vector<double> local = by_exchange(part, own);
        if (part.nodes <= kSolveAgain && part.arcs.size() <= kSparse && own.arcs.size() > 1)
            refine(part, own, options, local);
        for (std::size_t i = 0; i < local.size(); ++i)
            cheapest[part.positions[i]] = best.weight - own.weight + local[i];
    }
    return cheapest;
}

bool is_acyclic(std::size_t nodes, std::span<const WeightedArc> arcs, const std::vector<char>& left_out) {
    std::vector<std::uint32_t> waiting(nodes, 0);
    const Adjacency out = Adjacency::make(
        nodes, arcs.size(), [&](std::size_t i) { return arcs[i].from; }, [](std::size_t i) { return i; });
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (left_out[i] == 0) ++waiting[arcs[i].to];
    }
    std::vector<std::uint32_t> queue;
    for (std::uint32_t v = 0; v < nodes; ++v) {
        if (waiting[v] == 0) queue.push_back(v);
    }
    for (std::size_t at = 0; at < queue.size(); ++at) {
        for (const std::uint32_t arc : out.row(queue[at])) {
            if (left_out[arc] == 0 && --waiting[arcs[arc].to] == 0) queue.push_back(arcs[arc].to);
        }
    }
    return queue.size() == nodes;
}

} // namespace planum::strat
