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

namespace {

/// Units 1 and 2, one scan, and a surface with an outline of unit 1.
model::Record record_with_outline() {
    model::Record record = record_with_scans(1, 0, 0.001);
    SeededUuids ids(8);
    model::Surface surface;
    surface.id = model::SurfaceId{ids.next()};
    surface.first_day = "2025-06-01";
    record.surfaces.push_back(surface);
    model::Region region;
    region.id = model::RegionId{ids.next()};
    region.surface = surface.id;
    region.unit = record.units[0].id;
    region.outline = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}}};
    record.regions.push_back(region);
    return record;
}

} // namespace

TEST_CASE("An outline that waits for its unit is said with the number that was drawn") {
    model::Record record = record_with_outline();
    CHECK(said(record, "region-without-unit").empty());
    model::Region region = record.regions[0];
    region.id = model::RegionId{SeededUuids(9).next()};
    region.unit = {};
    region.unit_as_drawn = "17";
    record.regions.push_back(region);
    const auto found = said(record, "region-without-unit");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Catch::Contains("2025-06-01") && Catch::Contains("17"));
    record.regions[1].category = model::RegionCategory::Spoil; // no unit is meant
    CHECK(said(record, "region-without-unit").empty());
    record.regions[1].category = model::RegionCategory::Unit;
    record.scans.clear();
    CHECK(said(record, "region-without-unit").empty());
}

TEST_CASE("A unit that nobody outlined is said where others of its area are outlined") {
    model::Record record = record_with_outline();
    const auto found = said(record, "unit-without-region");
    REQUIRE(found.size() == 1);
    CHECK(found[0].units == std::vector{record.units[1].id});
    const auto is_silent = [&] { return said(record, "unit-without-region").empty(); };
    SECTION("a void one is not") {
        record.units[1].status = model::UnitStatus::Void;
        CHECK(is_silent());
    }
    SECTION("one that is only named is not") {
        record.units[1].origin = model::UnitOrigin::Mentioned;
        CHECK(is_silent());
    }
    SECTION("nor without scans") {
        record.scans.clear();
        CHECK(is_silent());
    }
    SECTION("nor where nothing is outlined") {
        record.regions.clear();
        CHECK(is_silent());
    }
    SECTION("nor one that was drawn in a section") {
        model::Region region = record.regions[0];
        region.id = model::RegionId{SeededUuids(9).next()};
        region.surface = {};
        region.section = model::SectionId{SeededUuids(10).next()};
        region.unit = record.units[1].id;
        record.regions.push_back(region);
        CHECK(is_silent());
    }
    SECTION("nor one of an area without outlines") {
        SeededUuids ids(11);
        for (const char* name : {"A", "B"}) record.areas.push_back({model::AreaId{ids.next()}, name, "", {}, "", ""});
        record.surfaces[0].area = record.units[0].area = record.areas[0].id;
        record.units[1].area = record.areas[1].id;
        CHECK(is_silent());
    }
}

TEST_CASE("Many units without outlines are one line that names some") {
    model::Record record = record_with_outline();
    for (int i = 0; i < 30; ++i) {
        model::StratigraphicUnit unit = record.units[1];
        unit.id = model::UnitId{SeededUuids(static_cast<std::uint64_t>(100 + i)).next()};
        unit.number = std::to_string(100 + i);
        record.units.push_back(unit);
    }
    const auto found = said(record, "unit-without-region");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Catch::Contains("31 units"));
}

TEST_CASE("A surface that stands before one of an earlier day is said, and which") {
    model::Record record = record_with_outline();
    model::Surface next = record.surfaces[0];
    next.id = model::SurfaceId{SeededUuids(11).next()};
    next.first_day = "2025-06-02";
    next.order = 1;
    record.surfaces.push_back(next);
    CHECK(said(record, "surface-order").empty());
    record.surfaces[1].order = -1;
    const auto found = said(record, "surface-order");
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == model::Severity::Warning);
    CHECK(found[0].message == "surface 2025-06-02 of 2025-06-02 stands before 2025-06-01 of 2025-06-01 in the order of "
                              "surfaces, though its day is later: nothing is concluded from either until they are put "
                              "in their order (planum surface set --order)");
    record.surfaces[1].area = model::AreaId{SeededUuids(12).next()};
    CHECK(said(record, "surface-order").empty());
}

TEST_CASE("An outline in other coordinates than the site is said with its place and distance") {
    model::Record record = record_with_outline();
    CHECK(said(record, "region-astray").empty());
    for (auto& corner : record.regions[0].outline[0].outer) {
        corner[0] += 3500000.0;
        corner[1] += 5500000.0;
    }
    const auto found = said(record, "region-astray");
    REQUIRE(found.size() == 1);
    CHECK(found[0].units == std::vector{record.units[0].id});
    CHECK(found[0].message == "the outline of 1 on 2025-06-01 near 3500000.00 5500000.00 reaches 6519 km away from all "
                              "set-ups of the scanner: plans leave it out and nothing is concluded from it; is it in "
                              "other coordinates than the site?");
}

TEST_CASE("Outlines that claim the same ground are said with names, area and place") {
    const model::Record record = record_with_outline();
    const auto matrix = strat::HarrisMatrix::build(record);
    const model::OutlineOverlap overlap{"2025-06-01", "2025-06-01/1", "2025-06-01/1#2", {record.units[0].id}, 1.266,
                                        104.5,        201.7};
    auto all = strat::check(record, matrix, {}, {}, Progress::none(), {}, {&overlap, 1}).diagnostics;
    std::erase_if(all, [](const model::Diagnostic& d) { return d.code != "region-overlap"; });
    REQUIRE(all.size() == 1);
    CHECK(all[0].severity == model::Severity::Warning);
    CHECK(all[0].units == overlap.units);
    CHECK(all[0].message == "2025-06-01/1 and 2025-06-01/1#2 both claim 1.27 m² near 104.50 201.70: neither gets that "
                            "ground, and nothing is concluded from it until one of the outlines is redrawn");
}
