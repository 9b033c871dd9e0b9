// SPDX-License-Identifier: MIT
#include "gui/viewmodels/section_model.hpp"

#include "gui/viewmodels/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

TEST_CASE("Without a section in the record there are cuts through the middle of the outlines, with what scans show") {
    const test::TemporaryFolder folder;
    test::ensure_core_application();
    (void)test::make_measured_days(folder, folder / "site.gpkg");
    Models models{app::Session{"Ada"}};
    SectionModel sections(models.workspace);
    CHECK(sections.chosen() == -1);
    models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
    settle(models.workspace);
    REQUIRE(sections.choices().size() == 2);
    CHECK(sections.sheet() == nullptr); // nobody looks
    const auto west_east = sections.section();
    REQUIRE(west_east);
    CHECK(west_east->id.is_nil());
    CHECK(west_east->from_in_site[1] == Approx(0.5));
    CHECK(west_east->to_in_site[1] == Approx(0.5));
    CHECK(west_east->from_in_site[0] < 0.0);
    CHECK(west_east->to_in_site[0] > 2.0);
    sections.set_watched(true);
    settle(models.workspace);
    REQUIRE(sections.sheet() != nullptr);
    CHECK_FALSE(sections.is_looking());
    CHECK(sections.sheet()->extent.low[1] < 5.0);   // the floor
    CHECK(sections.sheet()->extent.high[1] > 5.12); // and what lay on it on the first day
    const auto before = sections.sheet();
    models.workspace.edit(QStringLiteral("edit"), [](app::Project& project, Progress&) {
        app::record_kind("unit").set(project, "3", {{"title", "floor"}});
    });
    settle(models.workspace);
    CHECK(sections.sheet() == before); // the scans stand as they stood
    sections.choose(1);
    settle(models.workspace);
    CHECK(sections.sheet() != before);
    models.workspace.close();
    CHECK(sections.choices().empty());
    CHECK(sections.sheet() == nullptr);
}

TEST_CASE("A cut laid elsewhere is shown as one more section until the project is closed") {
    const test::TemporaryFolder folder;
    test::ensure_core_application();
    (void)test::make_measured_days(folder, folder / "site.gpkg");
    Models models{app::Session{"Ada"}};
    SectionModel sections(models.workspace);
    models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
    settle(models.workspace);
    sections.set_watched(true);
    settle(models.workspace);
    model::Section cut;
    cut.from_in_site = {0.0, 0.2};
    cut.to_in_site = {2.0, 0.8};
    sections.show_cut(cut, 0.1);
    settle(models.workspace);
    REQUIRE(sections.choices().size() == 3);
    CHECK(sections.section() == cut);
    REQUIRE(sections.sheet() != nullptr);
    const auto before = sections.sheet();
    sections.show_cut(cut, 0.3); // thicker
    settle(models.workspace);
    CHECK(sections.choices().size() == 3);
    CHECK(sections.sheet() != before);
    models.workspace.edit(QStringLiteral("edit"), [](app::Project& project, Progress&) {
        app::record_kind("unit").set(project, "3", {{"title", "floor"}});
    });
    settle(models.workspace);
    CHECK(sections.section() == cut);
    models.workspace.close();
    models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
    settle(models.workspace);
    CHECK(sections.choices().size() == 2);
}

TEST_CASE("Where nothing has a place there is no cut") { CHECK(middle_cuts({}).empty()); }

TEST_CASE("The plan marks the sections of the record, and of the cuts the one that is looked at") {
    const test::TemporaryFolder folder;
    test::ensure_core_application();
    {
        app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
        project.change("section", [&] {
            model::Section section;
            section.name = "S 1";
            section.from_in_site = {0.0, 0.25};
            section.to_in_site = {2.0, 0.25};
            project.file().insert(section);
        });
    }
    Models models{app::Session{"Ada"}};
    models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
    settle(models.workspace);
    SectionModel& sections = models.sections;
    REQUIRE(sections.choices().size() == 3);
    auto lines = sections.lines_in_plan();
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].name == QStringLiteral("S 1"));
    CHECK(lines[0].chosen);
    sections.choose(2);
    lines = sections.lines_in_plan();
    REQUIRE(lines.size() == 2);
    CHECK_FALSE(lines[0].chosen);
    CHECK(lines[1].chosen);
    CHECK(lines[1].from.x() == lines[1].to.x()); // from south to north
    CHECK(lines[1].from.y() < 0.0);
    sections.choose(0);
    CHECK(sections.lines_in_plan().size() == 1);
}

TEST_CASE("A registration accepted or discarded moves what the section shows") {
    const test::TemporaryFolder folder;
    test::ensure_core_application();
    {
        app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
        test::place_scans(project, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1}, "2");
    }
    Models models{app::Session{"Ada"}};
    SectionModel sections(models.workspace);
    models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
    settle(models.workspace);
    sections.set_watched(true);
    settle(models.workspace);
    REQUIRE(sections.sheet() != nullptr);
    const auto before = sections.sheet();
    models.workspace.edit(QStringLiteral("discard"), [](app::Project& project, Progress&) {
        model::RegistrationRun run = project.record().runs.back();
        REQUIRE(run.name == "2");
        run.state = "discarded";
        project.change("discard", [&] { project.file().update(run); });
    });
    settle(models.workspace);
    REQUIRE(sections.sheet() != nullptr);
    CHECK(sections.sheet() != before);
}
