// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::LevelRole;
using model::RelationKind;
using model::Severity;

bool is_base(LevelRole role) { return role == LevelRole::Base || role == LevelRole::Cut; }

// What lies on a slope may differ in height by so much for every metre in plan (45°) before two points contradict or
// confirm anything.
constexpr double kSlope = 1.0;

struct NearPair {
    bool found = false;
    double upper = 0.0;
    double lower = 0.0;
    double slope = 0.0; ///< what a slope between the two points may make up for [m]
};

// The two points nearest to contradiction: `u`'s level lowest against `v`'s, both of the roles asked for and within
// `near` of each other in plan; a slope between them speaks for the record (`sign` 1) or against it (−1).
template<class RoleOfU, class RoleOfV>
NearPair lowest_against(const CheckContext& c, UnitIndex u, RoleOfU of_u, UnitIndex v, RoleOfV of_v, double sign) {
    NearPair worst;
    for (const std::uint32_t i : c.levels_of(u)) {
        const model::Level& a = c.record.levels[i];
        if (!of_u(a.role) || !a.x || !a.y) continue;
        for (const std::uint32_t j : c.levels_of(v)) {
            const model::Level& b = c.record.levels[j];
            if (!of_v(b.role) || !b.x || !b.y) continue;
            const double apart = std::hypot(*a.x - *b.x, *a.y - *b.y);
            if (apart > c.options.near) continue;
            const double slope = kSlope * apart;
            if (!worst.found || a.z - b.z + sign * slope < worst.upper - worst.lower + sign * worst.slope) {
                worst = {true, a.z, b.z, slope};
            }
        }
    }
    return worst;
}

LevelJudgement contradicted(double upper, std::string_view upper_is, double lower, std::string_view lower_is,
                            bool near) {
    return {LevelVerdict::Contradicted, {}, upper, lower, upper_is, lower_is, near};
}

LevelJudgement untestable(std::string_view why) {
    LevelJudgement j;
    j.why = why;
    return j;
}

LevelJudgement judge_covers(const CheckContext& c, UnitIndex u, UnitIndex v) {
    const double tolerance = c.record.settings.tolerance;
    const Heights& hu = c.heights[u];
    const Heights& hv = c.heights[v];
    const auto top = [](LevelRole role) { return role == LevelRole::Top; };
    // Levels on the surface of a cut say nothing about a body above or below.
    const auto base = [](LevelRole role) { return role == LevelRole::Base; };
    const NearPair near = lowest_against(c, u, top, v, base, 1.0);
    if (near.found && near.upper + near.slope < near.lower - tolerance) {
        return contradicted(near.upper, "top", near.lower, "base", true);
    }
    if (hu.highest_top && hv.lowest_base && *hu.highest_top < *hv.lowest_base - tolerance) {
        return contradicted(*hu.highest_top, "highest level on top", *hv.lowest_base, "lowest level at the base",
                            false);
    }
    const NearPair tops = lowest_against(c, u, top, v, top, -1.0);
    if (tops.found && tops.upper - tops.slope > tops.lower + tolerance)
        return {LevelVerdict::Confirmed, {}, tops.upper, tops.lower, "top", "top", true};
    if (hu.lowest_base && hv.highest_top && *hu.lowest_base >= *hv.highest_top - tolerance) {
        return {LevelVerdict::Confirmed, {},   *hu.lowest_base, *hv.highest_top, "lowest level at the base",
                "highest level on top",  false};
    }
    if (!hu.any() || !hv.any()) return untestable("no levels of one of the units");
    return untestable("levels do not decide it");
}

LevelJudgement judge_cuts(const CheckContext& c, UnitIndex u, UnitIndex v) {
    const Heights& hu = c.heights[u];
    const Heights& hv = c.heights[v];
    if (!hu.lowest_base || !hv.highest_top) return untestable("no levels of one of the units");
    if (*hu.lowest_base >= *hv.highest_top + c.record.settings.tolerance) {
        return contradicted(*hu.lowest_base, "deepest level", *hv.highest_top, "highest level on top", false);
    }
    return untestable("levels agree, which proves nothing for a cut or a fill");
}

