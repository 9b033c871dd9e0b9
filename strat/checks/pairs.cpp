// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::Severity;

void add_self_relations(const CheckContext& c, Findings& findings) {
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.states_order(r) || c.subject[r] != c.object[r]) continue;
        const UnitIndex u = c.subject[r];
        auto d = make_diagnostic(
            Severity::Error, "self-relation",
            fmt::format("{}: a unit cannot lie above itself; probably another number was meant", c.sentence(r)));
        d.units = {c.record.units[u].id};
        d.relations = {c.named(r)};
        findings.push_back(std::move(d));
    }
}

// Relations of each ordered pair of units, later first.
struct PairRelation {
    UnitIndex later;
    UnitIndex earlier;
    RelationIndex relation;
};

std::vector<PairRelation> ordered_pairs(const CheckContext& c) {
    std::vector<PairRelation> pairs;
    pairs.reserve(c.subject.size());
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (c.states_order(r) && c.subject[r] != c.object[r]) pairs.push_back({c.subject[r], c.object[r], r});
    }
    std::sort(pairs.begin(), pairs.end(), [](const PairRelation& a, const PairRelation& b) {
        return std::tie(a.later, a.earlier, a.relation) < std::tie(b.later, b.earlier, b.relation);
    });
    return pairs;
}

void add_contradicting_pairs(const CheckContext& c, const std::vector<PairRelation>& pairs, Findings& findings) {
    const auto before = [](const PairRelation& p, const std::pair<UnitIndex, UnitIndex>& key) {
        return std::pair(p.later, p.earlier) < key;
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto [later, earlier, relation] = pairs[i];
        if (later > earlier) continue;
        if (i > 0 && pairs[i - 1].later == later && pairs[i - 1].earlier == earlier) continue;
        const auto reverse = std::lower_bound(pairs.begin(), pairs.end(), std::pair(earlier, later), before);
        if (reverse == pairs.end() || reverse->later != earlier || reverse->earlier != later) continue;
        auto d = make_diagnostic(
            Severity::Error, "contradicting-pair",
            fmt::format("{}, and {}: one of the two is wrong", c.sentence(relation), c.sentence(reverse->relation)));
        d.units = {c.unit(later).id, c.unit(earlier).id};
        for (auto p = pairs.begin() + static_cast<std::ptrdiff_t>(i);
             p != pairs.end() && p->later == later && p->earlier == earlier; ++p) {
            d.relations.push_back(c.named(p->relation));
        }
        for (auto p = reverse; p != pairs.end() && p->later == earlier && p->earlier == later; ++p) {
            d.relations.push_back(c.named(p->relation));
        }
        findings.push_back(std::move(d));
    }
}

void add_contemporary_ordered(const CheckContext& c, Findings& findings) {
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.known(r) || model::time_meaning(c.record.relations[r].kind) != model::TimeMeaning::SameTime) continue;
        const NodeIndex a = c.matrix.node_of(c.subject[r]);
        const NodeIndex b = c.matrix.node_of(c.object[r]);
        if (a == b) continue;
        NodeIndex later = a;
        NodeIndex earlier = b;
        PathEnds ends{c.subject[r], c.object[r]};
        if (!c.matrix.is_later(later, earlier)) {
            std::swap(later, earlier);
            std::swap(ends.later, ends.earlier);
        }
        if (!c.matrix.is_later(later, earlier)) continue;
        const auto path = c.matrix.shortest_path(later, earlier);
        const bool bonds = c.record.relations[r].kind == model::RelationKind::BondsWith;
        auto d = make_diagnostic(
            bonds ? Severity::Error : Severity::Warning, "contemporary-ordered",
            fmt::format("{}, yet {} puts one after the other", c.sentence(r), path_text(c, path, 8, ends)));
        d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
        d.relations = {c.named(r)};
        for (auto& relation : path_relations(c, path)) d.relations.push_back(relation);
        d.evidence["steps"] = static_cast<std::int64_t>(path.size());
        findings.push_back(std::move(d));
    }
}

bool is_contact(model::RelationKind kind) {
    return kind == model::RelationKind::Covers || kind == model::RelationKind::Cuts ||
           kind == model::RelationKind::Fills || kind == model::RelationKind::Abuts;
}

