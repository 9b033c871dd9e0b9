// SPDX-License-Identifier: MIT
#include "app/regions/region_draft.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

constexpr std::string_view kOfArea = "::";

bool is_in(const std::vector<model::RegionId>& ids, model::RegionId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// `2025-06-01.2` says its day itself.
std::string day_in(const std::string& name) {
    const std::string head = name.substr(0, 10);
    return is_day(head) && (name.size() == 10 || name[10] == '.') ? head : std::string{};
}

// Takes `AREA::NAME` apart, as lists write it where several areas have a surface of one name.
void split_surface(DrawnOutline& drawn, const model::Record& record) {
    const std::size_t colons = drawn.surface.find(kOfArea);
    const bool plain = std::any_of(record.surfaces.begin(), record.surfaces.end(),
                                   [&](const auto& surface) { return surface.name == drawn.surface; });
    if (colons == std::string::npos || colons == 0 || plain) return;
    const std::string area = drawn.surface.substr(0, colons);
    if (!drawn.area.empty() && drawn.area != area) {
        throw Error(ErrorCode::BadInput, fmt::format("surface {} is not of area {}", drawn.surface, drawn.area));
    }
    drawn.area = area;
    drawn.surface.erase(0, colons + kOfArea.size());
}

template<class T>
void forget(std::vector<T>& things, std::size_t from) {
    things.erase(things.begin() + static_cast<std::ptrdiff_t>(from), things.end());
}

} // namespace

RegionDraft::RegionDraft(const model::Record& record, UuidSource& ids)
    : ids_(ids), record_(record), first_new_(mark()) {}

RegionDraft::Mark RegionDraft::mark() const noexcept {
    return {record_.areas.size(), record_.surfaces.size(), record_.sections.size(), record_.units.size()};
}

void RegionDraft::back_to(const Mark& mark) {
    forget(record_.areas, mark.areas);
    forget(record_.surfaces, mark.surfaces);
    forget(record_.sections, mark.sections);
    forget(record_.units, mark.units);
}

OutlinePlace RegionDraft::place_of(DrawnOutline drawn) {
    OutlinePlace place;
    if (drawn.section) {
        place.area = area_for(drawn.area);
        model::Section section = section_of(drawn);
        if (section.id.is_nil()) {
            section.area = place.area;
            section.id = {ids_.next()};
            record_.sections.push_back(section);
        }
        place.section = section.id;
        if (place.area.is_nil()) place.area = section.area;
        return place;
    }
    split_surface(drawn, record_);
    place.area = area_for(drawn.area);
    const model::Surface& surface = surface_of(drawn, place.area);
    place.surface = surface.id;
    if (place.area.is_nil()) place.area = surface.area;
    return place;
}

model::AreaId RegionDraft::area_for(const std::string& name) {
    if (const auto known = area_meant(record_, name)) return *known;
    model::Area area;
    area.name = name;
    area.method = record_.settings.method;
    area.id = {ids_.next()};
    record_.areas.push_back(area);
    return area.id;
}

const model::Surface& RegionDraft::surface_of(const DrawnOutline& drawn, model::AreaId area) {
    for (const model::Surface& surface : record_.surfaces) {
        if (!drawn.on_surface.is_nil() && surface.id == drawn.on_surface) return surface;
    }
    const std::string day = drawn.day.empty() ? day_in(drawn.surface) : drawn.day;
    if (day.empty() && drawn.surface.empty()) {
        throw Error(ErrorCode::BadInput, "it names neither a surface nor a day; give --day");
    }
    const std::string name = drawn.surface == day ? std::string{} : drawn.surface;
    if (const model::Surface* known = known_surface(area, name, day)) return *known;
    if (day.empty()) throw Error(ErrorCode::BadInput, fmt::format("surface {} is new and has no day", name));
    model::Surface surface = surface_for_day(record_, record_.surfaces, area, day);
    surface.name = name;
    surface.id = {ids_.next()};
    record_.surfaces.push_back(std::move(surface));
    return record_.surfaces.back();
}

const model::Surface* RegionDraft::known_surface(model::AreaId area, const std::string& name,
                                                 const std::string& day) const {
    if (name.empty()) {
        const model::Surface* own = surface_on_day(record_.surfaces, area, day);
        return own != nullptr || area.is_nil() ? own : surface_on_day(record_.surfaces, {}, day);
    }
    if (!area.is_nil()) {
        if (const model::Surface* own = surface_named(record_, name, area)) return own;
    }
    // Scans that came before the site had areas lie on surfaces without one.
    for (const model::Surface& surface : record_.surfaces) {
        if (surface.area.is_nil() && surface_name(record_, surface) == name) return &surface;
    }
    return area.is_nil() ? surface_named(record_, name, {}) : nullptr;
}

