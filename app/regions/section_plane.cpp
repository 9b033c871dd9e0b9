// SPDX-License-Identifier: MIT
#include "app/regions/section_plane.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/regions/region_layout.hpp"
#include "core/base/error.hpp"

namespace planum::app {

namespace {

void require_near(const geometry::MultiPolygon& on_plane, const model::Section& section) {
    double farthest = 0.0;
    for (const geometry::Rings& rings : on_plane) {
        for (const geometry::Line3& ring : rings) {
            for (const geometry::Point3& corner : ring) farthest = std::max(farthest, std::abs(corner[2]));
        }
    }
    if (farthest <= kFarthestFromPlane) return;
    throw Error(ErrorCode::BadInput,
                fmt::format("it lies {:.2f} m off the plane of section {}, which runs from {:.2f} {:.2f} to {:.2f} "
                            "{:.2f}; outlines on a section lie within {:g} m of it",
                            farthest, section.name, section.from_in_site[0], section.from_in_site[1],
                            section.to_in_site[0], section.to_in_site[1], kFarthestFromPlane));
}

} // namespace

geometry::SoundPolygon sound_in_site(const geometry::MultiPolygon& shape, const model::Section* section) {
    if (section == nullptr) return geometry::make_sound(shape);
    const geometry::MultiPolygon on_plane = onto_plane(shape, *section);
    require_near(on_plane, *section);
    geometry::SoundPolygon sound = geometry::make_sound(on_plane);
    sound.shape = from_plane(sound.shape, *section);
    return sound;
}

} // namespace planum::app
