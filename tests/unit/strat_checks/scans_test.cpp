// SPDX-License-Identifier: MIT
#include <algorithm>

#include "strat/checks/check.hpp"
#include "strat/matrix/harris_matrix.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/record_builder.hpp"

using namespace planum;

namespace {

/// Two units and as many scans as asked for, all in one accepted run with this σ, but the first `raw` ones.
model::Record record_with_scans(std::size_t scans, std::size_t raw, double sigma) {
    auto builder = test::a_record();
    model::Record record = builder.covers("1", "2").record();
    SeededUuids ids(7);
    model::RegistrationRun run;
    run.id = model::RegistrationRunId{ids.next()};
    run.name = "1";
    run.state = "accepted";
    record.runs.push_back(run);
    for (std::size_t i = 0; i < scans; ++i) {
        model::Scan scan;
        scan.id = model::ScanId{ids.next()};
        scan.name = "2025-06-01/station" + std::to_string(i + 1);
        record.scans.push_back(scan);
        if (i < raw) continue;
        model::ScanPose pose;
        pose.scan = scan.id;
        pose.run = run.id;
        for (std::size_t k = 3; k < 6; ++k) pose.covariance[k * 7] = sigma * sigma;
        record.poses.push_back(pose);
    }
    return record;
}

std::vector<model::Diagnostic> said(const model::Record& record, std::string_view code) {
    const strat::HarrisMatrix matrix = strat::HarrisMatrix::build(record);
    auto all = strat::check(record, matrix, {}, {}, Progress::none()).diagnostics;
    std::erase_if(all, [&](const model::Diagnostic& d) { return d.code != code; });
    return all;
}

} // namespace

TEST_CASE("A scan that is not on the site grid is said, each under an id of its own") {
    const auto found = said(record_with_scans(3, 2, 0.001), "scan-unregistered");
    REQUIRE(found.size() == 2);
    CHECK(found[0].id != found[1].id);
    CHECK_THAT(found[0].message, Catch::Contains("station1"));
    CHECK(said(record_with_scans(0, 0, 0.0), "scan-unregistered").empty());
}

TEST_CASE("Many unregistered scans are one line that names some") {
    const auto found = said(record_with_scans(30, 30, 0.0), "scan-unregistered");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Catch::Contains("30 scans") && Catch::Contains("station1"));
}

TEST_CASE("A scan whose place is not sure is said with its σ, a good one is not") {
    CHECK(said(record_with_scans(2, 0, 0.001), "scan-poorly-registered").empty());
    const auto found = said(record_with_scans(2, 0, 0.020), "scan-poorly-registered");
    REQUIRE(found.size() == 2);
    CHECK_THAT(found[0].message, Catch::Contains("20 mm"));
}

TEST_CASE("A run that was discarded places nothing") {
    auto record = record_with_scans(1, 0, 0.001);
    record.runs[0].state = "discarded";
    CHECK(said(record, "scan-unregistered").size() == 1);
}