model::Section RegionDraft::section_of(const DrawnOutline& drawn) const {
    for (const model::Section& section : record_.sections) {
        if (section.name == drawn.section->name) return section;
    }
    if (!drawn.section->line) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("section {} is new: say its two ends, from and to [x, y]", drawn.section->name));
    }
    model::Section section;
    section.name = drawn.section->name;
    section.from_in_site = drawn.section->line->at(0);
    section.to_in_site = drawn.section->line->at(1);
    section.day = drawn.day;
    return section;
}

const model::StratigraphicUnit* RegionDraft::find_unit(const std::string& number, model::AreaId area) const {
    std::vector<const model::StratigraphicUnit*> hits;
    for (const model::StratigraphicUnit& unit : record_.units) {
        if (unit.number != number) {
            if (qualified(unit) == number) return &unit;
            continue;
        }
        if (unit.area == area) return &unit;
        hits.push_back(&unit);
    }
    if (hits.size() > 1 && area.is_nil()) {
        std::vector<std::string> names;
        for (const auto* hit : hits) names.push_back(qualified(*hit));
        std::sort(names.begin(), names.end(), text::NaturalLess{});
        throw Error(ErrorCode::BadInput, fmt::format("unit {} may be {}; say which, or the area of the outlines",
                                                     number, text::join(names, " or ")));
    }
    if (hits.size() != 1) return nullptr;
    const bool series_fits =
        area.is_nil() || hits.front()->area.is_nil() || record_.settings.numbers == model::NumberScope::Site;
    return series_fits ? hits.front() : nullptr;
}

std::string RegionDraft::qualified(const model::StratigraphicUnit& unit) const {
    for (const model::Area& area : record_.areas) {
        if (area.id == unit.area) return area.name + std::string(kOfArea) + unit.number;
    }
    return unit.number;
}

const model::StratigraphicUnit& RegionDraft::make_unit(const DrawnOutline& drawn, model::AreaId area) {
    model::StratigraphicUnit unit;
    unit.number = drawn.unit;
    unit.area = area;
    for (const model::Area& named : record_.areas) {
        if (!drawn.unit.starts_with(named.name + std::string(kOfArea))) continue;
        unit.area = named.id;
        unit.number = drawn.unit.substr(named.name.size() + kOfArea.size());
    }
    unit.kind = drawn.kind.kind;
    unit.form = drawn.kind.form;
    unit.origin = model::UnitOrigin::Mentioned; // it has no sheet yet
    if (unit.kind == model::UnitKind::Unknown && drawn.shows == model::RegionShows::Cut) {
        unit.kind = model::UnitKind::Cut;
    }
    unit.id = {ids_.next()};
    record_.units.push_back(unit);
    return record_.units.back();
}

std::string RegionDraft::number_as_drawn(const DrawnOutline& drawn, const OutlinePlace& place) const {
    model::Region region;
    region.surface = place.surface;
    region.section = place.section;
    return app::number_as_drawn(record_, region, drawn.unit, place.area);
}

void RegionDraft::add(model::Region region) {
    region.id = {ids_.next()};
    new_regions_.push_back(region.id);
    record_.regions.push_back(std::move(region));
}

void RegionDraft::set_changed(model::RegionId id) {
    if (!is_new(id) && !is_changed(id)) changed_regions_.push_back(id);
}

bool RegionDraft::is_new(model::RegionId id) const { return is_in(new_regions_, id); }

bool RegionDraft::is_changed(model::RegionId id) const { return is_in(changed_regions_, id); }

std::span<const model::Area> RegionDraft::new_areas() const {
    return std::span(record_.areas).subspan(first_new_.areas);
}

std::span<const model::Surface> RegionDraft::new_surfaces() const {
    return std::span(record_.surfaces).subspan(first_new_.surfaces);
}

std::span<const model::Section> RegionDraft::new_sections() const {
    return std::span(record_.sections).subspan(first_new_.sections);
}

std::span<const model::StratigraphicUnit> RegionDraft::new_units() const {
    return std::span(record_.units).subspan(first_new_.units);
}

void RegionDraft::write(store::ProjectFile& file) const {
    for (const model::Area& area : new_areas()) file.insert(area);
    for (const model::Surface& surface : new_surfaces()) file.insert(surface);
    for (const model::Section& section : new_sections()) file.insert(section);
    for (const model::StratigraphicUnit& unit : new_units()) file.insert(unit);
    for (const model::Region& region : record_.regions) {
        if (is_new(region.id)) {
            file.insert(region);
        } else if (is_changed(region.id)) {
            file.update(region);
        }
    }
}

} // namespace planum::app
