// SPDX-License-Identifier: MIT
#include "app/scans/days_surface.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::app {

namespace {

// Positions of the surfaces of one area in the order they were made bare.
std::vector<const model::Surface*> in_order(const std::vector<model::Surface>& all, model::AreaId area) {
    std::vector<const model::Surface*> found;
    for (const model::Surface& surface : all) {
        if (surface.area == area) found.push_back(&surface);
    }
    std::stable_sort(found.begin(), found.end(), [](const model::Surface* a, const model::Surface* b) {
        return std::tie(a->order, a->first_day) < std::tie(b->order, b->first_day);
    });
    return found;
}

// Ascending in time without touching what is there: YYYYMMDD and a digit for the surfaces of one day.
std::int64_t order_of_day(std::string_view day) {
    std::int64_t digits = 0;
    for (const char c : day) {
        if (c != '-') digits = digits * 10 + (c - '0');
    }
    return digits * 10;
}

std::string plain_name(const model::Record& record, const model::Surface& surface) {
    if (!surface.name.empty()) return surface.name;
    std::size_t place = 0;
    for (const model::Surface* other : in_order(record.surfaces, surface.area)) {
        if (other->name.empty() && other->first_day == surface.first_day) ++place;
        if (other->id == surface.id) break;
    }
    return place > 1 ? fmt::format("{}.{}", surface.first_day, place) : surface.first_day;
}

std::string with_area(const model::Record& record, const model::Surface& surface, const std::string& name) {
    for (const model::Area& area : record.areas) {
        if (area.id == surface.area) return area.name + "::" + name;
    }
    return name;
}

} // namespace

void require_day(std::string_view option, std::string_view text) {
    if (is_day(text)) return;
    throw Error(ErrorCode::Usage, fmt::format("{} {}: not a day of the calendar as 2025-06-01", option, text));
}

bool holds_day(const model::Surface& surface, std::string_view day) noexcept {
    return surface.first_day <= day && day <= last_day_of(surface);
}

std::optional<model::AreaId> area_meant(const model::Record& record, std::string_view name) {
    if (name.empty()) return record.areas.size() == 1 ? record.areas.front().id : model::AreaId{};
    for (const model::Area& area : record.areas) {
        if (area.name == name) return area.id;
    }
    return std::nullopt;
}

std::string surface_name(const model::Record& record, const model::Surface& surface) {
    const std::string name = plain_name(record, surface);
    const bool shared = std::any_of(record.surfaces.begin(), record.surfaces.end(), [&](const model::Surface& other) {
        return other.area != surface.area && plain_name(record, other) == name;
    });
    return shared ? with_area(record, surface, name) : name;
}

const model::Surface* surface_named(const model::Record& record, std::string_view name, model::AreaId area) {
    const model::Surface* found = nullptr;
    for (const model::Surface& surface : record.surfaces) {
        if (!area.is_nil() && surface.area != area) continue;
        const std::string plain = plain_name(record, surface);
        if (plain != name && with_area(record, surface, plain) != name) continue;
        if (found != nullptr) {
            throw Error(ErrorCode::Usage, fmt::format("surface {} exists in several areas; say which area", name));
        }
        found = &surface;
    }
    return found;
}

model::Surface surface_for_day(const model::Record& record, const std::vector<model::Surface>& surfaces,
                               model::AreaId area, std::string_view day) {
    model::Surface surface;
    surface.area = area;
    surface.first_day = day;
    surface.last_day = day;
    surface.order = order_of_day(day);
    for (const model::Surface* other : in_order(surfaces, area)) {
        if (other->first_day == day) surface.order = std::max(surface.order, other->order + 1);
    }
    surface.method = record.settings.method;
    for (const model::Area& a : record.areas) {
        if (a.id == area) surface.method = a.method;
    }
    return surface;
}

const model::Surface* surface_on_day(const std::vector<model::Surface>& surfaces, model::AreaId area,
                                     std::string_view day) {
    const std::vector<const model::Surface*> there = in_order(surfaces, area);
    const auto found =
        std::find_if(there.rbegin(), there.rend(), [&](const model::Surface* s) { return holds_day(*s, day); });
    return found == there.rend() ? nullptr : *found;
}

model::SurfaceId surface_of_day(Project& project, std::vector<model::Surface>& surfaces, model::AreaId area,
                                std::string_view day) {
    if (const model::Surface* there = surface_on_day(surfaces, area, day)) return there->id;
    model::Surface surface = surface_for_day(project.record(), surfaces, area, day);
    surface.id = project.file().insert(surface);
    surfaces.push_back(surface);
    return surface.id;
}

} // namespace planum::app
