// SPDX-License-Identifier: MIT
#include "app/finds/bodies_at.hpp"

#include <algorithm>

namespace planum::app {

namespace {

bool is_cut(const model::Record& record, const model::Region& region) {
    if (region.shows == model::RegionShows::Cut) return true;
    return std::any_of(record.units.begin(), record.units.end(), [&](const model::StratigraphicUnit& unit) {
        return unit.id == region.unit && unit.kind == model::UnitKind::Cut;
    });
}

// The face between two bodies, seen from above at `above` for the last time and from below at `below` first.
std::optional<HeightRange> boundary(const SeenThere& above, bool above_is_cut, const SeenThere& below) {
    const bool own_face =
        below.region->shows == model::RegionShows::Top || below.region->shows == model::RegionShows::Cut;
    if (own_face && !above_is_cut) return below.face;
    if (!above.face || !below.face) return std::nullopt;
    if (above_is_cut) return above.face; // what lies under a cut ends at it
    return HeightRange{std::min(above.face->low, below.face->low), std::max(above.face->high, below.face->high)};
}

bool same_label(const model::Region& a, const model::Region& b) {
    return a.unit == b.unit && (!a.unit.is_nil() || a.unit_as_drawn == b.unit_as_drawn);
}

} // namespace

std::vector<BodyThere> bodies_there(const model::Record& record, const std::vector<SeenThere>& seen) {
    std::vector<BodyThere> bodies;
    for (const SeenThere& one : seen) {
        if (one.region->category != model::RegionCategory::Unit) continue;
        if (!bodies.empty() && same_label(*bodies.back().last->region, *one.region)) {
            bodies.back().last = &one;
            continue;
        }
        BodyThere body;
        body.unit = one.region->unit;
        body.first = body.last = &one;
        body.is_cut = is_cut(record, *one.region);
        body.top = one.face;
        if (!bodies.empty()) {
            BodyThere& above = bodies.back();
            above.below = &one;
            body.top = boundary(*above.last, above.is_cut, one);
            above.bottom = body.top;
        }
        bodies.push_back(body);
    }
    return bodies;
}

} // namespace planum::app
