// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::app {

struct PanoramaRequest {
    std::string projection = "equirectangular"; ///< see scans::projection_name
    std::string channel; ///< reflectance, range, colour, normals; empty: the first that the scan has
    int width = 0;       ///< [px]; 0: a pixel for each cell of the scanner's grid, else for about one point
    int views = 0;       ///< side by side, of rectilinear, Pannini and stereographic; 0: as many as are needed
};

/// What `planum panorama` made.
struct WrittenPanorama {
    std::string scan;
    std::filesystem::path picture;
    std::filesystem::path description; ///< JSON beside it
    std::string channel;
    int width = 0; ///< [px]
    int height = 0;
    double azimuth_left_deg = 0.0;
    double azimuth_right_deg = 0.0;
    double elevation_top_deg = 0.0;
    double elevation_bottom_deg = 0.0;
    std::uint64_t points = 0;                             ///< in the picture
    std::uint64_t outside = 0;                            ///< above or below what the projection shows
    std::uint64_t filled = 0;                             ///< pixels that show something
    bool from_grid = false;                               ///< a pixel is a cell of the scanner's grid
    std::optional<std::array<double, 16>> site_from_scan; ///< row-major
};

/// Draws the panorama of a scan into a PNG with a JSON beside it; makes the store again where it is gone. The project
/// is not written. Throws NotFound, Usage, BadInput, Io.
WrittenPanorama write_scan_panorama(Project& project, std::string_view scan, const std::filesystem::path& png,
                                    const PanoramaRequest& request, Progress& progress);

} // namespace planum::app
