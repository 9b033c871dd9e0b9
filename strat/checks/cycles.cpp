// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "strat/checks/cycle_group.hpp"
#include "strat/checks/families.hpp"
#include "strat/matrix/condensation.hpp"

namespace planum::strat {

namespace {

using model::Severity;

constexpr std::size_t kProofs = 3;       // shortest cycles shown
constexpr std::size_t kStepsInText = 12; // of a cycle in the message

// Units that are in a cycle even while same_as is not merged.
std::vector<char> units_in_own_cycles(const CheckContext& c) {
    std::vector<Order> orders;
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.states_order(r) || c.subject[r] == c.object[r]) continue;
        if (c.matrix.component_of(c.matrix.node_of(c.subject[r])) !=
            c.matrix.component_of(c.matrix.node_of(c.object[r])))
            continue;
        orders.push_back({c.subject[r], c.object[r]});
    }
    std::sort(orders.begin(), orders.end());
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    const Condensation unmerged = condense(c.record.units.size(), orders);
    std::vector<char> flags(c.record.units.size(), 0);
    for (std::size_t u = 0; u < flags.size(); ++u) {
        flags[u] = unmerged.members.row(unmerged.component_of[u]).size() > 1 ? 1 : 0;
    }
    return flags;
}

std::vector<std::uint32_t> orders_of(const CycleGroup& group, const std::vector<std::uint32_t>& arcs) {
    std::vector<std::uint32_t> orders;
    orders.reserve(arcs.size());
    for (const std::uint32_t arc : arcs) orders.push_back(group.orders[arc]);
    return orders;
}

// The shortest cycles through what is most suspect: the proof.
std::vector<std::vector<std::uint32_t>> proofs(const CycleGroup& group, const GroupVerdict& verdict) {
    std::vector<std::vector<std::uint32_t>> cycles;
    for (std::size_t i = 0; i < std::min(verdict.removals.size(), kProofs); ++i) {
        cycles.push_back(orders_of(group, shortest_cycle_through(group, verdict.removals[i])));
    }
    std::stable_sort(cycles.begin(), cycles.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    return cycles;
}

std::string suspect_text(const CheckContext& c, const model::Suspect& suspect) {
    struct Visitor {
        const CheckContext& context;

        [[nodiscard]] std::string relation(const model::NamedRelation& r) const {
            return fmt::format("{} {} {}", context.index.name(r.unit), model::phrase(r.kind),
                               context.index.name(r.other));
        }

        std::string operator()(const model::SuspectRelation& s) const { return relation(s.relation); }

        std::string operator()(const model::SuspectSameAs& s) const { return relation(s.same_as); }

        std::string operator()(const model::SuspectNumber& s) const {
            return fmt::format("{} ({} for {}?)", relation(s.relation), s.written, s.probably);
        }

        std::string operator()(const model::SuspectUnit& s) const {
            return fmt::format("{} (two units under one number?)", context.index.name(s.unit));
        }
    };

    return std::visit(Visitor{c}, suspect.what);
}

// A circle ends where it began, be it by a same_as.
std::string circle_text(const CheckContext& c, std::span<const std::uint32_t> circle, std::size_t limit) {
    const auto because = c.matrix.because(circle.front());
    if (because.empty()) return path_text(c, circle, limit);
    const UnitIndex begin = c.subject[because.front()];
    return path_text(c, circle, limit, {begin, begin});
}

model::Diagnostic describe(const CheckContext& c, const CycleGroup& group, const GroupVerdict& verdict,
                           bool by_same_as) {
    const auto cycles = proofs(group, verdict);
    auto d = make_diagnostic(Severity::Error, by_same_as ? "cycle-by-same-as" : "cycle", {});
    for (const NodeIndex node : group.nodes) {
        for (const UnitIndex u : c.matrix.members(node)) d.units.push_back(c.unit(u).id);
    }
    d.message = fmt::format("{} units lie above one another in a circle{}: {}", d.units.size(),
                            by_same_as ? " once same-as is applied" : "", circle_text(c, cycles.front(), kStepsInText));
    if (verdict.cannot_tell) {
        d.message += "; nothing in the record tells which of these is wrong";
    } else if (!verdict.suspects.empty()) {
        d.message += "; most suspect: " + suspect_text(c, verdict.suspects.front());
    }
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        for (auto& relation : path_relations(c, cycles[i])) {
            if (std::find(d.relations.begin(), d.relations.end(), relation) == d.relations.end())
                d.relations.push_back(relation);
        }
        d.evidence[fmt::format("cycle_{}", i + 1)] = circle_text(c, cycles[i], 40);
    }
    d.evidence["units"] = static_cast<std::int64_t>(d.units.size());
    d.evidence["orders"] = static_cast<std::int64_t>(group.arcs.size());
    d.evidence["removals"] = static_cast<std::int64_t>(verdict.removals.size());
    d.evidence["exact"] = static_cast<std::int64_t>(verdict.exact ? 1 : 0);
    d.evidence["cannot_tell"] = static_cast<std::int64_t>(verdict.cannot_tell ? 1 : 0);
    d.suspects = verdict.suspects;
    return d;
}

