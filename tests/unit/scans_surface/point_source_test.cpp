// SPDX-License-Identifier: MIT
#include "scans/surface/point_source.hpp"

#include <memory>

#include "scans/cloud/store_builder.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::scans;

TEST_CASE("A stored floor that is flat to the last digit gives all its points") {
    const test::TemporaryFolder folder;
    PointBlock floor;
    floor.resize(2000, {});
    for (std::size_t i = 0; i < floor.size(); ++i) {
        floor.x[i] = 0.013 * static_cast<double>(i % 50);
        floor.y[i] = 0.017 * static_cast<double>(i / 50);
        floor.z[i] = 10.0;
    }
    StoreBuilder builder(folder / "floor.pts", {});
    builder.add(floor);
    builder.finish(Progress::none());
    geometry::Rigid3 site_from_scan;
    site_from_scan.translation = {100.0, 200.0, -3.0};
    const StorePoints points(std::make_shared<const PointStore>(PointStore::open(folder / "floor.pts")),
                             site_from_scan);
    std::size_t found = 0;
    points.over({99.0, 199.0, 102.0, 202.0}, [&](const PointBlock& block) { found += block.size(); });
    CHECK(found == floor.size());
}
