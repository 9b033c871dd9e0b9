// SPDX-License-Identifier: MIT
#include "core/model/astray.hpp"

#include "tests/support/catch.hpp"

using namespace planum;

namespace {

model::Record record_with_set_ups() {
    model::Record record;
    model::RegistrationRun run;
    run.id = model::RegistrationRunId{Uuid{2, 1}};
    run.state = "accepted";
    record.runs.push_back(run);
    for (std::uint64_t i = 0; i < 2; ++i) {
        model::Scan scan;
        scan.id = model::ScanId{Uuid{1, i}};
        record.scans.push_back(scan);
        model::ScanPose pose;
        pose.scan = scan.id;
        pose.run = run.id;
        pose.site_from_scan[3] = 100.0 + 10.0 * static_cast<double>(i);
        pose.site_from_scan[7] = 200.0;
        record.poses.push_back(pose);
    }
    return record;
}

model::Region square_at(double x, double y) {
    model::Region region;
    region.outline = {{{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}, {}}};
    return region;
}

} // namespace

TEST_CASE("Outlines far from all set-ups of scanners are astray, by their farthest corner") {
    const model::Record record = record_with_set_ups();
    const model::ScannedBox box(record);
    CHECK(box.distance(square_at(104, 199.5)) == Approx(0.5));
    CHECK_FALSE(box.is_astray(square_at(104, 203)));
    CHECK(box.distance(square_at(113, 203)) == Approx(std::hypot(4.0, 4.0)));
    CHECK_FALSE(box.is_astray(square_at(208.9, 199.5)));
    CHECK(box.is_astray(square_at(209.5, 200)));
    CHECK(box.is_astray(square_at(8.1, 48.1))); // degrees
    CHECK(box.is_astray(square_at(3500000, 5500000)));
}

TEST_CASE("Without placed scans nothing is known to be astray, nor is an outline without points") {
    CHECK_FALSE(model::ScannedBox(model::Record{}).is_astray(square_at(3500000, 5500000)));
    model::Record raw = record_with_set_ups();
    raw.runs[0].state = "proposed";
    CHECK_FALSE(model::ScannedBox(raw).is_astray(square_at(3500000, 5500000)));
    CHECK(model::ScannedBox(record_with_set_ups()).distance(model::Region{}) == 0.0);
}
