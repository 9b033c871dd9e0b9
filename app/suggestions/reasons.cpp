// SPDX-License-Identifier: MIT
#include "app/suggestions/reasons.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"

namespace planum::app {

namespace {

using scans::Ground;

std::string area_text(double area) {
    return area >= 0.95 ? fmt::format("{:.1f} m²", area) : fmt::format("{:.2f} m²", area);
}

std::string thickness_text(double thickness) { return fmt::format("{:.0f} cm", std::round(thickness * 100.0)); }

std::string surface_day(const model::Record& record, model::SurfaceId id) {
    const auto surface = std::find_if(record.surfaces.begin(), record.surfaces.end(),
                                      [&](const model::Surface& s) { return s.id == id; });
    return surface == record.surfaces.end() ? std::string{} : day_words(last_day_of(*surface));
}

} // namespace

std::string day_words(const std::string& day) {
    constexpr std::array kMonths = {"January", "February", "March",     "April",   "May",      "June",
                                    "July",    "August",   "September", "October", "November", "December"};
    if (!is_day(day)) return day;
    const auto month = static_cast<std::size_t>((day[5] - '0') * 10 + day[6] - '0');
    return fmt::format("{} {} {}", (day[8] - '0') * 10 + day[9] - '0', kMonths.at(month - 1), day.substr(0, 4));
}

std::string reason_of(const model::Record& record, const model::RecordIndex& index, const AreaEvidence& area,
                      const scans::Conclusion& c) {
    const std::string u = index.name(area.units[static_cast<std::size_t>(c.unit)].id);
    const std::string v = index.name(area.units[static_cast<std::size_t>(c.other)].id);
    const std::string before = surface_day(record, area.surfaces[c.from]);
    const std::string after = surface_day(record, area.surfaces[c.to]);
    const std::string size = area_text(c.area);
    const std::string depth = thickness_text(c.thickness);
    switch (c.ground) {
    case Ground::LayBareBelow:
        return fmt::format("on {} {} of {} lay bare where {} had been on {}, {} lower", after, size, v, u, before,
                           depth);
    case Ground::EmptiedCut:
        return fmt::format("on {} {} of the cut {} lay bare where {} had been on {}, {} lower", after, size, v, u,
                           before, depth);
    case Ground::BelowBareCut:
        return fmt::format("the cut {} was empty on {}; on {} {} of {} lay {} below its bottom", u, before, after, size,
                           v, depth);
    case Ground::ThinUnit:
        return fmt::format("on {} {} of {} lay bare where {} had been on {}, too little lower for the heights to tell",
                           after, size, v, u, before);
    case Ground::FlatContact:
        return fmt::format("from {} to {} the line between {} and {} moved into {} over {} while the ground went down "
                           "{}: {} dips flat under {}",
                           before, after, u, v, u, size, depth, v, u);
    case Ground::ReplacedWhole:
        return fmt::format("where {} was on {}, {} of {} came out on {}, {} lower", u, before, size, v, after, depth);
    case Ground::ShrinksInside:
        return fmt::format("{} lies inside {} and became smaller by {} from {} to {}, {} lower", u, v, size, before,
                           after, depth);
    case Ground::AboveNatural:
        return fmt::format("on {} {} of the natural ground {} lay bare where {} had been on {}, {} lower", after, size,
                           v, u, before, depth);
    case Ground::AppearsInside:
        return fmt::format("{} first showed on {}, in {} where {} had been on {}: was it covered by {}, or was it "
                           "there already and seen too late? Look at the section",
                           v, after, size, u, before, u);
    case Ground::GrowsDownwards:
        return fmt::format("{} grew into {} by {} from {} to {}: is it covered by {}, or undercut into it? Look at the "
                           "section",
                           v, u, size, before, after, u);
    case Ground::StructureStands:
        return fmt::format("on {} {} of {} came out where {} had been on {}, and one of the two is built: which was "
                           "there first?",
                           after, size, v, u, before);
    case Ground::RoofOfHollow:
        return fmt::format("on {} {} of the cut {} lay below where {} had been on {}: did {} lie in or over it, or was "
                           "it the roof of a hollow that reaches under it?",
                           after, size, v, u, before, u);
    case Ground::OnlyAlongOutlines:
        return fmt::format("on {} {} of {} lay where {} had been on {}, but only along the outlines: did they touch "
                           "there?",
                           after, size, v, u, before);
    }
    return {};
}

} // namespace planum::app
