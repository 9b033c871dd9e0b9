// SPDX-License-Identifier: MIT
#include "strat/layout/rank_phase.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "strat/layout/level_balance.hpp"
#include "strat/layout/network_simplex.hpp"
#include "strat/matrix/condensation.hpp"

namespace planum::strat {

namespace {

constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

// Union-find; the smallest leads.
class Sets {
  public:
    explicit Sets(std::size_t count) : leader_(count) {
        for (std::size_t i = 0; i < count; ++i) leader_[i] = static_cast<std::uint32_t>(i);
    }

    std::uint32_t find(std::uint32_t i) {
        while (leader_[i] != i) {
            leader_[i] = leader_[leader_[i]];
            i = leader_[i];
        }
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        leader_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> leader_;
};

class Ranker {
  public:
    explicit Ranker(const DrawnGraph& graph) : graph_(graph), levels_(graph.boxes.size()) {
        out_.upwards.assign(graph.orders.size(), false);
    }

    Ranking rank() {
        find_components();
        turn_cycles();
        turn_against_bands();
        join_contemporaries();
        solve();
        close_chains();
        if (graph_.bands.empty()) {
            pull_to_ends();
            balance();
        } else {
            find_bands();
        }
        close_gaps();
        return std::move(out_);
    }

  private:
    void find_components() {
        Sets sets(graph_.boxes.size());
        for (const GraphOrder& o : graph_.orders) sets.join(o.later, o.earlier);
        for (const Order& pair : graph_.contemporaries) sets.join(pair.later, pair.earlier);
        std::vector<std::uint32_t> first(graph_.groups.size(), kNone); // boxes of one frame are laid out together
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (graph_.boxes[b].group < 0 || graph_.boxes[b].box.isolated) continue;
            std::uint32_t& with = first[static_cast<std::size_t>(graph_.boxes[b].group)];
            if (with == kNone) with = b;
            sets.join(with, b);
        }
        out_.component.assign(graph_.boxes.size(), 0);
        std::vector<std::uint32_t> number(graph_.boxes.size(), 0);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            const std::uint32_t leader = sets.find(b);
            if (leader == b) number[b] = out_.component_count++;
            out_.component[b] = number[leader];
        }
    }

    // Within each cycle group: greedy sequence after Eades, Lin and Smyth 1993; what runs against it is
    // drawn upwards. That shall be an uncertain order where there is one: it is the first to be suspected.
    void turn_cycles() {
        std::vector<Order> orders;
        for (const GraphOrder& o : graph_.orders) orders.push_back({o.later, o.earlier});
        const Condensation condensation = condense(graph_.boxes.size(), orders);
        for (std::uint32_t c = 0; c < condensation.members.rows(); ++c) {
            if (condensation.members.row(c).size() > 1) turn_group(condensation, c);
        }
    }

    void turn_group(const Condensation& condensation, std::uint32_t c) {
        const auto members = condensation.members.row(c);
        std::vector<std::uint32_t> inside; // orders of the group
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            if (condensation.component_of[graph_.orders[i].later] == c &&
                condensation.component_of[graph_.orders[i].earlier] == c) {
                inside.push_back(i);
            }
        }
        std::vector<std::uint32_t> left(members.begin(), members.end());
        std::vector<std::int64_t> place(graph_.boxes.size(), 0);
        std::int64_t next = 0;
        std::vector<std::int64_t> balance(graph_.boxes.size(), 0); // orders down minus orders up, among those left
        const auto weight = [&](const GraphOrder& o) {
            return o.line.uncertain ? std::int64_t{1} : static_cast<std::int64_t>(inside.size()) + 1;
        };
        for (const std::uint32_t i : inside) {
            balance[graph_.orders[i].later] += weight(graph_.orders[i]);
            balance[graph_.orders[i].earlier] -= weight(graph_.orders[i]);
        }
        std::vector<bool> taken(graph_.boxes.size(), false);
        while (!left.empty()) {
            const auto best = std::max_element(
                left.begin(), left.end(), [&](std::uint32_t a, std::uint32_t b) { return balance[a] < balance[b]; });
            const std::uint32_t box = *best;
            left.erase(best);
            taken[box] = true;
            place[box] = next++;
            for (const std::uint32_t i : inside) {
                const GraphOrder& o = graph_.orders[i];
                if (o.later == box) balance[o.earlier] += weight(o);
                if (o.earlier == box) balance[o.later] -= weight(o);
            }
        }
        for (const std::uint32_t i : inside) {
            if (place[graph_.orders[i].later] > place[graph_.orders[i].earlier]) out_.upwards[i] = true;
        }
    }

