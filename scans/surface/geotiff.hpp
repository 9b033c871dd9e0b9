// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// One number for each cell of a frame; not a number where nothing is known.
struct RasterBand {
    std::string name; ///< as other programs show it
    std::span<const float> values;
};

/// Bands as the bytes of a GeoTIFF (TIFF 6.0, OGC 19-008): 32-bit numbers, north up, -9999 where nothing is known, a
/// strip for each band. `epsg` ≤ 0 or above 32766: a local grid in metres. Throws BadInput when it would be over 4 GB,
/// Usage for no band or a band that is not of this frame.
[[nodiscard]] std::string geotiff(const GridFrame& frame, std::span<const RasterBand> bands, std::int64_t epsg);

/// The six lines of a world file (.tfw) for a raster of that frame.
[[nodiscard]] std::string world_file(const GridFrame& frame);

} // namespace planum::scans