// same_as statements between the members of one node that alone hold two of them together.
std::vector<RelationIndex> bridges(const CheckContext& c, NodeIndex node, UnitIndex from, UnitIndex to) {
    const auto members = c.matrix.members(node);
    std::vector<RelationIndex> inside;
    for (const UnitIndex u : members) {
        for (const RelationIndex r : c.relations_of(u)) {
            if (c.known(r) && c.subject[r] == u && c.record.relations[r].kind == model::RelationKind::SameAs)
                inside.push_back(r);
        }
    }
    const auto connected_without = [&](RelationIndex left_out) {
        std::vector<UnitIndex> reached = {from};
        for (std::size_t at = 0; at < reached.size(); ++at) {
            for (const RelationIndex r : inside) {
                if (r == left_out) continue;
                const UnitIndex u = reached[at];
                if (c.subject[r] != u && c.object[r] != u) continue;
                const UnitIndex other = c.subject[r] == u ? c.object[r] : c.subject[r];
                if (std::find(reached.begin(), reached.end(), other) == reached.end()) reached.push_back(other);
            }
        }
        return std::find(reached.begin(), reached.end(), to) != reached.end();
    };
    constexpr std::size_t kTried = 200;
    std::vector<RelationIndex> found;
    for (std::size_t i = 0; i < std::min(inside.size(), kTried); ++i) {
        if (!connected_without(inside[i])) found.push_back(inside[i]);
    }
    return found;
}

// `u` is stated to be `v`, directly or by way of others, and to lie above it.
void add_pair_in_one_node(const CheckContext& c, const RelationWeights& weights, RelationIndex relation,
                          Findings& findings) {
    const UnitIndex u = c.subject[relation];
    const UnitIndex v = c.object[relation];
    auto d = make_diagnostic(Severity::Error, "cycle-by-same-as",
                             fmt::format("{}, yet same-as makes the two one unit", c.sentence(relation)));
    d.units = {c.unit(u).id, c.unit(v).id};
    d.relations = {c.named(relation)};

    struct Scored {
        RelationWeight weight;
        model::Suspect suspect;
        bool correlation = false;
    };

    std::vector<Scored> all;
    for (const RelationIndex r : bridges(c, c.matrix.node_of(u), u, v)) {
        d.relations.push_back(c.named(r));
        all.push_back({weights.weigh_same_as(r),
                       {model::SuspectSameAs{c.named(r)}, 0.0, {"without it the two are two units"}},
                       c.record.relations[r].correlation});
    }
    std::stable_sort(all.begin(), all.end(), [](const Scored& a, const Scored& b) {
        return a.correlation != b.correlation ? a.correlation : a.weight.log_odds < b.weight.log_odds;
    });
    all.push_back({weights.explain(relation),
                   {model::SuspectRelation{c.named(relation)}, 0.0, {"a unit cannot lie above itself"}},
                   false});
    double sum = 0.0;
    for (const Scored& s : all) sum += std::exp(-s.weight.log_odds);
    for (Scored& s : all) {
        s.suspect.score = std::exp(-s.weight.log_odds) / sum;
        for (const std::string& reason : s.weight.against) s.suspect.reasons.push_back(reason);
        for (const std::string& reason : s.weight.in_favour) s.suspect.reasons.push_back("in its favour: " + reason);
        d.suspects.push_back(std::move(s.suspect));
    }
    findings.push_back(std::move(d));
}

} // namespace

void check_cycles(const CheckContext& context, Findings& findings) {
    std::vector<RelationIndex> in_one_node;
    for (RelationIndex r = 0; r < context.subject.size(); ++r) {
        if (!context.states_order(r) || context.subject[r] == context.object[r]) continue;
        if (context.matrix.node_of(context.subject[r]) == context.matrix.node_of(context.object[r]))
            in_one_node.push_back(r);
    }
    const auto groups = context.matrix.cycle_groups();
    if (groups.empty() && in_one_node.empty()) return;
    const RelationWeights weights(context);
    for (const RelationIndex r : in_one_node) add_pair_in_one_node(context, weights, r, findings);
    if (groups.empty()) return;
    const std::vector<char> own = units_in_own_cycles(context);
    for (const std::uint32_t component : groups) {
        context.progress.check();
        const auto nodes = context.matrix.component(component);
        const bool by_same_as = std::none_of(nodes.begin(), nodes.end(), [&](NodeIndex node) {
            const auto members = context.matrix.members(node);
            return std::any_of(members.begin(), members.end(), [&](UnitIndex u) { return own[u] != 0; });
        });
        const CycleGroup group(context, weights, nodes);
        const GroupVerdict verdict =
            find_suspects(context, weights, group, by_same_as ? SameAsFirst::Yes : SameAsFirst::No);
        findings.push_back(describe(context, group, verdict, by_same_as));
    }
}

} // namespace planum::strat
