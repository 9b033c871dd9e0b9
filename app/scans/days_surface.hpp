// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "core/base/calendar.hpp"
#include "core/model/place.hpp"

namespace planum::app {

/// Throws Usage, naming the option, when the text is no day of the calendar.
void require_day(std::string_view option, std::string_view text);

/// Whether a day falls into those of a surface.
[[nodiscard]] bool holds_day(const model::Surface& surface, std::string_view day) noexcept;

/// The area of that name; for an empty name the only one there is, nil where there is none or several. nullopt: no area
/// has that name.
[[nodiscard]] std::optional<model::AreaId> area_meant(const model::Record& record, std::string_view name);

/// What a surface is called in lists and region names: its name, else its first day, and `DAY.2` for the
/// second surface of a day without a name of its own; `AREA::NAME` where several areas have one of that name.
[[nodiscard]] std::string surface_name(const model::Record& record, const model::Surface& surface);

/// The surface that a person means by its name, `DAY`, `DAY.2` or `AREA::NAME`; nullptr when there is none. A nil area
/// means any. Throws Usage when several areas have one of that name.
[[nodiscard]] const model::Surface* surface_named(const model::Record& record, std::string_view name,
                                                  model::AreaId area);

/// A surface as it would be made for a day: with the method of its area, else of the project, after the others of that
/// day and area. Its id is nil, its name empty.
[[nodiscard]] model::Surface surface_for_day(const model::Record& record, const std::vector<model::Surface>& surfaces,
                                             model::AreaId area, std::string_view day);

/// The last surface of that area that the day falls into; nullptr when there is none.
[[nodiscard]] const model::Surface* surface_on_day(const std::vector<model::Surface>& surfaces, model::AreaId area,
                                                   std::string_view day);

/// The surface of that day and area: the last one that the day falls into, else a new one with the area's
/// (or project's) method. Call inside Project::change(); `surfaces` begins as those of the record, and a new
/// one is added to it so that the next call finds it.
model::SurfaceId surface_of_day(Project& project, std::vector<model::Surface>& surfaces, model::AreaId area,
                                std::string_view day);

} // namespace planum::app
