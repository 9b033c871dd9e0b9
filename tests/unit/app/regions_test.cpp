// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "app/regions/geojson_outlines.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_list.hpp"
#include "app/regions/region_names.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

struct Site {
    test::TemporaryFolder folder;
    SeededUuids ids{7};
    app::Project project;

    explicit Site(model::DigMethod method = model::DigMethod::Stratigraphic)
        : project([&] {
              model::ProjectSettings settings;
              settings.method = method;
              return app::Project::create(folder / "site.gpkg", settings, {"tester", nullptr, &ids});
          }()) {}

    void unit(const std::string& number, model::UnitKind kind = model::UnitKind::Deposit) {
        model::StratigraphicUnit unit;
        unit.number = number;
        unit.kind = kind;
        project.change("unit", [&] { project.file().insert(unit); });
    }
};

app::DrawnOutline drawn(const std::string& unit, const std::string& day, const std::string& corners) {
    app::DrawnOutline outline;
    outline.where = "outline of " + unit;
    outline.unit = unit;
    outline.day = day;
    outline.shape = app::parse_outline(corners);
    return outline;
}

app::RegionImportReport import(Site& site, std::vector<app::DrawnOutline> outlines,
                               const app::RegionImportOptions& options = {}) {
    return app::import_outlines(site.project, {std::move(outlines), {}}, options);
}

constexpr const char* kDay = "2025-06-01";
constexpr const char* kLarge = "0 0 5, 4 0 5, 4 3 5, 0 3 5";
constexpr const char* kSmall = "1 1 5, 2 1 5, 2 2 5, 1 2 5";

