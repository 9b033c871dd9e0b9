// SPDX-License-Identifier: MIT
#include "app/regions/region_points.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "app/project/clean.hpp"
#include "app/records/record_kind.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/regions/region_list.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/region_ply.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/placed_scan.hpp"
#include "tests/support/read_scan.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

// A level field of points every 5 cm at height 2 in the scan, which stands turned by 90° at (100, 200, 8).
std::string a_field() {
    std::string text;
    for (int x = -40; x <= 40; ++x) {
        for (int y = -40; y <= 40; ++y) text += fmt::format("{} {} 2\n", 0.05 * x + 0.01, 0.05 * y + 0.01);
    }
    return text;
}

app::DrawnOutline drawn(const std::string& category, const std::string& corners) {
    app::DrawnOutline outline;
    outline.day = "2025-06-01";
    outline.category = *model::region_category_from_word(category);
    outline.shape = app::parse_outline(corners);
    return outline;
}

} // namespace

TEST_CASE("A region knows its points and heights, without those of the region inside it") {
    const test::TemporaryFolder folder;
    app::Project project = test::project_with_scan(folder, a_field());
    app::import_outlines(project,
                         {{drawn("spoil", "99 199 10, 101 199 10, 101 201 10, 99 201 10"),
                           drawn("water", "99.5 199.5 10, 100.5 199.5 10, 100.5 200.5 10, 99.5 200.5 10"),
                           drawn("baulk", "300 300 10, 301 300 10, 301 301 10")},
                          {}},
                         {});
    CHECK(app::list_regions(project, "").rows[1].points == 0); // not registered yet
    test::place_scans(project, test::turned_pose(8.0));
    for (int pass = 0; pass < 2; ++pass) { // counted, then from what was kept
        const auto rows = app::list_regions(project, "").rows;
        REQUIRE(rows.size() == 3);
        CHECK(rows[0].points == 0);
        CHECK(rows[0].outside_scans);
        CHECK(rows[1].region == "2025-06-01/spoil#1");
        CHECK(rows[1].points == 1600 - 400);
        CHECK(rows[2].points == 400);
        CHECK(*rows[2].z_min == Approx(10.0));
        CHECK(*rows[2].z_max == Approx(10.0));
    }
    const model::Region spoil = app::region_named(project, "2025-06-01/spoil");
    CHECK(app::write_region_points(project, spoil, folder / "spoil.ply", Progress::none()) == 1200);
    const auto reader = test::open_bytes(read_file(folder / "spoil.ply", 1U << 20U), scans::ScanFormat::Ply);
    const auto cloud = test::read_whole(*reader);
    REQUIRE(cloud.points.size() == 1200);
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        const double x = cloud.points.x[i] - 100.0;
        const double y = cloud.points.y[i] - 200.0;
        CHECK(std::max(std::abs(x), std::abs(y)) <= 1.0);
        CHECK(std::max(std::abs(x), std::abs(y)) >= 0.5);
        CHECK(cloud.points.z[i] == Approx(10.0));
    }
    const model::Region far = app::region_named(project, "2025-06-01/baulk");
    CHECK_THROWS_AS(app::write_region_points(project, far, folder / "far.ply", Progress::none()), Error);
    CHECK_FALSE(std::filesystem::exists(folder / "far.ply"));
}

