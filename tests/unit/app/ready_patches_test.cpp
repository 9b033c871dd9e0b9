// SPDX-License-Identifier: MIT
#include "app/regions/ready_patches.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include <fmt/format.h>

#include "app/regions/geojson_outlines.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/scans/add_scans.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/placed_scan.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using Catch::Matchers::Contains;

namespace {

// 3 × 1 m in three squares, each level.
void write_day(const std::filesystem::path& folder, const std::array<double, 3>& heights) {
    std::filesystem::create_directories(folder);
    std::ofstream out(folder / "s.xyz");
    for (int x = 0; x < 300; ++x) {
        for (int y = 0; y < 100; ++y) {
            out << fmt::format("{:.3f} {:.3f} {}\n", 0.01 * x + 0.005, 0.01 * y + 0.005,
                               heights[static_cast<std::size_t>(x / 100)]);
        }
    }
}

app::DrawnOutline drawn(const std::string& unit, const std::string& day, int square) {
    app::DrawnOutline outline;
    outline.unit = unit;
    outline.day = day;
    outline.shape = app::parse_outline(fmt::format("{0} 0, {1} 0, {1} 1, {0} 1", square, square + 1));
    return outline;
}

// On the first day 1, 2 and 3 lie side by side; `after` is the ground of the second.
app::Project dig(const test::TemporaryFolder& folder, const std::array<double, 3>& after,
                 const std::vector<app::DrawnOutline>& on_second, const std::vector<std::string>& relations) {
    write_day(folder / "2025-06-01", {5.2, 5.1, 5.0});
    write_day(folder / "2025-06-02", after);
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    app::add_scans(project, {folder / "2025-06-01", folder / "2025-06-02"}, {}, Progress::none());
    for (const char* number : {"4", "5"}) {
        model::StratigraphicUnit unit;
        unit.number = number;
        project.change("unit", [&] { project.file().insert(unit); });
    }
    app::RegionImportOptions options;
    options.create_units = true;
    std::vector<app::DrawnOutline> all = {drawn("1", "2025-06-01", 0), drawn("2", "2025-06-01", 1),
                                          drawn("3", "2025-06-01", 2)};
    all.insert(all.end(), on_second.begin(), on_second.end());
    app::import_outlines(project, {all, {}}, options);
    for (const std::string& relation : relations) {
        model::PhysicalRelation r;
        r.subject = project.record().units[project.unit_named(relation.substr(0, 1))].id;
        r.object = project.record().units[project.unit_named(relation.substr(1, 1))].id;
        project.change("relation", [&] { project.file().insert(r); });
    }
    test::place_scans(project, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    return project;
}

app::ReadyPatches patches(app::Project& project) { return app::ready_patches(project, {}, Progress::none()); }

} // namespace

TEST_CASE("Ground that went is a patch with the one unit that the record knows below") {
    const test::TemporaryFolder folder;
    app::Project project = dig(folder, {4.9, 5.1, 5.0}, {}, {"14"});
    const app::ReadyPatches found = patches(project);
    REQUIRE(found.patches.size() == 1);
    const app::ReadyPatch& patch = found.patches[0];
    CHECK(patch.surface == "2025-06-02");
    CHECK(patch.was == "1");
    CHECK(patch.proposed == "4");
    CHECK(patch.change == Approx(-0.3).margin(0.002));
    CHECK(patch.area == Approx(1.0).margin(0.12)); // the outermost cells are unsure
    CHECK(geometry::area(patch.shape) == Approx(patch.area).margin(0.03));
    CHECK_THAT(patch.because, Contains("1 was dug away here"));
}

TEST_CASE("Several units below, or none, and nobody is proposed") {
    const test::TemporaryFolder folder;
    app::Project project = dig(folder, {4.9, 5.1, 4.8}, {}, {"14", "15"});
    const app::ReadyPatches found = patches(project);
    REQUIRE(found.patches.size() == 2);
    for (const app::ReadyPatch& patch : found.patches) {
        CHECK(patch.proposed.empty());
        CHECK_THAT(patch.because, Contains(patch.was == "1" ? "recorded below it are 4, 5" : "has no unit below it"));
    }
}

TEST_CASE("A neighbour that goes on without a step has it, also one outlined the day before") {
    const test::TemporaryFolder folder;
    // 1 and 3 went down to the level of 2, which nobody outlined again and which lies on one side of each.
    app::Project project = dig(folder, {5.1, 5.1, 5.0}, {}, {"12", "14"});
    const app::ReadyPatches found = patches(project);
    REQUIRE(found.patches.size() == 1);
    CHECK(found.patches[0].proposed == "2");
    CHECK_THAT(found.patches[0].because, Contains("goes on beside it without a step"));
}

TEST_CASE("What is outlined is no patch, and ground that came up has no unit") {
    const test::TemporaryFolder folder;
    app::Project project = dig(folder, {4.9, 5.1, 5.4}, {drawn("4", "2025-06-02", 0)}, {"14"});
    const app::ReadyPatches found = patches(project);
    REQUIRE(found.patches.size() == 1);
    CHECK(found.patches[0].was == "3");
    CHECK(found.patches[0].proposed.empty());
    CHECK_THAT(found.patches[0].because, Contains("came up by 0.40 m"));
}

TEST_CASE("The patches as GeoJSON come in again as outlines") {
    const test::TemporaryFolder folder;
    app::Project project = dig(folder, {4.9, 5.1, 5.0}, {}, {"14"});
    const app::OutlineFile outlines =
        app::read_geojson_outlines(app::patches_geojson(project.record(), patches(project)));
    REQUIRE(outlines.outlines.size() == 1);
    app::import_outlines(project, outlines, {});
    CHECK(patches(project).patches.empty());
    const auto& regions = project.record().regions;
    CHECK(std::count_if(regions.begin(), regions.end(), [&](const model::Region& region) {
              return project.index().name(region.unit) == "4" && region.category == model::RegionCategory::Unit;
          }) == 1);
}

TEST_CASE("A surface without one before it, and an unknown one, are a sentence") {
    const test::TemporaryFolder folder;
    app::Project project = dig(folder, {4.9, 5.1, 5.0}, {}, {});
    app::PatchQuery query;
    query.surface = "2025-06-01";
    const app::ReadyPatches first = app::ready_patches(project, query, Progress::none());
    CHECK(first.patches.empty());
    REQUIRE(first.notes.size() == 1);
    CHECK_THAT(first.notes[0], Contains("no registered surface before it"));
    query.surface = "2025-07-01";
    CHECK_THROWS_AS(app::ready_patches(project, query, Progress::none()), Error);
}
