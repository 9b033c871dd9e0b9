// SPDX-License-Identifier: MIT
// GeoJSON, DXF, Turtle, OxCal and the spreadsheet: read back by programs of other people where they are installed.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "strat/exchange/writer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/record_builder.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::strat;
using Catch::Matchers::Contains;

namespace {

/// A pit 2 cut into layer 3 and filled by 1, a region with a hole given the wrong way round, a find, a level.
model::Record a_small_dig(std::int64_t srs) {
    auto builder = test::a_record();
    builder.unit("1", model::UnitKind::Deposit, model::UnitForm::Fill)
        .unit("2", model::UnitKind::Cut, model::UnitForm::None);
    builder.fills("1", "2").cuts("2", "3");
    model::Record record = builder.record();
    record.settings.srs_id = srs;
    SeededUuids ids(9);
    model::Surface surface;
    surface.id = model::SurfaceId{ids.next()};
    surface.name = "Planum 1";
    surface.first_day = "2025-06-01";
    record.surfaces.push_back(surface);
    model::Region region;
    region.id = model::RegionId{ids.next()};
    region.surface = surface.id;
    region.unit = record.units[0].id;
    const double e = 500000.0;
    const double n = 5400000.0;
    region.outline = {{{{e, n, 1}, {e, n + 4, 1}, {e + 4, n + 4, 1}, {e + 4, n, 1}},
                       {{{e + 1, n + 1, 1}, {e + 1, n + 2, 1}, {e + 2, n + 2, 1}}}}};
    record.regions.push_back(region);
    model::Find find;
    find.id = model::FindId{ids.next()};
    find.number = "F1";
    find.unit = record.units[0].id;
    find.x = e + 1, find.y = n + 1;
    find.description = "Scherbe mit \"Ähre\"\n=1+1";
    record.finds.push_back(find);
    find.id = model::FindId{ids.next()};
    find.number = "F2";
    find.x.reset();
    record.finds.push_back(find);
    return record;
}

std::string written(std::string_view format, const model::Record& record) {
    return writer_for(format).write(record, {}).files.at(0).bytes;
}

std::string output_of(const std::string& command) {
    std::string out;
    std::array<char, 4096> buffer{};
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) out += buffer.data();
    pclose(pipe);
    return out;
}

bool is_installed(const std::string& program) {
    if (std::system(("command -v " + program + " >/dev/null").c_str()) == 0) return true;
    WARN("SKIPPED: no " + program);
    return false;
}

} // namespace

TEST_CASE("GeoJSON on a known grid holds longitude and latitude, rings as RFC 7946 wants them") {
    const Written out = writer_for("geojson").write(a_small_dig(25832), {});
    const std::string& bytes = out.files.at(0).bytes;
    // 500000 m east is the middle of the zone: 9° exactly.
    CHECK_THAT(bytes, Contains("9.0,"));
    CHECK_THAT(bytes, !Contains("\"crs\""));
    CHECK(std::find(out.lost.begin(), out.lost.end(), "finds without a measured place: 1") != out.lost.end());
    if (!is_installed("ogrinfo")) return;
    const test::TemporaryFolder folder;
    const auto file = folder.write("dig.geojson", bytes);
    const std::string said = output_of("ogrinfo -ro -al '" + file.string() + "'");
    CHECK_THAT(said, Contains("Feature Count: 2"));
    CHECK_THAT(said, Contains("shows (String) = top") && Contains("surface (String) = Planum 1"));
    CHECK_THAT(said, !Contains("ERROR") && !Contains("Warning"));
}

TEST_CASE("GeoJSON on a local grid says that its coordinates are no degrees") {
    const Written out = writer_for("geojson").write(a_small_dig(-1), {});
    CHECK_THAT(out.files.at(0).bytes, Contains("\"crs\": null") && Contains("500000.0"));
    REQUIRE_FALSE(out.lost.empty());
    CHECK_THAT(out.lost.front(), Contains("local grid"));
    CHECK_THAT(written("geojson-site", a_small_dig(25832)), Contains("EPSG::25832") && Contains("500000.0"));
}

TEST_CASE("Outer rings of GeoJSON run against the clock, holes with it") {
    const std::string bytes = written("geojson-site", a_small_dig(-1));
    std::string packed;
    for (const char c : bytes) {
        if (c != ' ' && c != '\n') packed += c;
    }
    CHECK_THAT(packed, Contains("[[[500000.0,5400000.0,1.0],[500004.0,5400000.0,1.0],[500004.0,5400004.0,1.0],"
                                "[500000.0,5400004.0,1.0],[500000.0,5400000.0,1.0]],"
                                "[[500001.0,5400001.0,1.0],[500001.0,5400002.0,1.0],[500002.0,5400002.0,1.0],"
                                "[500001.0,5400001.0,1.0]]]"));
}

