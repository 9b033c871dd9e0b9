// SPDX-License-Identifier: MIT
#include "app/regions/region_points.hpp"

#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/regions/region_list.hpp"
#include "app/regions/region_names.hpp"
#include "app/regions/region_ply.hpp"
#include "app/scans/add_scans.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "tests/support/catch.hpp"
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

void place(app::Project& project) {
    project.change("place", [&] {
        model::RegistrationRun run;
        run.name = "1";
        run.made_at = "2025-06-02T10:00:00Z";
        run.state = "accepted";
        run.id = project.file().insert(run);
        for (const model::Scan& scan : project.record().scans) {
            model::ScanPose pose;
            pose.scan = scan.id;
            pose.run = run.id;
            pose.site_from_scan = {0, -1, 0, 100, 1, 0, 0, 200, 0, 0, 1, 8, 0, 0, 0, 1};
            project.file().insert(pose);
        }
    });
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
    std::filesystem::create_directories(folder / "2025-06-01");
    std::ofstream(folder / "2025-06-01/s.xyz") << a_field();
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    app::add_scans(project, {folder / "2025-06-01"}, {}, Progress::none());
    app::import_outlines(project,
                         {{drawn("spoil", "99 199 10, 101 199 10, 101 201 10, 99 201 10"),
                           drawn("water", "99.5 199.5 10, 100.5 199.5 10, 100.5 200.5 10, 99.5 200.5 10"),
                           drawn("baulk", "300 300 10, 301 300 10, 301 301 10")},
                          {}},
                         {});
    CHECK(app::list_regions(project, "")[1].points == 0); // not registered yet
    place(project);
    for (int pass = 0; pass < 2; ++pass) { // counted, then from what was kept
        const auto rows = app::list_regions(project, "");
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
