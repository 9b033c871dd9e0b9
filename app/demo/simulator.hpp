// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/demo/dig_outlines.hpp"
#include "app/demo/dig_record.hpp"
#include "app/demo/dig_surfaces.hpp"
#include "app/demo/simulator_scanner.hpp"
#include "core/base/progress.hpp"

namespace planum::app::demo {

/// What to simulate. The same options give the same bytes, whatever the number of threads.
struct SimulationOptions {
    std::uint64_t seed = 1;
    DemoSize size = DemoSize::Small;
    model::DigMethod method = model::DigMethod::Stratigraphic;
};

/// A simulated excavation with everything that is known about it; the scans are made while writing.
struct DemoDig {
    SimulationOptions options;
    SiteShape site;
    Formation formation;
    DigPlan plan;
    std::shared_ptr<const ColumnGrid> grid; ///< shared: large, and a dig may be copied
    std::shared_ptr<const DugGrid> dug;
    std::vector<Contact> contacts;
    DugVolumes volumes;
    std::vector<SurfaceMap> maps; ///< as the digger recognised them
    SeenContacts seen;
    std::vector<DrawnRegion> regions;
    DigRecord record;
    DigRecord mistaken; ///< the record with seeded mistakes
    std::vector<Mistake> mistakes;
};

[[nodiscard]] DemoDig simulate(const SimulationOptions& options, Progress& progress);

/// One scan of a dig as the files will hold it, and what it was made from; for tests.
struct SimulatedScan {
    Station station;
    ScanImage image;
    std::vector<MeasuredMarker> markers;
};

/// What was written, relative to the folder, in the order of writing.
struct WrittenDemo {
    std::vector<std::filesystem::path> files;
    std::int64_t points = 0;
};

/// Writes DAY/stationN.ptx, markers.csv, outlines/DAY.geojson, the tables of the record, with-mistakes/ and
/// truth.json into the folder. Throws Conflict when the folder holds something else than an earlier demo
/// dig, Io when the disk refuses; then what was begun is taken away.
WrittenDemo write_demo(const DemoDig& dig, const std::filesystem::path& folder, Progress& progress);

/// All scans of one surface.
[[nodiscard]] std::vector<SimulatedScan> scan_surface(const DemoDig& dig, SurfaceNo surface, Progress& progress);

} // namespace planum::app::demo
