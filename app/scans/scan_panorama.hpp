// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "app/scans/panorama_file.hpp"
#include "core/base/progress.hpp"
#include "scans/cloud/point_store.hpp"
#include "scans/panorama/panorama.hpp"
#include "scans/panorama/scan_extent.hpp"

namespace planum::app {

/// What a scan shows, from all its points.
[[nodiscard]] scans::ScanExtent scan_extent(const scans::PointStore& store, Progress& progress);

/// The panorama of a scan in the scanner's frame. Extent and size are those of the scan unless the request says
/// otherwise; Panorama::source counts in the order of the store. Throws Usage for an unknown projection or a size that
/// cannot be drawn.
[[nodiscard]] scans::Panorama scan_panorama(const scans::PointStore& store, const scans::ScanExtent& extent,
                                            const PanoramaRequest& request, Progress& progress);

/// The channel of that name, or the first that the scan has. Throws Usage for an unknown one, BadInput for one that
/// the scan lacks.
[[nodiscard]] scans::Channel panorama_channel(const scans::PointStore& store, std::string_view name);

} // namespace planum::app