std::string refusal(const std::string& geojson) {
    try {
        (void)app::read_geojson_outlines(geojson);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

} // namespace

TEST_CASE("A region inside another cuts its own hole, whichever was drawn first") {
    for (const bool small_first : {false, true}) {
        Site site;
        site.unit("1");
        site.unit("2");
        std::vector<app::DrawnOutline> outlines = {drawn("1", kDay, kLarge), drawn("2", kDay, kSmall)};
        if (small_first) std::swap(outlines[0], outlines[1]);
        CHECK(import(site, outlines).overlaps.empty());
        const auto rows = app::list_regions(site.project, "").rows;
        REQUIRE(rows.size() == 2);
        CHECK(rows[0].area == Approx(11.0));
        CHECK(rows[0].drawn_area == Approx(12.0));
        CHECK(rows[1].area == Approx(1.0));
    }
}

TEST_CASE("Ground that two regions claim is reported and belongs to neither; a sliver along a line is no overlap") {
    Site site;
    site.unit("1");
    site.unit("2");
    site.unit("3");
    const auto report = import(site, {drawn("1", kDay, kLarge), drawn("2", kDay, "3 0 5, 6 0 5, 6 2 5, 3 2 5"),
                                      drawn("3", kDay, "3.97 2 5, 6 2 5, 6 3 5, 3.97 3 5")});
    REQUIRE(report.overlaps.size() == 1);
    CHECK(report.overlaps[0].area == Approx(2.0));
    const auto rows = app::list_regions(site.project, "").rows;
    CHECK(rows[0].area == Approx(12.0 - 2.0 - 0.03));
    CHECK(rows[1].area == Approx(4.0));
    const auto& record = site.project.record();
    const auto layout = app::layout_regions(app::regions_on(record, record.surfaces.front().id));
    for (double x = 0.05; x < 6.0; x += 0.1) {
        for (double y = 0.05; y < 3.0; y += 0.1) {
            int hits = 0;
            for (const auto& placed : layout.regions) hits += geometry::contains(placed.shown, x, y) ? 1 : 0;
            CHECK(hits <= 1);
        }
    }
}

TEST_CASE("The same outlines again change nothing; a redrawn one is kept unless it may replace") {
    Site site;
    site.unit("1");
    CHECK(import(site, {drawn("1", kDay, kLarge)}).fresh == std::vector<std::string>{"2025-06-01/1#1"});
    const std::string before = site.project.file().canonical_dump();
    CHECK(import(site, {drawn("1", kDay, kLarge)}).same == 1);
    CHECK(site.project.file().canonical_dump() == before);
    const auto kept = import(site, {drawn("1", kDay, "0 0 5, 5 0 5, 5 3 5, 0 3 5")});
    CHECK(kept.conflicts.size() == 1);
    CHECK(site.project.file().canonical_dump() == before);
    app::RegionImportOptions update;
    update.update = true;
    CHECK(import(site, {drawn("1", kDay, "0 0 5, 5 0 5, 5 3 5, 0 3 5")}, update).redrawn.size() == 1);
    CHECK(app::list_regions(site.project, "").rows[0].area == Approx(15.0));
}

TEST_CASE("An unknown number waits as a region without unit and is named when its unit comes") {
    Site site;
    site.unit("1017");
    const auto report = import(site, {drawn("1071", kDay, kLarge)});
    REQUIRE(report.unknown.size() == 1);
    CHECK(report.unknown[0].near == std::vector<std::string>{"1017"});
    CHECK(site.project.record().regions[0].unit.is_nil());
    site.unit("1071", model::UnitKind::Cut);
    const auto again = import(site, {drawn("1071", kDay, kLarge)});
    CHECK(again.named.size() == 1);
    CHECK_FALSE(site.project.record().regions[0].unit.is_nil());
    CHECK(site.project.record().regions[0].shows == model::RegionShows::Cut);
}

TEST_CASE("Units are made with the kind that the category says, on demand only") {
    Site site;
    app::RegionImportOptions create;
    create.create_units = true;
    auto fill = drawn("8", kDay, kLarge);
    fill.kind = {model::UnitKind::Deposit, model::UnitForm::Fill};
    auto cut = drawn("9", "2025-06-02", kLarge);
    cut.shows = model::RegionShows::Cut;
    CHECK(import(site, {fill, cut}, create).units == std::vector<std::string>{"8", "9"});
    const auto& units = site.project.record().units;
    CHECK(units[0].form == model::UnitForm::Fill);
    CHECK(units[1].kind == model::UnitKind::Cut);
    site.project.undo();
    CHECK(site.project.record().units.empty());
    CHECK(site.project.record().surfaces.empty());
}

TEST_CASE("What a region shows follows method and kind") {
    using model::DigMethod;
    using model::RegionCategory;
    using model::RegionShows;
    using model::UnitKind;
    const auto shows = [](UnitKind kind, DigMethod method) {
        return app::default_shows(RegionCategory::Unit, kind, method, false);
    };
    CHECK(shows(UnitKind::Deposit, DigMethod::Stratigraphic) == RegionShows::Top);
    CHECK(shows(UnitKind::Deposit, DigMethod::Planum) == RegionShows::Level);
    CHECK(shows(UnitKind::Structure, DigMethod::Planum) == RegionShows::Top);
    CHECK(shows(UnitKind::Cut, DigMethod::Planum) == RegionShows::Cut);
    CHECK(app::default_shows(RegionCategory::Baulk, UnitKind::Unknown, DigMethod::Planum, false) ==
          RegionShows::Nothing);
    CHECK(app::default_shows(RegionCategory::Unit, UnitKind::Cut, DigMethod::Planum, true) == RegionShows::Face);
}

TEST_CASE("Two areas on one day have a surface each, and days come in any order") {
    Site site;
    auto west = drawn("1", "2025-06-02", kLarge);
    west.area = "West";
    auto east = drawn("2", "2025-06-02", kLarge);
    east.area = "East";
    auto before = drawn("1", "2025-06-01", kLarge);
    before.area = "West";
    const auto report = import(site, {west, east, before});
    CHECK(report.overlaps.empty());
    CHECK(report.fresh == std::vector<std::string>{"2025-06-01/1#1", "East::2025-06-02/2#1", "West::2025-06-02/1#1"});
    std::vector<std::string> west_days;
    for (const model::Surface& surface : site.project.record().surfaces) { // by their order in time
        if (surface.area == site.project.record().areas[1].id) west_days.push_back(surface.first_day);
    }
    CHECK(west_days == std::vector<std::string>{"2025-06-01", "2025-06-02"});
}

TEST_CASE("An outline on a section keeps its area in the plane and comes back where it was") {
    Site site;
    site.unit("1");
    auto outline = drawn("1", kDay, "0 1, 2 1, 2 3, 0 3");
    outline.on_plane = true;
    outline.section = app::SectionWish{"S1", std::array<std::array<double, 2>, 2>{{{100.0, 200.0}, {103.0, 204.0}}}};
    CHECK(import(site, {outline}).sections == std::vector<std::string>{"S1"});
    const auto rows = app::list_regions(site.project, "").rows;
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].region == "S1/1#1");
    CHECK(rows[0].shows == "face");
    CHECK(rows[0].area == Approx(4.0));
    bool corner = false;
    for (const auto& p : site.project.record().regions[0].outline[0].outer) {
        corner = corner || (p[0] == Approx(101.2) && p[1] == Approx(201.6) && p[2] == Approx(3.0));
    }
    CHECK(corner);
    CHECK(import(site, {outline}).same == 1);
}

