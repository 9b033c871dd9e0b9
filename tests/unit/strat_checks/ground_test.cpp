// SPDX-License-Identifier: MIT
#include <algorithm>
#include <variant>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/small_record.hpp"

using namespace planum;
using model::GroundAlteration;
using test::SmallRecord;

namespace {

GroundAlteration altered(GroundAlteration::Kind kind, std::vector<model::UnitId> units) {
    GroundAlteration a;
    a.kind = kind;
    a.surface = "2025-06-02";
    a.since = "2025-06-01";
    a.units = std::move(units);
    a.area = 0.62;
    a.change = 0.14;
    a.detectable = 0.04;
    a.x = 3.25;
    a.y = 1.5;
    a.low = 10.12;
    a.high = 10.2;
    a.higher_scan = "2025-06-02/b";
    a.lower_scan = "2025-06-02/a";
    return a;
}

std::vector<model::Diagnostic> said(SmallRecord& r, const std::vector<GroundAlteration>& alterations,
                                    std::string_view code, const strat::CheckOptions& options = {}) {
    model::sort_record(r.record());
    const auto matrix = strat::HarrisMatrix::build(r.record());
    auto all = strat::check(r.record(), matrix, options, {}, Progress::none(), alterations).diagnostics;
    std::erase_if(all, [&](const model::Diagnostic& d) { return d.code != code; });
    return all;
}

} // namespace

TEST_CASE("Ground that rose is said with unit, place, area and heights") {
    SmallRecord r;
    r.covers("1", "2");
    const auto rose = altered(GroundAlteration::Kind::Rose, {r.unit("2").id});
    const auto found = said(r, {rose}, "surface-rose");
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == model::Severity::Info);
    CHECK(found[0].units == rose.units);
    CHECK(found[0].message == "on 2025-06-02 0.62 m² of 2 near 3.25 1.50 at 10.12 to 10.20 m lay 0.14 m higher than on "
                              "2025-06-01: heaped up, filled in, or a scan is misplaced; nothing is concluded there "
                              "until it is below its former height");
    CHECK(std::get<double>(found[0].evidence.at("area_m2")) == Approx(0.62));
    CHECK(std::get<double>(found[0].evidence.at("z_max")) == Approx(10.2));
    CHECK(said(r, {}, "surface-rose").empty());
    strat::CheckOptions quiet;
    quiet.with_infos = false;
    CHECK(said(r, {rose}, "surface-rose", quiet).empty());
}

TEST_CASE("Scans of one surface that disagree are named, the higher one as such") {
    SmallRecord r;
    r.covers("1", "2");
    const auto within = altered(GroundAlteration::Kind::ChangedWithin, {r.unit("2").id, r.unit("1").id});
    const auto found = said(r, {within}, "surface-changed-within");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Catch::StartsWith("on 2025-06-02 scans disagree over 0.62 m² of 2 and 1 near") &&
                                     Catch::Contains("2025-06-02/b shows it 0.14 m higher than 2025-06-02/a"));
    CHECK(found[0].evidence.count("since") == 0);
}

TEST_CASE("Ground without a unit, or of one no longer in the record, is said as such") {
    SmallRecord r;
    r.covers("1", "2");
    const auto nobody = altered(GroundAlteration::Kind::Rose, {});
    const auto stranger = altered(GroundAlteration::Kind::Rose, {model::UnitId{SeededUuids(99).next()}});
    for (const auto& one : {nobody, stranger}) {
        const auto found = said(r, {one}, "surface-rose");
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].message, Catch::Contains("ground without a unit"));
        CHECK(found[0].units.empty());
    }
}

TEST_CASE("What rose on two days is two problems, and more than twenty are one line") {
    SmallRecord r;
    r.covers("1", "2");
    auto later = altered(GroundAlteration::Kind::Rose, {r.unit("2").id});
    std::vector<GroundAlteration> all{later};
    later.surface = "2025-06-03";
    all.push_back(later);
    const auto two = said(r, all, "surface-rose");
    REQUIRE(two.size() == 2);
    CHECK(two[0].id != two[1].id);
    all.resize(30, later);
    const auto many = said(r, all, "surface-rose");
    REQUIRE(many.size() == 1);
    CHECK_THAT(many[0].message, Catch::StartsWith("30 patches of ground rose"));
}
