// SPDX-License-Identifier: MIT
#include "app/regions/region_import.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "app/records/record_kind.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_list.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

constexpr const char* kDay = "2025-06-01";
constexpr const char* kLarge = "0 0 5, 4 0 5, 4 3 5, 0 3 5";

// Two trenches, A and B, that each count for themselves.
struct TwoAreas {
    test::TemporaryFolder folder;
    SeededUuids ids{7};
    app::Project project;
    model::AreaId a;
    model::AreaId b;

    explicit TwoAreas(model::NumberScope numbers = model::NumberScope::Area)
        : project([&] {
              model::ProjectSettings settings;
              settings.numbers = numbers;
              return app::Project::create(folder / "site.gpkg", settings, {"tester", nullptr, &ids});
          }()) {
        a = area("A");
        b = area("B");
    }

    model::AreaId area(const std::string& name) {
        model::Area area;
        area.name = name;
        project.change("area", [&] { area.id = project.file().insert(area); });
        return area.id;
    }

    model::UnitId unit(const std::string& number, model::AreaId area) {
        model::StratigraphicUnit unit;
        unit.number = number;
        unit.kind = model::UnitKind::Deposit;
        unit.area = area;
        project.change("unit", [&] { unit.id = project.file().insert(unit); });
        return unit.id;
    }

    model::SurfaceId surface(model::AreaId area, const std::string& name = {}) {
        model::Surface surface;
        surface.area = area;
        surface.name = name;
        surface.first_day = surface.last_day = kDay;
        project.change("surface", [&] { surface.id = project.file().insert(surface); });
        return surface.id;
    }

    app::RegionImportReport import(std::vector<app::DrawnOutline> outlines, app::RegionImportOptions options = {}) {
        return app::import_outlines(project, {std::move(outlines), {}}, options);
    }

    [[nodiscard]] const std::vector<model::Region>& regions() { return project.record().regions; }
};

app::DrawnOutline drawn(const std::string& unit, const std::string& area, const std::string& corners = kLarge) {
    app::DrawnOutline outline;
    outline.where = "outline of " + unit;
    outline.unit = unit;
    outline.area = area;
    outline.day = kDay;
    outline.shape = app::parse_outline(corners);
    return outline;
}

app::RegionImportOptions updating() {
    app::RegionImportOptions options;
    options.update = true;
    return options;
}