TEST_CASE("A refused outline leaves nothing behind, not even its day") {
    Site site;
    site.unit("1");
    const auto report = import(site, {drawn("1", kDay, kLarge), drawn("1", "2025-06-09", "0 0, 4 4, 4 0, 0 4")});
    CHECK(report.refused.size() == 1);
    CHECK(site.project.record().surfaces.size() == 1);
    CHECK_THROWS_AS(import(site, {drawn("1", "2025-06-09", "0 0, 4 4, 4 0, 0 4")}), Error);
}

TEST_CASE("GeoJSON in degrees, without features or of something else is refused in a sentence") {
    CHECK(refusal("[]").find("no GeoJSON") != std::string::npos);
    CHECK(refusal(R"({"type":"FeatureCollection"})").find("no list of features") != std::string::npos);
    const std::string degrees =
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},"features":[]})";
    CHECK(refusal(degrees).find("degrees") != std::string::npos);
    const auto read = app::read_geojson_outlines(
        R"({"type":"Feature","properties":{"Unit":12.0,"category":"Verfüllung","shows":"TOP"},"geometry":
           {"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}})");
    REQUIRE(read.outlines.size() == 1);
    CHECK(read.outlines[0].unit == "12");
    CHECK(read.outlines[0].kind.form == model::UnitForm::Fill);
    CHECK(read.outlines[0].shows == model::RegionShows::Top);
}

TEST_CASE("An outline drawn without heights has none, is stored so and says none; one at 0 on a site at 0 has") {
    Site site;
    site.unit("1");
    site.unit("2");
    import(site, {drawn("1", kDay, "0 0, 4 0, 4 3, 0 3")});
    CHECK_FALSE(site.project.record().regions.front().has_heights);
    CHECK_FALSE(app::list_regions(site.project, "").rows[0].z_median);
    const std::string text = app::outline_text(app::shape_with_heights(site.project.record().regions.front()));
    CHECK(text.find('Z') == std::string::npos);
    import(site, {drawn("2", kDay, "6 0 0, 9 0 0, 9 3 0.02")});
    const auto rows = app::list_regions(site.project, "").rows;
    CHECK_FALSE(rows[0].z_median);
    CHECK(rows[1].z_min == Approx(0.0));
}

TEST_CASE("The same outline with heights takes the place of one without only where it may; without, it is the same") {
    Site site;
    site.unit("1");
    import(site, {drawn("1", kDay, kLarge)});
    CHECK(import(site, {drawn("1", kDay, "0 0, 4 0, 4 3, 0 3")}).same == 1);
    CHECK(site.project.record().regions.front().has_heights);
    Site flat;
    flat.unit("1");
    import(flat, {drawn("1", kDay, "0 0, 4 0, 4 3, 0 3")});
    CHECK(import(flat, {drawn("1", kDay, kLarge)}).conflicts.size() == 1);
    app::RegionImportOptions update;
    update.update = true;
    CHECK(import(flat, {drawn("1", kDay, kLarge)}, update).redrawn.size() == 1);
    CHECK(flat.project.record().regions.front().has_heights);
}

