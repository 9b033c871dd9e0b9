// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/project/project.hpp"
#include "app/regions/outline.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/rigid.hpp"
#include "scans/panorama/panorama.hpp"
#include "strat/exchange/json_support.hpp"

namespace planum::app {

/// Outlines drawn on one picture of one scan; their shapes are in pixels (u to the right, v downwards, from 0).
struct PixelPicture {
    std::string scan;
    scans::ProjectionOptions projection;
    std::vector<DrawnOutline> outlines;
    std::vector<OutlineNote> notes; ///< of outlines that could not be read
};

/// Whether a file holds outlines in pixels rather than GeoJSON.
[[nodiscard]] bool is_pixel_outlines(const strat::Json& json);

/// Reads pixel polygons (docs/formats/outlines.md). Throws BadInput.
[[nodiscard]] std::vector<PixelPicture> read_pixel_outlines(std::string_view bytes);
[[nodiscard]] std::vector<PixelPicture> pixel_outlines_from(const strat::Json& json);

/// A polygon of a picture on the ground: corners and the lines between them, which are straight in the picture only,
/// are followed on the surface that the pixels show, and simplified to 5 mm. A corner whose pixel shows nothing takes
/// the nearest within 3 px. Throws BadInput with the pixel where nothing is to be seen.
[[nodiscard]] geometry::MultiPolygon outline_under_pixels(const scans::Panorama& panorama,
                                                          const geometry::Rigid3& site_from_scan,
                                                          const geometry::MultiPolygon& in_pixels);

/// One line between two pixels on the ground, in the same way; both ends are in it.
[[nodiscard]] geometry::Line3 line_under_pixels(const scans::Panorama& panorama, const geometry::Rigid3& site_from_scan,
                                                const geometry::Point3& from, const geometry::Point3& to);

/// All outlines in site coordinates, on the surfaces of their scans. Scans without a pose and outlines over nothing
/// become notes. Throws NotFound for a scan that is not in the project.
[[nodiscard]] OutlineFile outlines_from_pixels(Project& project, const std::vector<PixelPicture>& pictures,
                                               Progress& progress);

} // namespace planum::app