// The same pair stated with two different contacts: one of them is a slip, the order stands.
void add_pairs_of_two_kinds(const CheckContext& c, const std::vector<PairRelation>& pairs, Findings& findings) {
    for (std::size_t i = 0; i < pairs.size();) {
        std::size_t end = i;
        std::vector<RelationIndex> contacts;
        for (; end < pairs.size() && pairs[end].later == pairs[i].later && pairs[end].earlier == pairs[i].earlier;
             ++end) {
            const model::RelationKind kind = c.record.relations[pairs[end].relation].kind;
            const auto same_kind = [&](RelationIndex r) { return c.record.relations[r].kind == kind; };
            if (is_contact(kind) && std::none_of(contacts.begin(), contacts.end(), same_kind)) {
                contacts.push_back(pairs[end].relation);
            }
        }
        if (contacts.size() > 1) {
            std::vector<std::string> said;
            auto d = make_diagnostic(Severity::Warning, "duplicate-relation", {});
            for (const RelationIndex r : contacts) {
                said.push_back(c.sentence(r));
                d.relations.push_back(c.named(r));
            }
            d.message = fmt::format("{}: one contact stated as two kinds; the order is the same", list_names(said, 5));
            d.units = {c.unit(pairs[i].later).id, c.unit(pairs[i].earlier).id};
            findings.push_back(std::move(d));
        }
        i = end;
    }
}

// One sheet, one source, the same relation on two lines.
void add_repeated_statements(const CheckContext& c, Findings& findings) {
    const auto& statements = c.record.statements;
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.known(r)) continue;
        const StatedSides& sides = c.stated[r];
        if (sides.subject < 2 && sides.object < 2) continue;
        std::map<std::pair<model::SourceId, model::StatementSide>, std::vector<std::int64_t>> lines;
        for (std::uint32_t s = c.statement_begin[r]; s < c.statement_begin[r + 1]; ++s) {
            if (statements[s].relation != c.record.relations[r].id || statements[s].line == 0) continue;
            lines[{statements[s].source, statements[s].side}].push_back(statements[s].line);
        }
        for (auto& [key, where] : lines) {
            std::sort(where.begin(), where.end());
            where.erase(std::unique(where.begin(), where.end()), where.end());
            if (key.second == model::StatementSide::Neither || where.size() < 2) continue;
            auto d = make_diagnostic(
                Severity::Warning, "duplicate-relation",
                fmt::format("{} is written twice on one sheet (lines {} and {})", c.sentence(r), where[0], where[1]));
            d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
            d.relations = {c.named(r)};
            d.evidence["times"] = static_cast<std::int64_t>(where.size());
            findings.push_back(std::move(d));
        }
    }
}

} // namespace

void check_pairs(const CheckContext& context, Findings& findings) {
    add_self_relations(context, findings);
    const std::vector<PairRelation> pairs = ordered_pairs(context);
    add_contradicting_pairs(context, pairs, findings);
    add_pairs_of_two_kinds(context, pairs, findings);
    add_repeated_statements(context, findings);
    add_contemporary_ordered(context, findings);
}

void check_redundancy(const CheckContext& context, Findings& findings) {
    if (!context.options.with_infos) return;
    const HarrisMatrix& matrix = context.matrix;
    std::vector<char> kept(matrix.orders().size(), 0);
    for (const std::uint32_t order : matrix.reduced()) kept[order] = 1;
    std::vector<std::uint32_t> redundant;
    for (std::uint32_t i = 0; i < kept.size(); ++i) {
        if (kept[i] == 0) redundant.push_back(i);
    }
    // Only so many are spelled out as will be shown: see alike_become_one.
    const bool many = redundant.size() > context.options.alike_become_one;
    if (!many) {
        for (const std::uint32_t i : redundant) {
            const RelationIndex r = matrix.because(i).front();
            auto d = make_diagnostic(
                Severity::Info, "redundant-relation",
                fmt::format("{} follows from other relations; it is kept as evidence and left out of the drawing",
                            context.sentence(r)));
            d.units = {context.unit(context.subject[r]).id, context.unit(context.object[r]).id};
            d.relations = {context.named(r)};
            findings.push_back(std::move(d));
        }
        return;
    }
    auto d = make_diagnostic(
        Severity::Info, "redundant-relation",
        fmt::format("{} relations follow from others; they are kept as evidence and left out of the drawing",
                    redundant.size()));
    d.evidence["count"] = static_cast<std::int64_t>(redundant.size());
    findings.push_back(std::move(d));
}

} // namespace planum::strat
