// SPDX-License-Identifier: MIT
#include "app/scans/scan_stores.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "app/scans/add_scans.hpp"
#include "app/scans/list_scans.hpp"
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

ErrorCode code_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& e) {
        return e.code();
    }
    return ErrorCode::Internal;
}

} // namespace

TEST_CASE("a point store that is gone or damaged is made again from the original, and only from it") {
    const test::TemporaryFolder folder;
    const fs::path site = folder.path() / "site.gpkg";
    const fs::path original = folder.path() / "2025-06-01" / "station1.xyz";
    write(original, "1 2 3\n4 5 6\n7 8 10\n");
    Project project = Project::create(site, {}, {});
    add_scans(project, {original}, {}, Progress::none());
    const model::Scan scan = scan_named(project, "2025-06-01/station1");
    const fs::path store = store_path(site, scan);
    REQUIRE(fs::exists(store));

    SECTION("gone") { REQUIRE(fs::remove_all(scans_folder(site)) > 0); }
    SECTION("no store") {
        write(store, "something else");
        REQUIRE(fs::exists(store));
    }
    const auto opened = open_store(site, scan, Progress::none());
    CHECK(opened->points() == 3);
    CHECK(opened->info().source_sha256 == scan.sha256);
}

TEST_CASE("the same file read by other columns is kept apart, so that taking back brings the first points") {
    const test::TemporaryFolder folder;
    const fs::path site = folder.path() / "site.gpkg";
    const fs::path original = folder.path() / "2025-06-01" / "points.xyz";
    write(original, "1 2 3 4 5\n4 5 6 7 8\n");
    Project project = Project::create(site, {}, {});
    const auto highest = [&] {
        const model::Scan scan = scan_named(project, "2025-06-01/points");
        return open_store(site, scan, Progress::none())->bounds().maximum[2];
    };
    add_scans(project, {original}, {}, Progress::none());
    CHECK(highest() == Approx(6.0));
    delete_scan(project, "2025-06-01/points");
    AddScansOptions options;
    options.columns = "x,y,-,z";
    add_scans(project, {original}, options, Progress::none());
    CHECK(highest() == Approx(7.0));
    project.undo();
    project.undo();
    CHECK(highest() == Approx(6.0));
}

TEST_CASE("another file in the place of the original is not taken for it") {
    const test::TemporaryFolder folder;
    const fs::path site = folder.path() / "site.gpkg";
    const fs::path original = folder.path() / "2025-06-01" / "station1.xyz";
    write(original, "1 2 3\n4 5 6\n");
    Project project = Project::create(site, {}, {});
    add_scans(project, {original}, {}, Progress::none());
    const model::Scan scan = scan_named(project, "2025-06-01/station1");
    fs::remove_all(scans_folder(site));

    write(original, "1 2 3\n4 5 7\n");
    CHECK(code_of([&] { (void)open_store(site, scan, Progress::none()); }) == ErrorCode::BadInput);
    fs::remove(original);
    CHECK(code_of([&] { (void)open_store(site, scan, Progress::none()); }) == ErrorCode::NotFound);
    CHECK_FALSE(fs::exists(store_path(site, scan)));
}

TEST_CASE("one bad file among good ones adds nothing and leaves nothing behind") {
    const test::TemporaryFolder folder;
    const fs::path site = folder.path() / "site.gpkg";
    write(folder.path() / "2025-06-01" / "a.xyz", "1 2 3\n4 5 6\n");
    write(folder.path() / "2025-06-01" / "b.xyz", "1 2 3\n4 5\n");
    Project project = Project::create(site, {}, {});
    CHECK(code_of([&] { add_scans(project, {folder.path()}, {}, Progress::none()); }) == ErrorCode::BadInput);
    CHECK(project.record().scans.empty());
    CHECK(project.record().surfaces.empty());
    CHECK_FALSE(fs::exists(scans_folder(site)));
}

} // namespace planum::app
