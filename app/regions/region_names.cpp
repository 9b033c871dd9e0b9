// SPDX-License-Identifier: MIT
#include "app/regions/region_names.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "app/scans/days_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

// Whether only `#n` tells the names of two regions apart.
bool same_label(const model::Region& a, const model::Region& b) {
    if (a.surface != b.surface || a.section != b.section || a.unit != b.unit) return false;
    if (!a.unit.is_nil()) return true;
    return a.unit_as_drawn == b.unit_as_drawn && (!a.unit_as_drawn.empty() || a.category == b.category);
}

std::string place_name(const model::Record& record, const model::Region& region) {
    for (const model::Surface& surface : record.surfaces) {
        if (!region.surface.is_nil() && surface.id == region.surface) return surface_name(record, surface);
    }
    const model::Section* section = section_of(record, region);
    return section == nullptr ? "?" : section->name;
}

} // namespace

std::string region_label(const model::Record& /*record*/, const model::RecordIndex& index,
                         const model::Region& region) {
    if (!region.unit.is_nil()) return index.name(region.unit);
    if (!region.unit_as_drawn.empty()) return region.unit_as_drawn;
    return region.category == model::RegionCategory::Unit ? "?" : std::string(to_word(region.category));
}

std::string region_name(const model::Record& record, const model::RecordIndex& index, const model::Region& region) {
    return fmt::format("{}/{}#{}", place_name(record, region), region_label(record, index, region), region.part);
}

const model::Region& region_named(Project& project, std::string_view name) {
    const std::string wanted{text::trim(name)};
    std::vector<const model::Region*> hits;
    for (const model::Region& region : project.record().regions) {
        const std::string full = region_name(project.record(), project.index(), region);
        if (full == wanted) return region;
        if (full.substr(0, full.rfind('#')) == wanted) hits.push_back(&region);
    }
    if (hits.size() == 1) return *hits.front();
    if (hits.empty()) {
        throw Error(ErrorCode::NotFound,
                    fmt::format("no region {}; planum region list names all, as SURFACE/UNIT#n", wanted));
    }
    std::vector<std::string> names;
    for (const auto* hit : hits) names.push_back(region_name(project.record(), project.index(), *hit));
    std::sort(names.begin(), names.end(), text::NaturalLess{});
    throw Error(ErrorCode::Usage, fmt::format("{} has several parts; say which: {}", wanted, text::join(names, ", ")));
}

std::string region_day(const model::Record& record, const model::Region& region) {
    for (const model::Surface& surface : record.surfaces) {
        if (!region.surface.is_nil() && surface.id == region.surface) return surface.first_day;
    }
    const model::Section* section = section_of(record, region);
    return section == nullptr ? std::string{} : section->day;
}

std::vector<std::size_t> regions_in_order(const model::Record& record, const model::RecordIndex& index) {
    struct Key {
        bool section;
        std::string day;
        std::string place;
        std::string label;
        std::int64_t part;
    };

    std::vector<Key> keys;
    for (const model::Region& region : record.regions) {
        keys.push_back({region.surface.is_nil(), region_day(record, region), place_name(record, region),
                        region_label(record, index, region), region.part});
    }
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const Key& a = keys[i];
        const Key& b = keys[j];
        if (std::tie(a.section, a.day) != std::tie(b.section, b.day)) {
            return std::tie(a.section, a.day) < std::tie(b.section, b.day);
        }
        if (const auto place = text::natural_order(a.place, b.place); place != 0) return place < 0;
        if (const auto label = text::natural_order(a.label, b.label); label != 0) return label < 0;
        return a.part < b.part;
    });
    return order;
}

const model::Section* section_of(const model::Record& record, const model::Region& region) {
    if (!region.surface.is_nil()) return nullptr;
    const auto it = std::find_if(record.sections.begin(), record.sections.end(),
                                 [&](const model::Section& section) { return section.id == region.section; });
    return it == record.sections.end() ? nullptr : &*it;
}

std::int64_t free_part(const model::Record& record, const model::Region& region) {
    std::int64_t last = 0;
    bool taken = false;
    for (const model::Region& other : record.regions) {
        if (other.id == region.id || !same_label(region, other)) continue;
        last = std::max(last, other.part);
        taken = taken || other.part == region.part;
    }
    return taken ? last + 1 : region.part;
}

std::string number_as_drawn(const model::Record& record, const model::Region& region, std::string number,
                            model::AreaId area) {
    constexpr std::string_view kOfArea = "::";
    for (const model::Area& named : record.areas) { // said already
        if (!number.starts_with(named.name + std::string(kOfArea))) continue;
        number.erase(0, named.name.size() + kOfArea.size());
        area = named.id;
        break;
    }
    if (area.is_nil() || record.settings.numbers == model::NumberScope::Site) return number;
    const model::Section* section = section_of(record, region);
    model::AreaId own = section == nullptr ? model::AreaId{} : section->area;
    for (const model::Surface& surface : record.surfaces) {
        if (!region.surface.is_nil() && surface.id == region.surface) own = surface.area;
    }
    if (own == area) return number;
    for (const model::Area& named : record.areas) {
        if (named.id == area) return named.name + std::string(kOfArea) + number;
    }
    return number;
}

std::vector<std::string> proposed_numbers(const model::Record& record, const std::string& drawn) {
    const std::size_t colons = drawn.rfind("::");
    const std::string number = colons == std::string::npos ? drawn : drawn.substr(colons + 2);
    constexpr std::size_t kMost = 5;
    std::vector<std::string> near = near_numbers(record, number, kMost);
    if (!near.empty()) return near;
    const auto wanted = text::parse_integer(number);
    if (!wanted) return near;
    std::vector<std::pair<long long, std::string>> by_distance;
    for (const model::StratigraphicUnit& unit : record.units) {
        const auto value = text::parse_integer(unit.number);
        if (value) by_distance.emplace_back(*value > *wanted ? *value - *wanted : *wanted - *value, unit.number);
    }
    std::sort(by_distance.begin(), by_distance.end());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, by_distance.size()); ++i)
        near.push_back(by_distance[i].second);
    return near;
}

model::RegionShows usual_shows(const model::Record& record, const model::Region& region, model::UnitKind kind) {
    for (const model::StratigraphicUnit& unit : record.units) {
        if (!region.unit.is_nil() && unit.id == region.unit) kind = unit.kind;
    }
    model::DigMethod method = record.settings.method;
    for (const model::Surface& surface : record.surfaces) {
        if (surface.id == region.surface) method = surface.method;
    }
    return default_shows(region.category, kind, method, region.surface.is_nil());
}

model::RegionShows default_shows(model::RegionCategory category, model::UnitKind kind, model::DigMethod method,
                                 bool on_section) noexcept {
    using model::RegionShows;
    if (category != model::RegionCategory::Unit) return RegionShows::Nothing;
    if (on_section) return RegionShows::Face;
    if (kind == model::UnitKind::Cut) return RegionShows::Cut;
    const bool stands = kind == model::UnitKind::Structure || kind == model::UnitKind::Skeleton;
    return method == model::DigMethod::Stratigraphic || stands ? RegionShows::Top : RegionShows::Level;
}

} // namespace planum::app
