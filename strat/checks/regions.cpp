// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <unordered_map>

#include <fmt/format.h>

#include "core/model/astray.hpp"
#include "strat/checks/families.hpp"
#include "strat/checks/finish.hpp"

namespace planum::strat {

namespace {

std::string where_drawn(const model::Record& record, const model::Region& region) {
    for (const model::Surface& surface : record.surfaces) {
        if (!region.surface.is_nil() && surface.id == region.surface)
            return "on " + (surface.name.empty() ? surface.first_day : surface.name);
    }
    for (const model::Section& section : record.sections) {
        if (section.id == region.section) return "on section " + section.name;
    }
    return "nowhere";
}

// A point of its line, so that it is found on the plan.
std::string near_what(const model::Region& region) {
    if (region.outline.empty() || region.outline.front().outer.empty()) return {};
    const auto& corner = region.outline.front().outer.front();
    return fmt::format(" near {:.2f} {:.2f}", corner[0], corner[1]);
}

void add_unnamed(const CheckContext& context, Findings& findings) {
    for (const model::Region& region : context.record.regions) {
        if (region.category != model::RegionCategory::Unit || !region.unit.is_nil()) continue;
        const std::string place = where_drawn(context.record, region) + near_what(region);
        auto d = make_diagnostic(
            model::Severity::Info, "region-without-unit",
            region.unit_as_drawn.empty()
                ? fmt::format("an outline {} has no unit: nothing is concluded from it until it is named", place)
                : fmt::format(
                      "the outline {} is drawn as {}, which is no unit here: nothing is concluded from it until "
                      "there is one or it is named otherwise",
                      place, region.unit_as_drawn));
        d.evidence["region"] = region.id.to_string();
        d.evidence["drawn_as"] = region.unit_as_drawn;
        findings.push_back(std::move(d));
    }
}

std::string drawn_as(const CheckContext& context, const model::Region& region) {
    const UnitIndex unit = context.index.find(region.unit);
    if (unit != model::kNoUnit) return context.name(unit);
    if (!region.unit_as_drawn.empty()) return region.unit_as_drawn;
    return region.category == model::RegionCategory::Unit ? "a unit without number"
                                                          : std::string(to_word(region.category));
}

void add_astray(const CheckContext& context, Findings& findings) {
    const model::ScannedBox scanned(context.record);
    for (const model::Region& region : context.record.regions) {
        if (!scanned.is_astray(region)) continue;
        const double distance = scanned.distance(region);
        auto d = make_diagnostic(model::Severity::Warning, "region-astray",
                                 fmt::format("the outline of {} {}{} {}", drawn_as(context, region),
                                             where_drawn(context.record, region), near_what(region),
                                             model::astray_words(distance)));
        if (context.index.find(region.unit) != model::kNoUnit) d.units = {region.unit};
        d.evidence["region"] = region.id.to_string();
        d.evidence["distance_m"] = distance;
        findings.push_back(std::move(d));
    }
}

void add_overlaps(const CheckContext& context, Findings& findings) {
    for (const model::OutlineOverlap& overlap : context.overlaps) {
        auto d = make_diagnostic(
            model::Severity::Warning, "region-overlap",
            fmt::format("{} and {} both claim {:.2f} m² near {:.2f} {:.2f}: neither gets that ground, and nothing is "
                        "concluded from it until one of the outlines is redrawn",
                        overlap.first, overlap.second, overlap.area, overlap.x, overlap.y));
        for (const model::UnitId unit : overlap.units) {
            if (context.index.find(unit) != model::kNoUnit) d.units.push_back(unit);
        }
        d.evidence["surface"] = overlap.where;
        d.evidence["region"] = overlap.first;
        d.evidence["other_region"] = overlap.second;
        d.evidence["area_m2"] = overlap.area;
        d.evidence["x"] = overlap.x;
        d.evidence["y"] = overlap.y;
        findings.push_back(std::move(d));
    }
}

// Areas in which somebody outlines; where nobody does, its lack says nothing.
std::set<model::AreaId> outlined_areas(const model::Record& record) {
    std::unordered_map<model::SurfaceId, model::AreaId> area_of;
    for (const model::Surface& surface : record.surfaces) area_of.emplace(surface.id, surface.area);
    std::set<model::AreaId> areas;
    for (const model::Region& region : record.regions) {
        if (const auto it = area_of.find(region.surface); it != area_of.end()) areas.insert(it->second);
    }
    return areas;
}

void add_undrawn(const CheckContext& context, Findings& findings) {
    const std::set<model::AreaId> areas = outlined_areas(context.record);
    if (areas.empty()) return;
    std::set<model::UnitId> drawn;
    for (const model::Region& region : context.record.regions) drawn.insert(region.unit);
    for (const model::StratigraphicUnit& unit : context.record.units) {
        if (unit.status == model::UnitStatus::Void || unit.origin == model::UnitOrigin::Mentioned) continue;
        if (drawn.contains(unit.id)) continue;
        // Surfaces of a site without areas belong to none, and so do all its units.
        if (!areas.contains(unit.area) && !areas.contains({})) continue;
        auto d =
            make_diagnostic(model::Severity::Info, "unit-without-region",
                            fmt::format("{} is outlined on no surface and in no section, so scans say nothing of it",
                                        context.full_name(context.index.find(unit.id))));
        d.units = {unit.id};
        findings.push_back(std::move(d));
    }
}

} // namespace

void check_regions(const CheckContext& context, Findings& findings) {
    add_astray(context, findings);
    add_overlaps(context, findings);
    if (!context.options.with_infos || context.record.scans.empty()) return;
    add_unnamed(context, findings);
    add_undrawn(context, findings);
}

} // namespace planum::strat
