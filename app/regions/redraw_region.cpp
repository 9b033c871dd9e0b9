// SPDX-License-Identifier: MIT
#include "app/regions/redraw_region.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "app/regions/outline.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/section_plane.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"

namespace planum::app {

std::vector<std::string> redraw_region(Project& project, model::RegionId id, const geometry::MultiPolygon& drawn_over,
                                       geometry::MultiPolygon outline) {
    const model::Record& record = project.record();
    const auto found = std::find_if(record.regions.begin(), record.regions.end(),
                                    [&](const model::Region& region) { return region.id == id; });
    if (found == record.regions.end()) throw Error(ErrorCode::NotFound, "the region is no longer there");
    model::Region region = *found;
    const std::string name = region_name(record, project.index(), region);
    if (shape_of(region.outline) != drawn_over) {
        throw Error(ErrorCode::Conflict, fmt::format("{}: its outline was changed meanwhile; nothing was done", name));
    }
    const model::Section* section = section_of(record, region);
    region.has_heights = settle_heights(outline) || section != nullptr;
    const geometry::SoundPolygon sound = sound_in_site(outline, section);
    region.outline = outline_of(sound.shape);
    project.change(fmt::format("Redraw region {}", name), [&] { project.file().update(region); });
    return sound.repairs;
}

} // namespace planum::app
