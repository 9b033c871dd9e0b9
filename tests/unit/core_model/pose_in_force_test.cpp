// SPDX-License-Identifier: MIT
#include "core/model/record.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using model::pose_in_force;

namespace {

const model::ScanId kScan{Uuid{1, 1}};

void add_run(model::Record& record, const char* name, const char* made_at, const char* state, double x) {
    model::RegistrationRun run;
    run.id = model::RegistrationRunId{Uuid{2, record.runs.size()}};
    run.name = name;
    run.made_at = made_at;
    run.state = state;
    record.runs.push_back(run);
    model::ScanPose pose;
    pose.scan = kScan;
    pose.run = run.id;
    pose.site_from_scan[3] = x;
    record.poses.push_back(pose);
}

} // namespace

TEST_CASE("The pose in force is that of the accepted run made last") {
    model::Record record;
    add_run(record, "1", "2025-06-03T10:00:00Z", "proposed", 1.0);
    CHECK(pose_in_force(record, kScan) == nullptr);
    add_run(record, "2", "2025-06-02T10:00:00Z", "accepted", 2.0);
    add_run(record, "3", "2025-06-01T10:00:00Z", "accepted", 3.0);
    REQUIRE(pose_in_force(record, kScan) != nullptr);
    CHECK(pose_in_force(record, kScan)->site_from_scan[3] == 2.0);
    CHECK(pose_in_force(record, model::ScanId{Uuid{1, 2}}) == nullptr);
}

TEST_CASE("Of accepted runs of one time the tenth holds, not the second") {
    model::Record record;
    add_run(record, "10", "2025-06-02T10:00:00Z", "accepted", 10.0);
    add_run(record, "2", "2025-06-02T10:00:00Z", "accepted", 2.0);
    REQUIRE(pose_in_force(record, kScan) != nullptr);
    CHECK(pose_in_force(record, kScan)->site_from_scan[3] == 10.0);
}
