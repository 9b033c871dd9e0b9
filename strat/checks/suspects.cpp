// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "strat/checks/cycle_group.hpp"
#include "strat/matrix/adjacency.hpp"

namespace planum::strat {

namespace {

using model::Suspect;

// Two choices whose odds differ by less than a fifth are told apart by nothing.
constexpr double kAlike = 0.2;
// e⁶ = 400 times less suspect than the best: not worth a line.
constexpr double kOfInterest = 6.0;
// One unit in a hundred or so carries a number twice.
constexpr double kUnitPrior = 4.5;

// Something that could be doubted, and what the cheapest explanation with it costs.
struct Candidate {
    double cost = 0.0;
    bool chosen = false; ///< stands in the cheapest set of relations
    double own = 0.0;    ///< its own weight; among equals the least trusted goes first
    bool same_as = false;
    bool correlation = false;
    RelationIndex relation = kNoRelation;
    UnitIndex unit = model::kNoUnit;
};

class SuspectFinder {
  public:
    SuspectFinder(const CheckContext& context, const RelationWeights& weights, const CycleGroup& group,
                  SameAsFirst same_as_first)
        : c_(context), weights_(weights), group_(group), same_as_first_(same_as_first == SameAsFirst::Yes),
          options_{context.options.exact_up_to} {}

    GroupVerdict run() {
        best_ = minimum_feedback_arcs(group_.nodes.size(), group_.arcs, options_);
        add_relations();
        add_same_as();
        add_units();
        rank();
        return verdict();
    }

  private:
    const CheckContext& c_;
    const RelationWeights& weights_;
    const CycleGroup& group_;
    bool same_as_first_;
    FeedbackOptions options_;
    FeedbackSet best_;
    std::vector<Candidate> candidates_;

    void add_relations() {
        const std::vector<double> costs = cheapest_with_each(group_.nodes.size(), group_.arcs, best_, options_);
        for (std::uint32_t arc = 0; arc < costs.size(); ++arc) {
            if (costs[arc] > best_.weight + kOfInterest) continue;
            const bool chosen = std::binary_search(best_.arcs.begin(), best_.arcs.end(), arc);
            for (const RelationIndex r : c_.matrix.because(group_.orders[arc])) {
                Candidate candidate;
                candidate.cost = costs[arc];
                candidate.chosen = chosen;
                candidate.own = group_.arcs[arc].weight;
                candidate.relation = r;
                candidates_.push_back(candidate);
            }
        }
    }

    // same_as relations between members of the group's nodes.
    [[nodiscard]] std::vector<RelationIndex> same_as_inside() const {
        std::vector<RelationIndex> found;
        for (const NodeIndex node : group_.nodes) {
            const auto members = c_.matrix.members(node);
            if (members.size() < 2) continue;
            for (const UnitIndex u : members) {
                for (const RelationIndex r : c_.relations_of(u)) {
                    const bool counts = c_.known(r) && c_.subject[r] == u && c_.subject[r] != c_.object[r];
                    if (counts && c_.record.relations[r].kind == model::RelationKind::SameAs) found.push_back(r);
                }
            }
        }
        std::stable_sort(found.begin(), found.end(), [&](RelationIndex a, RelationIndex b) {
            return c_.record.relations[a].correlation > c_.record.relations[b].correlation;
        });
        return found;
    }

    void add_same_as() {
        std::vector<RelationIndex> inside = same_as_inside();
        // Each costs a solution of the whole group; large groups afford fewer.
        const std::size_t afford = group_.nodes.size() <= 1000 ? 24 : 4;
        if (inside.size() > afford) inside.resize(afford);
        for (const RelationIndex r : inside) {
            Candidate candidate;
            candidate.own = std::max(weights_.weigh_same_as(r).log_odds + group_.shift, 0.0);
            candidate.cost = candidate.own + weight_without(r);
            candidate.same_as = true;
            candidate.correlation = c_.record.relations[r].correlation;
            candidate.relation = r;
            if (same_as_first_ || candidate.cost <= best_.weight + kOfInterest) candidates_.push_back(candidate);
        }
    }

    // The group with one same_as taken back: units fall into classes by the others.
    [[nodiscard]] double weight_without(RelationIndex left_out) const {
        std::vector<UnitIndex> units;
        for (const NodeIndex node : group_.nodes) {
            const auto members = c_.matrix.members(node);
            units.insert(units.end(), members.begin(), members.end());
        }
        std::sort(units.begin(), units.end());
        const auto place = [&](UnitIndex u) {
            return static_cast<std::uint32_t>(std::lower_bound(units.begin(), units.end(), u) - units.begin());
        };
        std::vector<std::uint32_t> parent(units.size());
        for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = i;
        const auto root = [&](std::uint32_t i) {
            while (parent[i] != i) i = parent[i] = parent[parent[i]];
            return i;
        };
        for (const RelationIndex r : same_as_inside()) {
            if (r != left_out) parent[root(place(c_.subject[r]))] = root(place(c_.object[r]));
        }
        std::vector<WeightedArc> arcs;
        for (std::size_t i = 0; i < group_.arcs.size(); ++i) {
            const auto because = c_.matrix.because(group_.orders[i]);
            for (const RelationIndex r : because) {
                arcs.push_back({root(place(c_.subject[r])), root(place(c_.object[r])),
                                group_.arcs[i].weight / static_cast<double>(because.size())});
            }
        }
        return minimum_feedback_arcs(units.size(), arcs, options_).weight;
    }

