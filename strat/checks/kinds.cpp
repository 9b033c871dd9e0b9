// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using model::Severity;
using model::Strictness;
using model::UnitForm;
using model::UnitKind;

bool is_body(UnitKind kind) {
    return kind == UnitKind::Deposit || kind == UnitKind::Skeleton || kind == UnitKind::Natural;
}

// What is wrong with the kinds of the two ends, as the end of a sentence; empty when they fit.
std::string mismatch(const CheckContext& c, RelationIndex r, Strictness strictness) {
    const model::StratigraphicUnit& u = c.unit(c.subject[r]);
    const model::StratigraphicUnit& v = c.unit(c.object[r]);
    const auto is = [&](const model::StratigraphicUnit& unit, UnitIndex at) {
        return fmt::format("{} is recorded as {}", c.name(at), model::to_word(unit.kind));
    };
    if (u.kind == UnitKind::Unknown || v.kind == UnitKind::Unknown) return {};
    const bool strict = strictness == Strictness::Strict;
    switch (c.record.relations[r].kind) {
    case RelationKind::Cuts:
        if (is_body(u.kind) || (strict && u.kind == UnitKind::Structure)) {
            return is(u, c.subject[r]) + "; only a cut or a feature cuts";
        }
        return {};
    case RelationKind::Fills:
        if (u.kind == UnitKind::Cut) return is(u, c.subject[r]) + "; a cut fills nothing";
        if (is_body(v.kind)) return is(v, c.object[r]) + "; only cuts, features and structures are filled";
        return {};
    case RelationKind::BondsWith:
        if (is_body(u.kind) || u.kind == UnitKind::Cut) return is(u, c.subject[r]) + "; only what was built bonds";
        if (is_body(v.kind) || v.kind == UnitKind::Cut) return is(v, c.object[r]) + "; only what was built bonds";
        return {};
    case RelationKind::SameAs:
        if ((u.kind == UnitKind::Cut) != (v.kind == UnitKind::Cut) && u.kind != UnitKind::Feature &&
            v.kind != UnitKind::Feature) {
            return is(u, c.subject[r]) + fmt::format(" and {} as {}", c.name(c.object[r]), model::to_word(v.kind));
        }
        return {};
    case RelationKind::Covers:
    case RelationKind::Abuts:
        if (strict && u.kind == UnitKind::Cut)
            return is(u, c.subject[r]) + "; a cut has no body that could lie or lean on anything";
        return {};
    case RelationKind::Borders:
    case RelationKind::Later:
    case RelationKind::Contemporary: return {};
    }
    return {};
}

void add_mismatches(const CheckContext& c, Findings& findings) {
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.known(r) || c.subject[r] == c.object[r]) continue;
        if (c.is_void(c.subject[r]) || c.is_void(c.object[r])) continue;
        const std::string wrong = mismatch(c, r, c.record.settings.strictness);
        if (wrong.empty()) continue;
        auto d = make_diagnostic(Severity::Warning, "kind-mismatch", fmt::format("{}, but {}", c.sentence(r), wrong));
        d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
        d.relations = {c.named(r)};
        findings.push_back(std::move(d));
    }
}

// What a unit takes part in, as far as cuts and fills are concerned.
struct Sequence {
    bool fills = false;
    bool is_filled = false;
    bool cuts = false;
    bool any_above = false;
    bool any_below = false;
};

std::vector<Sequence> sequences(const CheckContext& c) {
    std::vector<Sequence> result(c.record.units.size());
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.states_order(r) || c.subject[r] == c.object[r]) continue;
        Sequence& later = result[c.subject[r]];
        Sequence& earlier = result[c.object[r]];
        later.any_below = true;
        earlier.any_above = true;
        if (c.record.relations[r].kind == RelationKind::Fills) later.fills = earlier.is_filled = true;
        if (c.record.relations[r].kind == RelationKind::Cuts) later.cuts = true;
    }
    return result;
}

void add_about_unit(const CheckContext& c, Findings& findings, UnitIndex u, std::string_view code,
                    std::string_view text) {
    auto d = make_diagnostic(Severity::Warning, code, fmt::format("{} {}", c.name(u), text));
    d.units = {c.unit(u).id};
    findings.push_back(std::move(d));
}

// Lists that know only "above" cannot say what is cut or filled; there nothing is asked of them.
void add_incomplete_sequences(const CheckContext& c, Findings& findings) {
    if (c.record.settings.strictness == Strictness::Lenient) return;
    const bool strict = c.record.settings.strictness == Strictness::Strict;
    const auto has = [&](RelationKind kind) {
        return std::any_of(c.record.relations.begin(), c.record.relations.end(),
                           [&](const model::PhysicalRelation& r) { return r.kind == kind; });
    };
    const bool knows_fills = has(RelationKind::Fills);
    const bool knows_cuts = has(RelationKind::Cuts);
    const std::vector<Sequence> all = sequences(c);
    for (UnitIndex u = 0; u < all.size(); ++u) {
        if (c.is_void(u) || c.is_mentioned(u)) continue;
        const model::StratigraphicUnit& unit = c.unit(u);
        const Sequence& s = all[u];
        if (knows_fills && unit.kind == UnitKind::Deposit && unit.form == UnitForm::Fill && !s.fills &&
            unit.parent.is_nil()) {
            add_about_unit(c, findings, u, "fill-without-cut", "is a fill, but no cut is named that it fills");
        }
        if (unit.kind != UnitKind::Cut) continue;
        if (knows_fills && !s.is_filled && unit.status != model::UnitStatus::NotExcavated && (strict || !s.any_above)) {
            add_about_unit(c, findings, u, "cut-without-fill", "is a cut, but nothing is recorded that fills it");
        }
        if (knows_cuts && !s.cuts && (strict || !s.any_below)) {
            add_about_unit(c, findings, u, "cut-cuts-nothing", "is a cut, but nothing is recorded that it cuts");
        }
    }
}

void add_natural_above(const CheckContext& c, Findings& findings) {
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.states_order(r)) continue;
        const UnitIndex u = c.subject[r];
        const UnitIndex v = c.object[r];
        if (c.unit(u).kind != UnitKind::Natural || c.unit(v).kind == UnitKind::Natural) continue;
        if (c.unit(v).kind == UnitKind::Unknown || c.is_void(u) || c.is_void(v)) continue;
        auto d = make_diagnostic(
            Severity::Warning, "natural-not-lowest",
            fmt::format("{}, but {} is natural ground; nothing made by people lies below it unless it was moved",
                        c.sentence(r), c.name(u)));
        d.units = {c.unit(u).id, c.unit(v).id};
        d.relations = {c.named(r)};
        findings.push_back(std::move(d));
    }
}

} // namespace

bool kinds_mismatch(const CheckContext& context, RelationIndex relation, Strictness strictness) {
    return context.known(relation) && !mismatch(context, relation, strictness).empty();
}

void check_kinds(const CheckContext& context, Findings& findings) {
    if (context.record.settings.strictness != Strictness::Lenient) add_mismatches(context, findings);
    add_incomplete_sequences(context, findings);
    add_natural_above(context, findings);
}

} // namespace planum::strat