    // A box may stand in its own band only; one without a band not above a box that holds it down. What
    // contradicts is drawn upwards.
    void turn_against_bands() {
        if (graph_.bands.empty()) return;
        std::vector<std::uint32_t> in_sequence;
        std::vector<std::vector<std::uint32_t>> above(graph_.boxes.size());
        std::vector<std::uint32_t> waiting(graph_.boxes.size(), 0);
        std::vector<std::vector<std::uint32_t>> below(graph_.boxes.size());
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            if (out_.upwards[i]) continue;
            below[graph_.orders[i].later].push_back(i);
            above[graph_.orders[i].earlier].push_back(i);
            ++waiting[graph_.orders[i].earlier];
        }
        std::vector<std::int32_t> least(graph_.boxes.size(), 0);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (waiting[b] == 0) in_sequence.push_back(b);
        }
        for (std::size_t at = 0; at < in_sequence.size(); ++at) {
            const std::uint32_t b = in_sequence[at];
            const std::int32_t band = graph_.boxes[b].band;
            for (const std::uint32_t i : above[b]) {
                const std::int32_t floor = least[graph_.orders[i].later];
                if (band != kNoBand && floor > band) {
                    out_.upwards[i] = true;
                } else {
                    least[b] = std::max(least[b], floor);
                }
            }
            if (band != kNoBand) least[b] = band;
            for (const std::uint32_t i : below[b]) {
                if (--waiting[graph_.orders[i].earlier] == 0) in_sequence.push_back(graph_.orders[i].earlier);
            }
        }
    }

    // Pair by pair, as long as no order and no band stands against it.
    void join_contemporaries() {
        if (graph_.contemporaries.empty()) return;
        std::vector<std::vector<std::uint32_t>> members(graph_.boxes.size());
        std::vector<std::vector<std::uint32_t>> below(graph_.boxes.size());
        std::vector<std::int32_t> band(graph_.boxes.size());
        std::vector<char> chained(graph_.boxes.size(), 0); // in any order
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            members[b] = {b};
            band[b] = graph_.boxes[b].band;
        }
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            const GraphOrder& o = graph_.orders[i];
            if (!out_.upwards[i]) below[o.later].push_back(o.earlier);
            chained[o.later] = chained[o.earlier] = 1;
        }
        for (const Order& pair : graph_.contemporaries) {
            const std::uint32_t a = levels_.find(pair.later);
            const std::uint32_t b = levels_.find(pair.earlier);
            if (a == b) continue;
            // Boxes outside all bands are held between others' bands by different chains; tied together these
            // chains can close a circle through the bands' borders. Without a chain they go anywhere.
            const bool free = (band[a] == kNoBand && chained[a] == 0) || (band[b] == kNoBand && chained[b] == 0);
            if (!free && (band[a] != band[b] || (!graph_.bands.empty() && band[a] == kNoBand))) continue;
            if (reaches(members, below, a, b) || reaches(members, below, b, a)) continue;
            levels_.join(a, b);
            const std::uint32_t leader = levels_.find(a);
            const std::uint32_t other = leader == a ? b : a;
            band[leader] = std::max(band[a], band[b]);
            chained[leader] = chained[a] != 0 || chained[b] != 0 ? 1 : 0;
            members[leader].insert(members[leader].end(), members[other].begin(), members[other].end());
        }
    }

    bool reaches(const std::vector<std::vector<std::uint32_t>>& members,
                 const std::vector<std::vector<std::uint32_t>>& below, std::uint32_t from, std::uint32_t to) {
        std::vector<bool> seen(graph_.boxes.size(), false);
        std::vector<std::uint32_t> open = {from};
        seen[from] = true;
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            open.pop_back();
            for (const std::uint32_t member : members[at]) {
                for (const std::uint32_t next : below[member]) {
                    const std::uint32_t leader = levels_.find(next);
                    if (leader == to) return true;
                    if (seen[leader]) continue;
                    seen[leader] = true;
                    open.push_back(leader);
                }
            }
        }
        return false;
    }

    // One node per level group, and between the bands separators that everything of a band lies between.
    void solve() {
        const auto boxes = static_cast<std::uint32_t>(graph_.boxes.size());
        std::vector<RankArc> arcs;
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            if (out_.upwards[i]) continue;
            const std::uint32_t from = levels_.find(graph_.orders[i].later);
            const std::uint32_t to = levels_.find(graph_.orders[i].earlier);
            if (from != to) arcs.push_back({from, to, 1, 1});
        }
        const auto bands = static_cast<std::uint32_t>(graph_.bands.size());
        const std::vector<bool> outside = outside_bands();
        for (std::uint32_t b = 0; b < boxes && bands > 0; ++b) {
            const std::int32_t band = graph_.boxes[b].band;
            if (graph_.boxes[b].box.isolated) continue;
            const std::uint32_t level = levels_.find(b);
            if (outside[out_.component[b]]) arcs.push_back({boxes + bands, level, 1, 0});
            if (band == kNoBand) continue;
            arcs.push_back({boxes + static_cast<std::uint32_t>(band), level, 1, 0});
            arcs.push_back({level, boxes + static_cast<std::uint32_t>(band) + 1, 1, 0});
        }
        for (std::uint32_t band = 0; band < bands; ++band) arcs.push_back({boxes + band, boxes + band + 1, 1, 1});
        const std::uint32_t nodes = boxes + (bands > 0 ? bands + 1 : 0);
        ranks_ = network_simplex(nodes, arcs, pivots(nodes, arcs.size()));
        out_.rank.resize(boxes);
        for (std::uint32_t b = 0; b < boxes; ++b) out_.rank[b] = ranks_[levels_.find(b)];
    }

    // Components that have no box in any band: they stand below all of them, or they would seem to belong to the first.
    [[nodiscard]] std::vector<bool> outside_bands() const {
        std::vector<bool> outside(out_.component_count, true);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (graph_.boxes[b].band != kNoBand) outside[out_.component[b]] = false;
        }
        return outside;
    }

    // Beyond some thousand units the last few per cent of line length are not worth the seconds.
    static std::int64_t pivots(std::uint32_t nodes, std::size_t arcs) {
        constexpr double kWork = 4.0e7;
        return std::max<std::int64_t>(
            50, static_cast<std::int64_t>(kWork / (1.0 + static_cast<double>(nodes) + static_cast<double>(arcs))));
    }

    // Topsoil up, natural down, where nothing is in the way.
    void pull_to_ends() {
        std::vector<std::int32_t> last(out_.component_count, 0);
        std::vector<bool> has_above(graph_.boxes.size(), false);
        std::vector<bool> has_below(graph_.boxes.size(), false);
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            const GraphOrder& o = graph_.orders[i];
            has_below[out_.upwards[i] ? o.earlier : o.later] = true;
            has_above[out_.upwards[i] ? o.later : o.earlier] = true;
        }
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            last[out_.component[b]] = std::max(last[out_.component[b]], out_.rank[b]);
        }
        std::vector<std::uint32_t> on_level(graph_.boxes.size(), 0);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) ++on_level[levels_.find(b)];
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (on_level[levels_.find(b)] > 1) continue; // stands with its contemporaries
            if (graph_.boxes[b].on_top && !has_above[b]) out_.rank[b] = 0;
            if (graph_.boxes[b].at_bottom && !has_below[b]) out_.rank[b] = last[out_.component[b]];
        }
    }

    // A chain's slack goes below it, not into it: a box under one that has nothing else below stands right
    // beneath it. Costs no length where it has one order below, too.
    void close_chains() {
        std::vector<std::uint32_t> above(graph_.boxes.size(), kNone);
        std::vector<std::uint32_t> orders_above(graph_.boxes.size(), 0);
        std::vector<std::uint32_t> orders_below(graph_.boxes.size(), 0);
        for (std::uint32_t i = 0; i < graph_.orders.size(); ++i) {
            const std::uint32_t weight = out_.upwards[i] ? 2 : 1; // boxes at an upward line stay
            above[graph_.orders[i].earlier] = graph_.orders[i].later;
            orders_above[graph_.orders[i].earlier] += weight;
            orders_below[graph_.orders[i].later] += weight;
        }
        std::vector<std::uint32_t> on_level(graph_.boxes.size(), 0);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) ++on_level[levels_.find(b)];
        std::vector<std::uint32_t> downwards(graph_.boxes.size());
        std::iota(downwards.begin(), downwards.end(), 0U);
        std::stable_sort(downwards.begin(), downwards.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return out_.rank[a] < out_.rank[b]; });
        for (const std::uint32_t b : downwards) {
            if (orders_above[b] != 1 || orders_below[b] != 1 || orders_below[above[b]] != 1) continue;
            if (on_level[levels_.find(b)] > 1 || graph_.boxes[b].at_bottom) continue;
            if (graph_.boxes[b].band != graph_.boxes[above[b]].band) continue;
            out_.rank[b] = out_.rank[above[b]] + 1;
        }
    }

    void balance() {
        std::vector<std::uint32_t> on_level(graph_.boxes.size(), 0);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) ++on_level[levels_.find(b)];
        std::vector<bool> fixed(graph_.boxes.size(), false);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            fixed[b] = on_level[levels_.find(b)] > 1 || graph_.boxes[b].on_top || graph_.boxes[b].at_bottom;
        }
        balance_levels(graph_, out_.upwards, out_.component, fixed, out_.rank);
    }

    void find_bands() {
        const auto boxes = static_cast<std::uint32_t>(graph_.boxes.size());
        for (std::uint32_t band = 0; band <= graph_.bands.size(); ++band)
            out_.band_begin.push_back(ranks_[boxes + band]);
    }

    // Levels that nothing stands on: of separators between bands, or left by moved boxes. They go, with bands in
    // all components alike.
    void close_gaps() {
        std::vector<std::vector<std::uint32_t>> parts(graph_.bands.empty() ? out_.component_count : 1);
        for (std::uint32_t b = 0; b < graph_.boxes.size(); ++b) {
            if (!graph_.boxes[b].box.isolated) parts[graph_.bands.empty() ? out_.component[b] : 0].push_back(b);
        }
        for (const std::vector<std::uint32_t>& part : parts) close_gaps_of(part);
    }

    void close_gaps_of(const std::vector<std::uint32_t>& boxes) {
        std::int32_t highest = 0;
        for (const std::uint32_t b : boxes) highest = std::max(highest, out_.rank[b]);
        for (const std::int32_t b : out_.band_begin) highest = std::max(highest, b);
        std::vector<bool> used(static_cast<std::size_t>(highest) + 2, false);
        for (const std::uint32_t b : boxes) used[static_cast<std::size_t>(out_.rank[b])] = true;
        std::vector<std::int32_t> renamed(used.size(), 0);
        std::int32_t next = 0;
        for (std::size_t r = 0; r < renamed.size(); ++r) {
            renamed[r] = next;
            if (used[r]) ++next;
        }
        for (const std::uint32_t b : boxes) out_.rank[b] = renamed[static_cast<std::size_t>(out_.rank[b])];
        for (std::int32_t& b : out_.band_begin) b = renamed[static_cast<std::size_t>(std::max(b, 0))];
    }

    const DrawnGraph& graph_;
    Sets levels_; // boxes that stand on one level, contemporary ones
    Ranking out_;
    std::vector<std::int32_t> ranks_; // as solved, separators last
};

} // namespace

Ranking rank_boxes(const DrawnGraph& graph) { return Ranker(graph).rank(); }

} // namespace planum::strat