    // A unit through which all cycles pass, though no single relation breaks them: two under one number.
    void add_units() {
        if (best_.arcs.size() < 2) return;
        std::vector<std::uint32_t> nodes;
        for (const std::uint32_t arc : best_.arcs) {
            nodes.push_back(group_.arcs[arc].from);
            nodes.push_back(group_.arcs[arc].to);
        }
        // A node on all cycles lies on each of them, so it is enough to look along one.
        for (const std::uint32_t arc : shortest_cycle_through(group_, best_.arcs.front()))
            nodes.push_back(group_.arcs[arc].from);
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        constexpr std::size_t kLookedAt = 40;
        if (nodes.size() > kLookedAt) nodes.resize(kLookedAt);
        for (const std::uint32_t node : nodes) {
            std::vector<char> left_out(group_.arcs.size(), 0);
            for (std::size_t i = 0; i < left_out.size(); ++i) {
                left_out[i] = group_.arcs[i].from == node || group_.arcs[i].to == node ? 1 : 0;
            }
            if (!is_acyclic(group_.nodes.size(), group_.arcs, left_out)) continue;
            Candidate candidate;
            candidate.cost = candidate.own = kUnitPrior + group_.shift;
            candidate.unit = c_.matrix.members(group_.nodes[node]).front();
            if (candidate.cost <= best_.weight + kOfInterest) candidates_.push_back(candidate);
        }
    }

    void rank() {
        const auto key = [&](const Candidate& a) {
            return std::tuple(!(same_as_first_ && a.same_as), !(same_as_first_ && a.correlation),
                              std::round(a.cost * 1e6), !a.chosen, std::round(a.own * 1e6), a.relation, a.unit);
        };
        std::sort(candidates_.begin(), candidates_.end(),
                  [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
        std::size_t others = 0;
        std::erase_if(candidates_,
                      [&](const Candidate& a) { return !a.chosen && ++others > c_.options.suspects_shown; });
    }

    [[nodiscard]] GroupVerdict verdict() {
        GroupVerdict v;
        v.removals = best_.arcs;
        v.exact = best_.exact;
        double least = std::numeric_limits<double>::infinity();
        for (const Candidate& a : candidates_) least = std::min(least, a.cost);
        double sum = 0.0;
        for (const Candidate& a : candidates_) sum += std::exp(least - a.cost);
        std::size_t alike = 0;
        for (const Candidate& a : candidates_) {
            if (a.cost < least + kAlike) ++alike;
            v.suspects.push_back(suspect(a, std::exp(least - a.cost) / sum));
        }
        const bool relations_are_best = least >= best_.weight - 1e-9;
        v.cannot_tell = alike > (relations_are_best ? chosen_relations() : 1);
        return v;
    }

    [[nodiscard]] std::size_t chosen_relations() const {
        return static_cast<std::size_t>(
            std::count_if(candidates_.begin(), candidates_.end(), [](const Candidate& a) { return a.chosen; }));
    }

    [[nodiscard]] Suspect suspect(const Candidate& a, double score) const {
        if (a.unit != model::kNoUnit) return unit_suspect(a, score);
        if (a.same_as) return same_as_suspect(a, score);
        return relation_suspect(a, score);
    }

    [[nodiscard]] Suspect unit_suspect(const Candidate& a, double score) const {
        return {model::SuspectUnit{c_.unit(a.unit).id},
                score,
                {fmt::format("every circle passes through {}, and no single relation breaks them all: probably two "
                             "units under one number, to be split",
                             c_.name(a.unit))}};
    }

    [[nodiscard]] Suspect same_as_suspect(const Candidate& a, double score) const {
        Suspect s{model::SuspectSameAs{c_.named(a.relation)}, score, {}};
        if (a.cost - a.own < 1e-9) {
            s.reasons.push_back(fmt::format("no circle is left when {} and {} are two units",
                                            c_.name(c_.subject[a.relation]), c_.name(c_.object[a.relation])));
        } else {
            s.reasons.emplace_back("without it some circles are gone, but not all");
        }
        add_reasons(s, weights_.weigh_same_as(a.relation));
        return s;
    }

    [[nodiscard]] Suspect relation_suspect(const Candidate& a, double score) const {
        Suspect s{model::SuspectRelation{c_.named(a.relation)}, score, {}};
        if (a.chosen && best_.arcs.size() == 1) {
            s.reasons.emplace_back("without it no circle is left");
        } else if (a.chosen) {
            s.reasons.push_back(
                fmt::format("it is one of {} relations without which no circle is left", best_.arcs.size()));
        } else if (a.cost < best_.weight + kAlike) {
            s.reasons.emplace_back("doubting it instead would do as well");
        } else {
            s.reasons.emplace_back("doubting it instead would also break a circle");
        }
        if (const auto slip = weights_.best_slip(a.relation)) {
            s.what = model::SuspectNumber{c_.named(a.relation), c_.name(slip->written), c_.name(slip->meant)};
            s.reasons.push_back(fmt::format("{} is probably meant instead of {}: {}", c_.name(slip->meant),
                                            c_.name(slip->written), slip->why));
        }
        add_reasons(s, weights_.explain(a.relation));
        return s;
    }

    static void add_reasons(Suspect& s, const RelationWeight& weight) {
        for (const std::string& reason : weight.against) s.reasons.push_back(reason);
        for (const std::string& reason : weight.in_favour) s.reasons.push_back("in its favour: " + reason);
    }
};

} // namespace

GroupVerdict find_suspects(const CheckContext& context, const RelationWeights& weights, const CycleGroup& group,
                           SameAsFirst same_as_first) {
    return SuspectFinder(context, weights, group, same_as_first).run();
}

} // namespace planum::strat