std::string refusal(TwoAreas& site, const app::DrawnOutline& outline) {
    try {
        (void)site.import({outline});
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

} // namespace

TEST_CASE("A unit of one area is not that of the same number in another: its region is left alone, even by update") {
    TwoAreas site;
    const model::UnitId of_a = site.unit("5", site.a);
    const model::UnitId of_b = site.unit("5", site.b);
    site.surface({}); // of scans that came before the site had areas
    CHECK(site.import({drawn("5", "A")}).fresh.size() == 1);
    for (const auto& options : {app::RegionImportOptions{}, updating()}) {
        (void)site.import({drawn("5", "B", "0 0 5, 4 0 5, 4 3 5, 0 3 5.2")}, options);
        REQUIRE(site.regions().size() == 2);
        CHECK(site.regions()[0].unit == of_a);
        CHECK(site.regions()[1].unit == of_b);
    }
}

TEST_CASE("An unknown number keeps its area, and a unit of another area does not name it") {
    TwoAreas site;
    site.surface({});
    CHECK(site.import({drawn("5", "A")}).unknown.size() == 1);
    CHECK(site.regions()[0].unit_as_drawn == "A::5");
    site.unit("5", site.b);
    CHECK(site.import({drawn("5", "B")}).fresh.size() == 1);
    const auto count = [&](const auto& wanted) {
        return std::count_if(site.regions().begin(), site.regions().end(), wanted);
    };
    CHECK(count([](const model::Region& region) { return region.unit.is_nil(); }) == 1);
    const model::UnitId of_a = site.unit("5", site.a);
    CHECK(site.import({drawn("5", "A")}).named.size() == 1);
    CHECK(site.regions().size() == 2);
    CHECK(count([&](const model::Region& region) { return region.unit == of_a && region.unit_as_drawn.empty(); }) == 1);
}

TEST_CASE("A number without an area is that of its surface's area; where nothing says the area, it is refused") {
    TwoAreas site;
    site.unit("5", site.a);
    const model::UnitId of_b = site.unit("5", site.b);
    const model::UnitId only = site.unit("6", site.b);
    auto on_b = drawn("5", "");
    on_b.on_surface = site.surface(site.b);
    (void)site.import({on_b});
    CHECK(site.regions()[0].unit == of_b);
    CHECK_THAT(refusal(site, drawn("5", "")), Catch::Contains("A::5 or B::5"));
    CHECK(site.project.record().surfaces.size() == 1);
    (void)site.import({drawn("6", "")});
    CHECK(site.regions()[1].unit == only);
    auto qualified = drawn("A::5", "");
    (void)site.import({qualified});
    CHECK(site.regions()[2].unit != of_b);
}

TEST_CASE("A region named by hand is found again by the number it was drawn with") {
    TwoAreas site(model::NumberScope::Site);
    const model::UnitId three = site.unit("3", site.a);
    const model::UnitId five = site.unit("5", site.a);
    const std::vector<app::DrawnOutline> file = {drawn("33", "A"), drawn("5", "A", "10 0 5, 14 0 5, 14 3 5, 10 3 5")};
    (void)site.import(file);
    const app::RecordKind& regions = app::record_kind("region");
    regions.set(site.project, "2025-06-01/33", {{"unit", "3"}}); // a number nobody issued
    regions.set(site.project, "2025-06-01/5", {{"unit", "3"}});  // a wrong label
    app::RegionImportOptions create;
    create.create_units = true;
    const auto again = site.import(file, create);
    CHECK(again.fresh.empty());
    CHECK(again.units.empty());
    CHECK(again.unknown.empty());
    CHECK(again.same == 2);
    REQUIRE(again.conflicts.size() == 1);
    CHECK_THAT(again.conflicts[0].message, Catch::Contains("unit: 3 (file: 5)"));
    REQUIRE(site.regions().size() == 2);
    for (const model::Region& region : site.regions()) CHECK(region.unit == three);
    CHECK(site.regions()[0].part != site.regions()[1].part);
    CHECK(site.import(file, updating()).redrawn.size() == 1);
    CHECK(std::any_of(site.regions().begin(), site.regions().end(),
                      [&](const model::Region& region) { return region.unit == five; }));
}

TEST_CASE("An outline of a section that is drawn anew is the same region, and overlaps there are reported") {
    TwoAreas site(model::NumberScope::Site);
    site.unit("1", site.a);
    site.unit("2", site.a);
    const auto on_section = [](const std::string& unit, const std::string& corners) {
        auto outline = drawn(unit, "A", corners);
        outline.on_plane = true;
        outline.section =
            app::SectionWish{"S1", std::array<std::array<double, 2>, 2>{{{100.0, 200.0}, {100.0, 204.0}}}};
        return outline;
    };
    (void)site.import({on_section("1", "0 1, 2 1, 2 3, 0 3")});
    const auto anew = site.import({on_section("1", "0 1, 2.5 1, 2.5 3, 0 3")});
    CHECK(anew.fresh.empty());
    CHECK(anew.conflicts.size() == 1);
    CHECK(site.import({on_section("1", "3 1, 4 1, 4 3, 3 3")}).fresh.size() == 1);
    const auto over = site.import({on_section("2", "1 1, 2.7 1, 2.7 3, 1 3")});
    REQUIRE(over.overlaps.size() == 1);
    CHECK(over.overlaps[0].surface == "S1");
    CHECK(over.overlaps[0].area == Approx(2.0));
}

TEST_CASE("A surface is known by its name, with its area before it where that is said") {
    TwoAreas site;
    const model::SurfaceId of_a = site.surface(site.a, "Planum 3");
    const model::SurfaceId of_b = site.surface(site.b, "Planum 3");
    auto outline = drawn("", "");
    outline.category = model::RegionCategory::Spoil;
    outline.day.clear();
    outline.surface = "B::Planum 3";
    app::RegionImportOptions elsewhere;
    elsewhere.area = "A"; // for those that name none
    (void)site.import({outline}, elsewhere);
    CHECK(site.regions()[0].surface == of_b);
    outline.surface = "Planum 3";
    CHECK_THAT(refusal(site, outline), Catch::Contains("several areas"));
    outline.area = "A";
    (void)site.import({outline});
    REQUIRE(site.regions().size() == 2);
    for (const model::SurfaceId surface : {of_a, of_b}) {
        CHECK(std::count_if(site.regions().begin(), site.regions().end(),
                            [&](const model::Region& region) { return region.surface == surface; }) == 1);
    }
    outline.surface = "B::Planum 3";
    CHECK_THAT(refusal(site, outline), Catch::Contains("not of area A"));
    outline.area.clear();
    outline.surface = "B::2025-06-07";
    const auto report = site.import({outline});
    CHECK(report.surfaces.size() == 1);
    CHECK(site.project.record().surfaces.back().area == site.b);
    CHECK(site.project.record().surfaces.back().first_day == "2025-06-07");
}

TEST_CASE("A refused outline leaves no area behind") {
    TwoAreas site;
    auto no_day = drawn("1", "North");
    no_day.day.clear();
    const auto report = site.import({drawn("1", "A"), no_day});
    CHECK(report.refused.size() == 1);
    CHECK(report.areas.empty());
    CHECK(site.project.record().areas.size() == 2);
}

TEST_CASE("A day that is none is refused before anything is looked at") {
    TwoAreas site;
    app::RegionImportOptions options;
    options.day = "2025-02-30";
    CHECK_THROWS_AS(site.import({drawn("1", "A")}, options), Error);
    CHECK_THROWS_AS(app::list_regions(site.project, "yesterday"), Error);
    CHECK(site.regions().empty());
}

TEST_CASE("What a region shows follows its category too, unless somebody says it") {
    TwoAreas site;
    site.unit("1", site.a);
    (void)site.import({drawn("1", "A")});
    const app::RecordKind& regions = app::record_kind("region");
    const auto shows = [&] { return site.regions()[0].shows; };
    regions.set(site.project, "2025-06-01/1", {{"category", "spoil"}});
    CHECK(shows() == model::RegionShows::Nothing);
    regions.set(site.project, "2025-06-01/1", {{"category", "unit"}});
    CHECK(shows() == model::RegionShows::Top);
    regions.set(site.project, "2025-06-01/1", {{"shows", "machine"}});
    regions.set(site.project, "2025-06-01/1", {{"category", "backfill"}, {"shows", "face"}});
    CHECK(shows() == model::RegionShows::Face);
}

TEST_CASE("What is mended of a typed outline is said") {
    TwoAreas site;
    site.unit("1", site.a);
    site.surface(site.a);
    const app::RecordKind& regions = app::record_kind("region");
    const app::FieldValues typed = {{"outline", "0 0 5, 4 0 5, 4 0 5, 4 3 5, 0 3 5"}};
    const std::string name = regions.add(site.project, "2025-06-01/1", typed);
    CHECK(regions.remarks(site.project, name, typed).size() == 1);
    CHECK(regions.remarks(site.project, name, {{"outline", kLarge}}).empty());
}
