// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "strat/checks/families.hpp"

namespace planum::strat {

namespace {

using model::RelationKind;
using model::Severity;

constexpr double kVisible = 0.1; // from here on surfaces may be sure [m²]
constexpr double kFaint = 0.02;  // from here on they warn; counted clear of the outlines, so much of a post-hole [m²]
constexpr double kFlat = 50.0 * 3.14159265358979323846 / 180.0; // steeper contacts only warn [rad]

// Heights are held against what was seen to lie over something; leaning, bonding and age alone say nothing of them.
bool may_be_compared(RelationKind kind) {
    return kind == RelationKind::Covers || kind == RelationKind::Cuts || kind == RelationKind::Fills;
}

bool is_significant(const model::SurfaceEvidence& e) {
    return e.testable && e.area >= kFaint && e.area > 4.0 * e.contrary_area;
}

model::Diagnostic contradiction(const CheckContext& c, RelationIndex r, const model::SurfaceEvidence& e) {
    const std::string subject = c.name(c.subject[r]);
    const std::string object = c.name(c.object[r]);
    const bool sure =
        e.area >= kVisible && e.both_faces_own && e.contact_dip < kFlat && e.source != model::EvidenceSource::Levels;
    if (e.source == model::EvidenceSource::Section) {
        auto d = make_diagnostic(sure ? Severity::Error : Severity::Warning, "height-contradiction",
                                 fmt::format("{}, but in the section {} lies on {} along {:.2f} m: the relation is the "
                                             "wrong way round, or an outline carries the wrong number",
                                             c.sentence(r), object, subject, e.length));
        d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
        d.relations = {c.named(r)};
        d.evidence["length_m"] = e.length;
        return d;
    }
    auto d = make_diagnostic(
        sure ? Severity::Error : Severity::Warning, "height-contradiction",
        fmt::format("{}, but over {:.2f} m² {} lay above {}, which came out {:.2f} m lower: the relation is the wrong "
                    "way round, or an outline carries the wrong number, or {} was dug before {}",
                    c.sentence(r), e.area, object, subject, e.thickness, object, subject));
    d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
    d.relations = {c.named(r)};
    d.evidence["area_m2"] = e.area;
    d.evidence["thickness_m"] = e.thickness;
    d.evidence["tolerance_m"] = e.tolerance;
    return d;
}

// A cut fills nothing, so only which way round is to be seen, and what is proposed or asked from is enough for that:
// whether the other lay in the cut or the cut reached under it, it did not lie on what came out higher.
bool is_cut_said_to_fill(const CheckContext& c, RelationIndex r) {
    return c.record.relations[r].kind == RelationKind::Fills && c.unit(c.subject[r]).kind == model::UnitKind::Cut &&
           c.unit(c.object[r]).kind != model::UnitKind::Cut;
}

bool shows_cut_below(const model::SurfaceEvidence& e) {
    return (e.testable || e.below_is_bare_cut) && e.thickness > e.tolerance && e.area > 4.0 * e.contrary_area;
}

model::Diagnostic cut_below(const CheckContext& c, RelationIndex r, const model::SurfaceEvidence& e) {
    const std::string cut = c.name(c.subject[r]);
    const std::string other = c.name(c.object[r]);
    auto d = make_diagnostic(
        Severity::Warning, "height-contradiction",
        fmt::format(
            "{}, but over {:.2f} m² the bare cut {} came out where {} had been, {:.2f} m lower: {} fills {}, or "
            "{} cuts {} from beside",
            c.sentence(r), e.area, cut, other, e.thickness, other, cut, cut, other));
    d.units = {c.unit(c.subject[r]).id, c.unit(c.object[r]).id};
    d.relations = {c.named(r)};
    d.evidence["area_m2"] = e.area;
    d.evidence["thickness_m"] = e.thickness;
    d.evidence["tolerance_m"] = e.tolerance;
    return d;
}

} // namespace

void check_surfaces(const CheckContext& context, Findings& findings) {
    std::map<std::pair<UnitIndex, UnitIndex>, const model::SurfaceEvidence*> seen;
    std::map<std::pair<UnitIndex, UnitIndex>, const model::SurfaceEvidence*> cut_seen;
    for (const model::SurfaceEvidence& e : context.surfaces) {
        if (shows_cut_below(e)) cut_seen[{context.index.find(e.upper), context.index.find(e.lower)}] = &e;
        if (is_significant(e)) seen[{context.index.find(e.upper), context.index.find(e.lower)}] = &e;
    }
    // A pair stated as two kinds is one mistake.
    std::set<std::pair<UnitIndex, UnitIndex>> said;
    for (RelationIndex r = 0; r < context.subject.size(); ++r) {
        if (!context.states_order(r) || !may_be_compared(context.record.relations[r].kind)) continue;
        const auto against = seen.find({context.object[r], context.subject[r]});
        const auto below = cut_seen.find({context.object[r], context.subject[r]});
        if (against == seen.end() && below != cut_seen.end() && is_cut_said_to_fill(context, r) &&
            !cut_seen.contains({context.subject[r], context.object[r]})) {
            if (said.emplace(context.subject[r], context.object[r]).second)
                findings.push_back(cut_below(context, r, *below->second));
            continue;
        }
        if (against == seen.end() || seen.contains({context.subject[r], context.object[r]})) continue;
        if (said.emplace(context.subject[r], context.object[r]).second)
            findings.push_back(contradiction(context, r, *against->second));
    }
}

} // namespace planum::strat