LevelJudgement judge_fills(const CheckContext& c, UnitIndex u, UnitIndex v) {
    const double tolerance = c.record.settings.tolerance;
    const Heights& hu = c.heights[u];
    const Heights& hv = c.heights[v];
    if (!hu.any() || !hv.lowest_base) return untestable("no levels of one of the units");
    if (hu.highest_top && *hu.highest_top < *hv.lowest_base - tolerance) {
        return contradicted(*hu.highest_top, "highest level on top", *hv.lowest_base, "deepest level", false);
    }
    if (hu.lowest_base && *hu.lowest_base < *hv.lowest_base - tolerance) {
        return contradicted(*hu.lowest_base, "lowest level at the base", *hv.lowest_base, "deepest level", false);
    }
    return untestable("levels agree, which proves nothing for a cut or a fill");
}

void add_own_contradictions(const CheckContext& c, Findings& findings) {
    for (UnitIndex u = 0; u < c.heights.size(); ++u) {
        const Heights& h = c.heights[u];
        double top = 0.0;
        double bottom = 0.0;
        bool near = false;
        if (h.contradictory) {
            top = *h.highest_top;
            bottom = *h.lowest_base;
        } else {
            const auto pair = lowest_against(
                c, u, [](LevelRole r) { return r == LevelRole::Top; }, u, is_base, 1.0);
            if (!pair.found || pair.upper + pair.slope >= pair.lower - c.record.settings.tolerance) continue;
            top = pair.upper;
            bottom = pair.lower;
            near = true;
        }
        auto d =
            make_diagnostic(Severity::Warning, "level-contradiction",
                            fmt::format("{}: its base at {} lies {} above its top at {}{}", c.name(u), metres(bottom),
                                        metres(bottom - top), metres(top), near ? ", measured at the same place" : ""));
        d.units = {c.unit(u).id};
        d.evidence["top_m"] = top;
        d.evidence["base_m"] = bottom;
        d.evidence["difference_m"] = top - bottom;
        findings.push_back(std::move(d));
    }
}

void add_contradicted_relations(const CheckContext& c, Findings& findings) {
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.states_order(r) || c.subject[r] == c.object[r]) continue;
        const LevelJudgement j = judge_by_levels(c, r);
        if (j.verdict != LevelVerdict::Contradicted) continue;
        const bool cut = c.record.relations[r].kind == RelationKind::Cuts;
        auto d = make_diagnostic(Severity::Warning, "level-contradiction",
                                 fmt::format("{}, but the {} of {} ({}) is {} {} than the {} of {} ({}){}",
                                             c.sentence(r), j.upper_is, c.name(c.subject[r]), metres(j.upper),
                                             metres(std::abs(j.upper - j.lower)), cut ? "higher" : "lower", j.lower_is,
                                             c.name(c.object[r]), metres(j.lower),
                                             j.near ? ", measured at the same place" : ""));
        d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
        d.relations = {c.named(r)};
        d.evidence["unit_m"] = j.upper;
        d.evidence["other_m"] = j.lower;
        d.evidence["difference_m"] = j.upper - j.lower;
        d.evidence["near"] = static_cast<std::int64_t>(j.near ? 1 : 0);
        findings.push_back(std::move(d));
    }
}

void add_finds_outside(const CheckContext& c, Findings& findings) {
    const double tolerance = c.record.settings.tolerance;
    for (const model::Find& find : c.record.finds) {
        const UnitIndex u = c.index.find(find.unit);
        if (u == model::kNoUnit || c.is_void(u)) continue;
        const Heights& h = c.heights[u];
        std::string what;
        auto d = make_diagnostic(Severity::Warning, "find-outside-unit", {});
        if (c.unit(u).kind == model::UnitKind::Cut) {
            what = fmt::format("find {} is recorded in {}, which is a cut and can hold nothing; it belongs to a fill",
                               find.number, c.name(u));
        } else if (find.z && !h.contradictory && h.highest_top && *find.z > *h.highest_top + tolerance) {
            what = fmt::format("find {} at {} lies {} above the top of {} ({})", find.number, metres(*find.z),
                               metres(*find.z - *h.highest_top), c.name(u), metres(*h.highest_top));
            d.evidence["difference_m"] = *find.z - *h.highest_top;
        } else if (find.z && !h.contradictory && h.lowest_base && *find.z < *h.lowest_base - tolerance) {
            what = fmt::format("find {} at {} lies {} below the base of {} ({})", find.number, metres(*find.z),
                               metres(*h.lowest_base - *find.z), c.name(u), metres(*h.lowest_base));
            d.evidence["difference_m"] = *find.z - *h.lowest_base;
        }
        if (what.empty()) continue;
        d.message = std::move(what);
        d.units = {c.unit(u).id};
        d.evidence["find"] = find.number;
        findings.push_back(std::move(d));
    }
}

