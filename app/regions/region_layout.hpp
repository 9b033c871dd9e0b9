// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/gpb.hpp"
#include "core/model/record.hpp"

namespace planum::app {

/// A region as it lies among the others of its surface.
struct PlacedRegion {
    const model::Region* region = nullptr; ///< of the record
    geometry::MultiPolygon drawn;          ///< made sound
    geometry::MultiPolygon shown;          ///< less what lies inside it and less what is disputed; may be empty
};

/// Two regions of one surface that claim the same ground, by more than the σ of their lines explains.
struct RegionOverlap {
    const model::Region* first = nullptr;
    const model::Region* second = nullptr;
    geometry::MultiPolygon where;
    double area = 0.0; ///< [m²]
};

struct RegionLayout {
    std::vector<PlacedRegion> regions; ///< in the order they were given
    std::vector<RegionOverlap> overlaps;
    std::vector<const model::Region*> unusable; ///< no valid outline (drawn over in another program)
};

/// Lays the regions of one surface (or of one section, in its plane) over each other: one that lies inside another cuts
/// its own hole; the sliver along a line that both drew goes to the smaller; any other overlap is reported and
/// belongs to neither. Afterwards no two `shown` outlines meet. The record must outlive the result, unchanged.
[[nodiscard]] RegionLayout layout_regions(const std::vector<const model::Region*>& regions,
                                          const model::Section* section = nullptr);

/// Regions of a surface, or of a section, in the order of the record.
[[nodiscard]] std::vector<const model::Region*> regions_on(const model::Record& record, model::SurfaceId surface);
[[nodiscard]] std::vector<const model::Region*> regions_on(const model::Record& record, model::SectionId section);

/// Area of a region [m²]: in plan, or in the plane of its section.
[[nodiscard]] double region_area(const model::Record& record, const model::Region& region);

/// Site coordinates to (metres along the section, height, distance from its plane) and back.
[[nodiscard]] geometry::MultiPolygon onto_plane(const geometry::MultiPolygon& in_site, const model::Section& section);
[[nodiscard]] geometry::MultiPolygon from_plane(const geometry::MultiPolygon& on_plane, const model::Section& section);

} // namespace planum::app