TEST_CASE("DXF is R12, a layer a kind, letters beyond ASCII in its own way") {
    model::Record record = a_small_dig(-1);
    record.finds[0].number = "Ä1";
    const std::string bytes = written("dxf", record);
    CHECK_THAT(bytes, Contains("$ACADVER\n  1\nAC1009\n") && Contains("\\U+00C41"));
    for (const char c : bytes) REQUIRE((static_cast<unsigned char>(c) < 0x80));
    if (!is_installed("ogrinfo")) return;
    const test::TemporaryFolder folder;
    const auto file = folder.write("dig.dxf", bytes);
    const std::string said = output_of("ogrinfo -ro -al '" + file.string() + "'");
    CHECK_THAT(said, Contains("Layer (String) = REGION_FILL") && Contains("Layer (String) = FIND"));
    CHECK_THAT(said,
               Contains("(500000 5400000 1,500000 5400004 1,500004 5400004 1,500004 5400000 1,500000 5400000 1)"));
    CHECK_THAT(said, !Contains("ERROR") && !Contains("Warning"));
}

TEST_CASE("Turtle says what lies where, what was earlier, and what follows") {
    const model::Record record = a_small_dig(-1);
    const std::string bytes = written("turtle", record);
    const auto name = [&](std::size_t unit) { return "<urn:uuid:" + record.units[unit].id.to_string(); };
    CHECK_THAT(bytes, Contains(name(0) + "> planum:fills " + name(1) + "> ;"));
    CHECK_THAT(bytes, Contains(name(1) + "#genesis> crmarchaeo:AP28_occurs_before " + name(0) + "#genesis> ."));
    CHECK_THAT(bytes, Contains(name(0) + "> planum:later_than " + name(1) + ">,\n    " + name(2) + "> ."));
    CHECK_THAT(bytes, Contains(name(0) + "> crmarchaeo:AP21_contains"));
    CHECK_THAT(bytes, Contains("Scherbe mit \\\"Ähre\\\"\\n=1+1"));
    if (!is_installed("rapper")) return;
    const test::TemporaryFolder folder;
    const auto file = folder.write("dig.ttl", bytes);
    CHECK(std::system(("rapper -q -c -i turtle '" + file.string() + "'").c_str()) == 0);
}

TEST_CASE("Years before our era keep their place in RDF, whose year 0 is 1 BCE") {
    model::Record record = a_small_dig(-1);
    model::Period period;
    period.id = model::PeriodId{Uuid{5, 5}};
    period.number = "I";
    period.from = -100, period.to = 20;
    record.periods.push_back(period);
    CHECK_THAT(written("turtle", record), Contains("\"-0099\"^^xsd:gYear") && Contains("\"0020\"^^xsd:gYear"));
}

TEST_CASE("An OxCal model has each date once, phases in sequence and no order that these imply") {
    auto builder = test::a_record();
    builder.covers("1", "2").covers("2", "3").covers("3", "4");
    model::Record record = builder.record();
    SeededUuids ids(4);
    std::int64_t rank = 0;
    for (const char* number : {"early", "late"}) {
        model::Phase phase;
        phase.id = model::PhaseId{ids.next()};
        phase.number = number;
        phase.rank = ++rank;
        record.phases.push_back(phase);
    }
    const auto date = [&](std::size_t unit, std::size_t phase, const char* label, double bp) {
        record.units[unit].phase = record.phases[phase].id;
        model::Dating dating;
        dating.id = model::DatingId{ids.next()};
        dating.unit = record.units[unit].id;
        dating.kind = model::DatingKind::Radiocarbon;
        dating.label = label;
        dating.bp = bp, dating.bp_error = 30;
        record.datings.push_back(dating);
    };
    date(0, 1, "A-1", 2000);
    date(2, 0, "A-3", 2100);
    date(3, 0, "A-4", 2200);
    record.datings[2].association = "disjunct";
    CHECK(written("oxcal", record) == R"(// : 3 dates of 3 units
Plot()
{
 Sequence()
 {
  Boundary("start of phase early");
  Phase("phase early")
  {
   R_Date("A-3",2100,30);
   After("A-4 after",R_Date("A-4",2200,30));
  };
  Boundary("end of phase early");
  Boundary("start of phase late");
  Phase("phase late")
  {
   R_Date("A-1",2000,30);
  };
  Boundary("end of phase late");
 };
 Sequence()
 {
  Phase()
  {
   Date("=A-4");
  };
  Phase()
  {
   Date("=A-3");
  };
 };
};
)");
}

TEST_CASE("A spreadsheet has a sheet a kind, and text that looks like a formula stays text") {
    const std::string bytes = written("xlsx", a_small_dig(-1));
    CHECK(bytes.starts_with("PK"));
    if (!is_installed("python3")) return;
    const test::TemporaryFolder folder;
    const auto file = folder.write("dig.xlsx", bytes);
    const std::string said =
        output_of(fmt::format("python3 -c 'import zipfile,sys,re; z=zipfile.ZipFile(sys.argv[1]); "
                              "print(re.findall(\"sheet name=.(.*?)\\\"\", z.read(\"xl/workbook.xml\").decode())); "
                              "print(sum(z.read(n).count(b\"<f>\") for n in z.namelist())); print(z.testzip()); "
                              "print(\"=1+1\" in \"\".join(z.read(n).decode() for n in z.namelist()))' '{}'",
                              file.string()));
    CHECK(said == "['Units', 'Relations', 'Statements', 'Finds', 'Regions']\n0\nNone\nTrue\n");
}