TEST_CASE("A corner without height takes that of the line between its neighbours") {
    geometry::MultiPolygon shape = app::parse_outline("0 0 5, 2 0, 4 0 6, 4 3 6");
    CHECK(app::settle_heights(shape));
    CHECK(shape[0][0][1][2] == Approx(5.5));
}

TEST_CASE("A typed outline and its text are the same shape") {
    const auto shape =
        app::parse_outline("MULTIPOLYGON Z (((0 0 1, 4 0 1, 4 3 1, 0 0 1), (1 0.2 1, 2 0.2 1, 2 0.4 1)), "
                           "((5 5 2, 6 5 2, 6 6 2)))");
    CHECK(shape.size() == 2);
    CHECK(shape[0].size() == 2);
    CHECK(app::parse_outline(app::outline_text(shape)) == shape);
    const auto triangle = app::parse_outline("0 0 5, 4 0 5, 4 3 5");
    for (const char* same : {"POLYGON Z((0 0 5, 4 0 5, 4 3 5))", "POLYGON Z ((0 0 5,4 0 5,4 3 5,0 0 5))",
                             "PolygonZ ((0 0 5, 4 0 5, 4 3 5))", "polygonz((0 0 5, 4 0 5, 4 3 5))",
                             " MultiPolygonZ (((0 0 5, 4 0 5, 4 3 5)))", "POLYGON ZM ((0 0 5 1, 4 0 5 2, 4 3 5 3))",
                             "POLYGONZM((0 0 5 1, 4 0 5 2, 4 3 5 3))"}) {
        INFO(same);
        CHECK(app::parse_outline(same) == triangle);
    }
    CHECK(app::outline_text(app::parse_outline("POLYGON M ((0 0 5, 4 0 5, 4 3 5))")) ==
          "POLYGON ((0.000 0.000, 4.000 0.000, 4.000 3.000, 0.000 0.000))");
    for (const char* bad : {"POLYGON Q ((1 2, 3 4, 5 0))", "POLYGON EMPTY", "POLYGONX ((1 2, 3 4, 5 0))", "", "1",
                            "1 2, a b", "POLYGON(1 2, 3 4)", "POLYGON((1 2, 3 4)", "CIRCLE(1 2)", "1 2, 3 4) x"}) {
        CHECK_THROWS_AS(app::parse_outline(bad), Error);
    }
}

TEST_CASE("Outlines in another encoding are refused with the line and what to do") {
    CHECK(refusal("{\"type\": \"FeatureCollection\",\n\"name\": \"B\xFCro\", \"features\": []}") ==
          "line 2 is not UTF-8: save the file as UTF-8");
}

TEST_CASE("A property that is no single word is not dropped: the outline is refused with its name") {
    for (const char* value : {R"({"a": 1})", "[1, 2]"}) {
        const auto read = app::read_geojson_outlines(
            fmt::format(R"({{"type": "Feature", "properties": {{"unit": {}}}, "geometry": {{"type": "Polygon",
                           "coordinates": [[[0, 0], [1, 0], [1, 1]]]}}}})",
                        value));
        CHECK(read.outlines.empty());
        REQUIRE(read.notes.size() == 1);
        CHECK(read.notes[0].message.find("unit is") == 0);
    }
}

TEST_CASE("A file without outlines is taken as it is, and said to hold none") {
    const test::TemporaryFolder folder;
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    const auto report = app::import_outlines(
        project, app::read_geojson_outlines(R"({"type": "FeatureCollection", "features": []})"), {});
    CHECK_FALSE(report.changed);
    REQUIRE(report.notes.size() == 1);
    CHECK(report.notes[0].message == "it holds no outline");
}