TEST_CASE("Parallel sections keep their heights apart") {
    const test::TemporaryFolder folder;
    std::string walls; // y = 0: 1 m high; y = 1 m: 2 m high, a point every 5 cm
    for (int x = 0; x <= 40; ++x) {
        for (int z = 0; z <= 40; ++z) {
            if (z <= 20) walls += fmt::format("{} 0.001 {}\n", 0.05 * x, 0.05 * z);
            walls += fmt::format("{} 1.001 {}\n", 0.05 * x, 0.05 * z);
        }
    }
    app::Project project = test::project_with_scan(folder, walls);
    test::place_scans(project, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    std::vector<app::DrawnOutline> outlines;
    for (const double y : {0.0, 1.0}) {
        auto outline = drawn("baulk", "0.01 0.01, 1.99 0.01, 1.99 2.01, 0.01 2.01");
        outline.on_plane = true;
        outline.section =
            app::SectionWish{fmt::format("S{}", y), std::array<std::array<double, 2>, 2>{{{0.0, y}, {2.0, y}}}};
        outlines.push_back(outline);
    }
    app::import_outlines(project, {outlines, {}}, {});
    for (int pass = 0; pass < 2; ++pass) {
        const auto rows = app::list_regions(project, "").rows;
        REQUIRE(rows.size() == 2);
        CHECK(rows[0].points == 39 * 20);
        CHECK(rows[1].points == 39 * 40);
    }
}

TEST_CASE("Regions are listed although the points of a scan are gone, and cleaning removes what no region needs") {
    const test::TemporaryFolder folder;
    app::Project project = test::project_with_scan(folder, a_field());
    test::place_scans(project, test::turned_pose(8.0));
    app::import_outlines(project,
                         {{drawn("water", "99.5 199.5 10, 100.5 199.5 10, 100.5 200.5 10, 99.5 200.5 10")}, {}}, {});
    std::filesystem::remove_all(folder / "2025-06-01");
    std::filesystem::rename(folder / "site.scans", folder / "aside");
    const auto without = app::list_regions(project, "");
    REQUIRE(without.rows.size() == 1);
    CHECK(without.rows[0].incomplete);
    CHECK_FALSE(without.rows[0].outside_scans);
    REQUIRE(without.problems.size() == 1);
    CHECK_THAT(without.problems[0].what, Catch::Contains("2025-06-01/s") && Catch::Contains("put it back"));
    std::filesystem::remove_all(folder / "site.scans");
    std::filesystem::rename(folder / "aside", folder / "site.scans");
    CHECK(app::list_regions(project, "").rows[0].points == 400);
    std::filesystem::rename(app::scans_folder(project.path()) / "regions", folder / "kept");
    std::filesystem::rename(folder / "site.scans", folder / "aside");
    std::filesystem::create_directories(folder / "site.scans");
    std::filesystem::rename(folder / "kept", folder / "site.scans/regions");
    const auto kept = app::list_regions(project, ""); // counted before, so the scan is not needed
    CHECK(kept.problems.empty());
    CHECK(kept.rows[0].points == 400);
    CHECK(app::clean_project(project, "", Progress::none()).removed.empty());
    app::record_kind("region").remove(project, "2025-06-01/water");
    CHECK(app::clean_project(project, "", Progress::none()).removed.size() == 1);
}

TEST_CASE("A file that cannot be written is said before the points are read, and nothing is left") {
    const test::TemporaryFolder folder;
    app::Project project = test::project_with_scan(folder, a_field());
    test::place_scans(project, test::turned_pose(8.0));
    app::import_outlines(project,
                         {{drawn("water", "99.5 199.5 10, 100.5 199.5 10, 100.5 200.5 10, 99.5 200.5 10")}, {}}, {});
    const model::Region water = app::region_named(project, "2025-06-01/water");
    CHECK_THROWS_WITH(app::write_region_points(project, water, folder / "nowhere/w.ply", Progress::none()),
                      Catch::Contains("cannot be written"));
    std::filesystem::create_directories(folder / "taken.ply");
    CHECK_THROWS_AS(app::write_region_points(project, water, folder / "taken.ply", Progress::none()), Error);
    CHECK_FALSE(std::filesystem::exists(folder / "taken.ply.part"));
}

TEST_CASE("Scans of another surface of the same day and area do not show a region, those of another area may") {
    model::Record record;
    const model::AreaId west{Uuid{1, 1}};
    const model::AreaId east{Uuid{1, 2}};
    const auto surface = [&](std::uint64_t id, model::AreaId area, const char* first, const char* last) {
        model::Surface s;
        s.id = {Uuid{2, id}};
        s.area = area;
        s.first_day = first;
        s.last_day = last;
        record.surfaces.push_back(s);
    };
    surface(1, west, "2025-06-01", "2025-06-02");
    surface(2, west, "2025-06-02", "2025-06-02");
    surface(3, east, "2025-06-02", "2025-06-02");
    const auto scan = [&](const char* day, std::size_t on) {
        model::Scan s;
        s.day = day;
        s.surface = record.surfaces[on].id;
        return s;
    };
    CHECK(app::may_show(record, scan("2025-06-02", 0), record.surfaces[0]));
    CHECK_FALSE(app::may_show(record, scan("2025-06-02", 1), record.surfaces[0]));
    CHECK(app::may_show(record, scan("2025-06-02", 2), record.surfaces[0]));
    CHECK_FALSE(app::may_show(record, scan("2025-06-03", 2), record.surfaces[0]));
}
