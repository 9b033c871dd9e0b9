// SPDX-License-Identifier: MIT
#include "app/scans/verify_scans.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "app/scans/add_scans.hpp"
#include "app/scans/list_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

namespace planum::app {

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

struct Site {
    test::TemporaryFolder folder;
    fs::path file = folder.path() / "site.gpkg";
    fs::path original = folder.path() / "2025-06-01" / "station1.xyz";
    Project project = Project::create(file, {}, {});

    Site() {
        write(original, "1 2 3\n4 5 6\n7 7 7\n"); // in one cube of 8 m: one block
        add_scans(project, {original}, {}, Progress::none());
    }

    [[nodiscard]] fs::path store() { return store_path(file, scan_named(project, "2025-06-01/station1")); }
};

// Turns one bit of the first point's x.
void damage_first_block(const fs::path& store) {
    std::fstream file(store, std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(168);
    const int byte = file.get();
    file.seekp(168);
    file.put(static_cast<char>(byte ^ 1));
}

} // namespace

TEST_CASE("Sound scans have no problem, and a store that is missing is none") {
    Site site;
    CHECK(verify_scans(site.project, Progress::none()).empty());
    fs::remove_all(scans_folder(site.file));
    CHECK(verify_scans(site.project, Progress::none()).empty());
}

TEST_CASE("A damaged block is reported and made again from the original") {
    Site site;
    damage_first_block(site.store());
    const auto problems = verify_scans(site.project, Progress::none());
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].where == "scan 2025-06-01/station1");
    CHECK_THAT(problems[0].what, Catch::Contains("1 of 1 blocks") && Catch::Contains("byte 168") &&
                                     Catch::Contains("made again from the original"));
    CHECK(verify_scans(site.project, Progress::none()).empty());
}

TEST_CASE("Another file in the place of the original is a problem, and no store is made from it") {
    Site site;
    damage_first_block(site.store());
    write(site.original, "1 2 3\n4 5 7\n");
    const auto problems = verify_scans(site.project, Progress::none());
    REQUIRE(problems.size() == 2);
    CHECK_THAT(problems[0].what, Catch::Contains("no longer the file that was added"));
    CHECK_THAT(problems[1].what, Catch::Contains("damaged") && !Catch::Contains("made again"));
    fs::remove(site.original);
    CHECK_THAT(verify_scans(site.project, Progress::none())[0].what, Catch::Contains("its original is not there"));
}

TEST_CASE("Cleaning removes what belongs to no scan and what a killed program left, nothing else") {
    Site site;
    const fs::path store = site.store();
    const fs::path folder = scans_folder(site.file);
    const fs::path left = folder / "x-0.pts.999999999.part"; // no process has that number
    const fs::path writing = folder / ("y-0.pts." + std::to_string(::getpid()) + ".part");
    const fs::path other = folder / "surface.grid";
    for (const fs::path& file : {left, writing, other}) write(file, "1234567");
    CHECK(clean_scans(site.project).removed == std::vector<fs::path>{left});
    delete_scan(site.project, "2025-06-01/station1");
    const CleanedScans cleaned = clean_scans(site.project);
    CHECK(cleaned.removed == std::vector<fs::path>{store});
    CHECK(cleaned.bytes > 168);
    CHECK(fs::exists(writing));
    CHECK(fs::exists(other));
}

TEST_CASE("A store is made again with the columns that were stated") {
    test::TemporaryFolder folder;
    const fs::path site = folder.path() / "site.gpkg";
    const fs::path original = folder.path() / "2025-06-01" / "turned.xyz";
    write(original, "1 2 3\n4 5 6\n7 8 10\n");
    Project project = Project::create(site, {}, {});
    AddScansOptions options;
    options.columns = "z,y,x";
    add_scans(project, {original}, options, Progress::none());
    const model::Scan scan = scan_named(project, "2025-06-01/turned");
    const auto bounds = open_store(site, scan, Progress::none())->bounds();
    CHECK(bounds.maximum == std::array<double, 3>{10.0, 8.0, 7.0});
    fs::remove_all(scans_folder(site));
    CHECK(open_store(site, scan, Progress::none())->bounds() == bounds);
}

} // namespace planum::app
