// SPDX-License-Identifier: MIT
#include "core/model/zero_heights.hpp"

#include "tests/support/catch.hpp"

using namespace planum;

namespace {

const model::SurfaceId kSurface{Uuid{1, 1}};

model::Region region_at(double z, model::SurfaceId surface = kSurface) {
    model::Region region;
    region.surface = surface;
    region.outline = {{{{0, 0, z}, {4, 0, z}, {4, 4, z}}, {}}};
    return region;
}

bool first_has_heights(model::Record record) {
    model::forget_zero_heights(record);
    return record.regions.front().has_heights;
}

} // namespace

TEST_CASE("An outline at 0 has no heights where the ground lies elsewhere, or where nobody says where it lies") {
    model::Record record;
    record.regions = {region_at(0.0)};
    CHECK_FALSE(first_has_heights(record));
    record.regions.push_back(region_at(48.0));
    CHECK_FALSE(first_has_heights(record));
    model::Level level;
    level.z = 48.2;
    record.levels = {level};
    CHECK_FALSE(first_has_heights(record));
}

TEST_CASE("On a site whose datum is 0 an outline at 0 keeps its heights") {
    model::Record record;
    record.regions = {region_at(0.0), region_at(0.3)};
    CHECK(first_has_heights(record));
    record.regions.pop_back();
    model::Level level;
    level.z = -0.2;
    record.levels = {level};
    CHECK(first_has_heights(record));
    record.levels.clear();
    model::Scan scan;
    scan.id = model::ScanId{Uuid{2, 1}};
    model::RegistrationRun run;
    run.id = model::RegistrationRunId{Uuid{3, 1}};
    run.state = "accepted";
    model::ScanPose pose;
    pose.scan = scan.id;
    pose.run = run.id;
    pose.site_from_scan[11] = 1.7; // the instrument stands 1.7 m above what it looks at
    record.scans = {scan};
    record.runs = {run};
    record.poses = {pose};
    CHECK(first_has_heights(record));
}

TEST_CASE("Other outlines of its surface say where an outline lies before the rest of the site does") {
    model::Record record;
    record.regions = {region_at(0.0), region_at(-3.0), region_at(0.1, model::SurfaceId{Uuid{1, 2}})};
    CHECK_FALSE(first_has_heights(record));
}
