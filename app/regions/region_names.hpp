// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"

namespace planum::app {

/// What a region is called by: its unit, else the number as drawn, else its category; `?` for a unit without number.
[[nodiscard]] std::string region_label(const model::Record& record, const model::RecordIndex& index,
                                       const model::Region& region);

/// `SURFACE/UNIT#n`, or `SECTION/UNIT#n`.
[[nodiscard]] std::string region_name(const model::Record& record, const model::RecordIndex& index,
                                      const model::Region& region);

/// The region of that name; `#n` may be left out where there is one only. Throws NotFound or Usage.
[[nodiscard]] const model::Region& region_named(Project& project, std::string_view name);

/// The surface's first day, or the section's day; empty when unknown.
[[nodiscard]] std::string region_day(const model::Record& record, const model::Region& region);

/// Positions of all regions: by surface in time, then sections by name, then by unit naturally and part.
[[nodiscard]] std::vector<std::size_t> regions_in_order(const model::Record& record, const model::RecordIndex& index);

/// The section that a region lies on; nullptr when it lies on a surface.
[[nodiscard]] const model::Section* section_of(const model::Record& record, const model::Region& region);

/// The part that makes the name of a region its own among those of the record: its own where that is free, else the
/// next.
[[nodiscard]] std::int64_t free_part(const model::Record& record, const model::Region& region);

/// A number as a region keeps it while no unit has it, or while somebody has given the region another unit: with its
/// area where each area counts for itself and the region's surface or section is not of that area.
[[nodiscard]] std::string number_as_drawn(const model::Record& record, const model::Region& region, std::string number,
                                          model::AreaId area);

/// Issued numbers that an unknown one may stand for: one slip of the hand away, else the nearest in value.
[[nodiscard]] std::vector<std::string> proposed_numbers(const model::Record& record, const std::string& drawn);

/// What a region shows unless somebody says otherwise, by default_shows; `kind` counts while the region has no unit.
[[nodiscard]] model::RegionShows usual_shows(const model::Record& record, const model::Region& region,
                                             model::UnitKind kind = model::UnitKind::Unknown);

/// What a region shows unless somebody says otherwise, from the method of its surface and the kind of its unit: what is
/// no unit shows nothing, on a section all shows a face, a cut shows the cut, structures and skeletons their top,
/// other units their top on stratigraphic surfaces and the artificial level on others.
[[nodiscard]] model::RegionShows default_shows(model::RegionCategory category, model::UnitKind kind,
                                               model::DigMethod method, bool on_section) noexcept;

} // namespace planum::app