// Both units, packed; evidence is symmetric apart from its sign.
std::uint64_t pair_key(UnitIndex a, UnitIndex b) { return (static_cast<std::uint64_t>(a) << 32U) | b; }

constexpr double kVisibleArea = 0.1; // m²: the least from which surfaces count

} // namespace

LevelJudgement judge_by_levels(const CheckContext& c, RelationIndex relation) {
    const UnitIndex u = c.subject[relation];
    const UnitIndex v = c.object[relation];
    const RelationKind kind = c.record.relations[relation].kind;
    if (kind == RelationKind::Abuts) return untestable("abutting says nothing about heights");
    if (kind == RelationKind::Later) return untestable("stated in time only");
    if (!c.heights[u].any() && !c.heights[v].any()) return untestable("no levels of either unit");
    if (!c.heights[u].any() || !c.heights[v].any()) return untestable("no levels of one of the units");
    if (c.heights[u].contradictory || c.heights[v].contradictory) {
        return untestable("the levels of one unit contradict themselves");
    }
    if (kind == RelationKind::Cuts) return judge_cuts(c, u, v);
    if (kind == RelationKind::Fills) return judge_fills(c, u, v);
    return judge_covers(c, u, v);
}

void check_levels(const CheckContext& context, Findings& findings) {
    add_own_contradictions(context, findings);
    add_contradicted_relations(context, findings);
    add_finds_outside(context, findings);
}

model::Coverage measure_coverage(const CheckContext& c, std::vector<model::EvidenceVerdict>& verdicts) {
    using model::EvidenceVerdict;
    model::Coverage coverage;
    verdicts.assign(c.subject.size(), EvidenceVerdict::None);
    const auto say = [&](RelationIndex r, EvidenceVerdict verdict) {
        verdicts[r] = verdict;
        if (verdict == EvidenceVerdict::Confirmed) ++coverage.confirmed;
        if (verdict == EvidenceVerdict::Contradicted) ++coverage.contradicted;
    };
    std::unordered_map<std::uint64_t, const model::SurfaceEvidence*> seen;
    for (const model::SurfaceEvidence& e : c.surfaces) {
        if (!e.testable) continue;
        seen[pair_key(c.index.find(e.upper), c.index.find(e.lower))] = &e;
    }
    for (RelationIndex r = 0; r < c.subject.size(); ++r) {
        if (!c.states_order(r) || c.subject[r] == c.object[r]) continue;
        ++coverage.relations;
        const auto forward = seen.find(pair_key(c.subject[r], c.object[r]));
        const auto backward = seen.find(pair_key(c.object[r], c.subject[r]));
        double agrees = 0.0;
        double contrary = 0.0;
        if (forward != seen.end()) {
            agrees += forward->second->area;
            contrary += forward->second->contrary_area;
        }
        if (backward != seen.end()) {
            agrees += backward->second->contrary_area;
            contrary += backward->second->area;
        }
        if (std::max(agrees, contrary) >= kVisibleArea) {
            say(r, agrees >= contrary ? EvidenceVerdict::Confirmed : EvidenceVerdict::Contradicted);
            continue;
        }
        const LevelJudgement j = judge_by_levels(c, r);
        switch (j.verdict) {
        case LevelVerdict::Confirmed: say(r, EvidenceVerdict::Confirmed); break;
        case LevelVerdict::Contradicted: say(r, EvidenceVerdict::Contradicted); break;
        case LevelVerdict::Untestable:
            say(r, EvidenceVerdict::Untestable);
            ++coverage.untestable[std::string{j.why}];
            break;
        }
    }
    return coverage;
}

} // namespace planum::strat
