// SPDX-License-Identifier: MIT
#include "app/scans/take_over_scans.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include "app/scans/add_scans.hpp"
#include "app/scans/list_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

namespace planum::app {

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

/// A project with one scan that an accepted run placed.
Project placed_project(const fs::path& folder) {
    write(folder / "2025-06-01" / "station1.xyz", "1 2 3\n4 5 6\n7 8 10\n");
    Project project = Project::create(folder / "site.gpkg", {}, {});
    project.change("Add area", [&] {
        model::Area area;
        area.name = "A";
        project.file().insert(area);
    });
    add_scans(project, {folder / "2025-06-01"}, {}, Progress::none());
    project.change("Register", [&] {
        model::RegistrationRun run;
        run.name = "1";
        run.made_at = "2025-06-02T08:00:00Z";
        run.method = "markers";
        run.state = "accepted";
        run.report = "{}";
        model::ScanPose pose;
        pose.run = project.file().insert(run);
        pose.scan = project.record().scans.front().id;
        pose.site_from_scan = {1, 0, 0, 100, 0, 1, 0, 200, 0, 0, 1, 10, 0, 0, 0, 1};
        project.file().insert(pose);
    });
    return project;
}

} // namespace

TEST_CASE("Scans taken over from another project are the same files, where they were placed") {
    const test::TemporaryFolder folder;
    Project from = placed_project(folder.path());
    fs::create_directories(folder.path() / "copy");
    Project into = Project::create(folder.path() / "copy" / "other.gpkg", {}, {});
    into.change("Add area", [&] {
        model::Area area;
        area.name = "A";
        into.file().insert(area);
    });

    CHECK(take_over_scans(into, from, Progress::none()) == 1);
    const model::Scan scan = scan_named(into, "2025-06-01/station1");
    CHECK(scan.path == "../2025-06-01/station1.xyz");
    CHECK(fs::equivalent(original_path(into.path(), scan), folder.path() / "2025-06-01" / "station1.xyz"));
    REQUIRE(into.record().surfaces.size() == 1);
    CHECK(into.record().surfaces.front().id == scan.surface);
    CHECK(into.record().surfaces.front().area == into.record().areas.front().id);
    const auto placed = placed_scans(
        into, [](const model::Scan&) { return true; }, Progress::none());
    REQUIRE(placed.size() == 1);
    CHECK(placed.front().site_from_scan.translation.isApprox(Eigen::Vector3d(100, 200, 10)));
    CHECK(placed.front().store->points() == 3);

    // All of it is one step, and what is there already is no conflict of scans but of runs.
    CHECK_THROWS_AS(take_over_scans(into, from, Progress::none()), Error);
    into.undo();
    CHECK(into.record().scans.empty());
    CHECK(into.record().runs.empty());
}

TEST_CASE("A store taken over needs no disk of its own, and outlives the other's") {
    const test::TemporaryFolder folder;
    Project from = placed_project(folder.path());
    Project into = Project::create(folder.path() / "other.gpkg", {}, {});
    take_over_scans(into, from, Progress::none());
    const model::Scan scan = scan_named(into, "2025-06-01/station1");
    const fs::path store = store_path(into.path(), scan);
    if (fs::exists(store)) CHECK(fs::hard_link_count(store) == 2);
    fs::remove_all(scans_folder(from.path()));
    CHECK(open_store(into.path(), scan, Progress::none())->points() == 3);
    fs::remove_all(scans_folder(into.path())); // and where there is none, it is made
    CHECK(open_store(into.path(), scan, Progress::none())->points() == 3);
}

} // namespace planum::app
