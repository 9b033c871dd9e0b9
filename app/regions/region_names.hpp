// SPDX-License-Identifier: MIT
#pragma once

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

/// What a region shows unless somebody says otherwise, from the method of its surface and the kind of its unit: what is
/// no unit shows nothing, on a section all shows a face, a cut shows the cut, structures and skeletons their top,
/// other units their top on stratigraphic surfaces and the artificial level on others.
[[nodiscard]] model::RegionShows default_shows(model::RegionCategory category, model::UnitKind kind,
                                               model::DigMethod method, bool on_section) noexcept;

} // namespace planum::app
