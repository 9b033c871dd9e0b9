// SPDX-License-Identifier: MIT
// One tiny project per released schema version stands in tests/data/schema and must open for ever.
#include "core/sqlite/database.hpp"
#include "core/store/project_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/core_store/filled_project.hpp"

using namespace planum;
using namespace planum::store;

TEST_CASE("A project of every released schema version opens, migrates and works") {
    const test::TemporaryFolder folder;
    for (std::int64_t version = 1; version <= kSchemaVersion; ++version) {
        INFO("version " << version);
        const auto kept = test::source_folder() / "tests/data/schema" / ("v" + std::to_string(version) + ".gpkg");
        const auto file = folder / "site.gpkg";
        std::filesystem::copy_file(kept, file, std::filesystem::copy_options::overwrite_existing);
        test::TestEnvironment environment(11);
        ProjectFile project = ProjectFile::open(file, OpenMode::ReadWrite, environment.get());
        CHECK(project.schema_version() == kSchemaVersion);
        CHECK_FALSE(project.open_report().import_only);
        const model::Record record = project.load();
        CHECK(record.settings.name == "Test dig");
        CHECK(record.units.size() == 6);
        CHECK(record.relations.size() == 3);
        CHECK(record.regions.size() == 2);
        CHECK(record.poses.size() == 1);
        CHECK(project.verify(Progress::none()).empty());
        CHECK(project.change("Add", [&] { project.insert(test::a_unit("77")); }) > 0);
        (void)project.undo();
        CHECK(project.undo().label == "A day's work");
    }
}

TEST_CASE("The project of the newest schema version is what this program would make", "[.make]") {
    // Run by hand, once, before a version is released: PLANUM_KEEP=1 test_unit_core_store "[.make]"
    const test::TemporaryFolder folder;
    test::TestEnvironment environment;
    (void)test::fill_project(folder / "newest.gpkg", environment);
}
