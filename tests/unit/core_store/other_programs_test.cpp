// SPDX-License-Identifier: MIT
// What GDAL, and so QGIS, may do to a project.
#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <sys/wait.h>

#include "core/base/error.hpp"
#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/core_store/filled_project.hpp"

using namespace planum;
using namespace planum::store;

namespace {

struct Output {
    int status = -1;
    std::string text;
};

Output run(const std::string& command) {
    Output output;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) output.text += buffer.data();
    const int status = pclose(pipe);
    output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return output;
}

/// A Python that has GDAL's modules: Debian's own, which another one in front of it may hide.
std::string python_with_gdal() {
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        if (run(std::string{python} + " -c 'import osgeo_utils.samples.validate_gpkg'").status == 0) return python;
    }
    std::cerr << "skipped: GDAL's Python modules (python3-gdal) are not installed\n";
    return {};
}

} // namespace

TEST_CASE("The validator of GeoPackages has nothing to say about a filled project") {
    const std::string python = python_with_gdal();
    if (python.empty()) return;
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const std::string file = (folder / "site.planum.gpkg").string();
    ProjectFile project = test::fill_project(file, environment);
    model::ProjectSettings settings = project.settings();
    settings.srs_id = 25832;
    project.change("Move to UTM", [&] { project.update(settings); });
    const Output output = run(python + " -m osgeo_utils.samples.validate_gpkg --extra '" + file + "'");
    INFO(output.text);
    CHECK(output.status == 0);
    CHECK(output.text.empty());
}

TEST_CASE("Through GDAL rows are added, changed and marked, and the rules hold") {
    const std::string python = python_with_gdal();
    if (python.empty()) return;
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    const std::string file = (folder / "site.planum.gpkg").string();
    (void)test::fill_project(file, environment);
    const auto session = test::source_folder() / "tests/unit/core_store/ogr_session.py";
    const Output output = run(python + " '" + session.string() + "' '" + file + "'");
    INFO(output.text);
    REQUIRE(output.status == 0);
    const auto said = [&](std::string_view text) { return output.text.find(text) != std::string::npos; };
    CHECK(said("read: 29 layers, some features, 0 warnings"));
    CHECK(said("open for changing: 0 warnings"));
    CHECK(said("read again: 29 layers, some features, 0 warnings"));
    for (const char* done : {"insert unit: done", "insert unit without kind: done", "insert region: done",
                             "insert level: done", "change: done", "day: done", "contemporary: done",
                             "delete contemporary: done", "delete: done", "delete referred to: done", "index: done"}) {
        CHECK(said(done));
    }
    for (const char* refused :
         {"bad kind: refused", "bad key: refused", "bad height: refused", "bad uuid: refused", "used number: refused",
          "bad key in a change: refused", "changed uuid: refused", "delete project: refused", "delete log: refused",
          "empty number: refused", "emptied number: refused", "bad day: refused", "bad day in a change: refused",
          "line for a level: refused", "empty level: refused", "flat level: refused", "cuts twice: refused",
          "contemporary the other way round: refused", "delete change: refused"}) {
        CHECK(said(refused));
    }

    ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
    REQUIRE(project.open_report().notes.size() == 1);
    CHECK(project.open_report().notes[0].find("spatial index of the layer region was dropped") != std::string::npos);
    CHECK_FALSE(project.open_report().import_only);
    const model::Record record = project.load();
    CHECK(record.units.size() == 6); // six, two added, two deleted
    const auto ditch =
        std::find_if(record.units.begin(), record.units.end(), [](const auto& u) { return u.number == "900"; });
    REQUIRE(ditch != record.units.end());
    CHECK(ditch->title == "ditch");
    CHECK(record.regions.size() == 3);
    CHECK(project.verify(Progress::none()).empty());
    const std::vector<LogEntry> log = project.log(ditch->id.value, 10);
    REQUIRE(log.size() == 3);
    CHECK(log[0].field == "excavated_on");
    CHECK(log[1].field == "title");
    CHECK(log[2].action == "insert");
    CHECK(log[2].author == "outside Planum");
    std::size_t outside = 0;
    bool deleted_units = false;
    for (const ChangeEntry& entry : project.history(100)) {
        if (entry.number > 0) continue;
        ++outside;
        CHECK(entry.author == "outside Planum");
        deleted_units = deleted_units || entry.label == "Deleted 2 rows of unit with another program";
    }
    CHECK(outside > 2);
    CHECK(deleted_units);
    CHECK(project.history(1).size() == 1);
    const sqlite::Database database = sqlite::Database::open(file, sqlite::Access::ReadOnly);
    CHECK(database.integer("SELECT count(*) FROM unit WHERE deleted_at IS NOT NULL") == 2);
    CHECK(database.integer("SELECT count(*) FROM relation WHERE deleted_at IS NOT NULL") > 0);
    CHECK(database.integer("SELECT count(*) FROM planum_log WHERE action = 'delete' AND table_name = 'unit'") == 2);
    CHECK(project.change("Still works", [&] { project.insert(test::a_unit("950")); }) == 3);
}
