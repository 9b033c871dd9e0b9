// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/demo/simulator.hpp"

namespace planum::app::demo {

/// A gridded PTX without pose: the header is the identity, coordinates are the scanner's [m].
[[nodiscard]] std::string ptx_text(const ScanImage& image);

/// The tables of a record in our own CSV: file name and content.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> record_tables(const DigRecord& record,
                                                                             const DigPlan& plan);

/// The outlines of one surface as GeoJSON in site coordinates.
[[nodiscard]] std::string outlines_geojson(const DemoDig& dig, SurfaceNo surface);

/// What is known of one scan that was written.
struct ScanTruth {
    Station station;
    std::int64_t points = 0;
    std::int64_t mixed = 0;
    bool people = false;
    std::size_t markers = 0;
};

/// All that is true of the dig; docs/demo.md says what the keys mean.
[[nodiscard]] std::string truth_json(const DemoDig& dig, const std::vector<ScanTruth>& scans);

} // namespace planum::app::demo
