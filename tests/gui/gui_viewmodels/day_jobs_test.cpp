// SPDX-License-Identifier: MIT
#include "gui/viewmodels/day_jobs.hpp"

#include "gui/viewmodels/records_model.hpp"
#include "gui/viewmodels/today_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

struct Day {
    test::GuiProject site;
    Workspace workspace{app::Session{"Ada"}};
    DayJobs day{workspace};
    QStringList failures;
    QStringList done;
    ImportPreview preview;

    Day() {
        QObject::connect(&workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        QObject::connect(&day, &DayJobs::done, [this](const QString& s) { done << s; });
        QObject::connect(&day, &DayJobs::previewed, [this](const ImportPreview& p) { preview = p; });
        workspace.open(site.file, store::OpenMode::ReadWrite);
        settle(workspace);
    }
};

} // namespace

TEST_CASE("An import is previewed without writing, then done as one undo step") {
    Day d;
    const auto file = d.site.folder.write("units.csv", "unit,kind,title\n8,layer,hearth\n3,layer,another floor\n");
    d.day.preview_import({file}, false);
    settle(d.workspace);
    CHECK(d.failures.isEmpty());
    CHECK(d.preview.changes);
    CHECK(d.preview.changed.size() == 1);
    CHECK(d.workspace.snapshot()->record().units.size() == 3);
    d.day.import({file}, false);
    settle(d.workspace);
    CHECK(d.workspace.snapshot()->record().units.size() == 4);
    CHECK(d.done.size() == 1);
    d.workspace.undo();
    settle(d.workspace);
    CHECK(d.workspace.snapshot()->record().units.size() == 3);
}

TEST_CASE("A file that cannot be imported is a sentence") {
    Day d;
    d.day.import({d.site.folder / "gone.csv"}, false);
    settle(d.workspace);
    CHECK(d.failures.size() == 1);
    CHECK(d.done.isEmpty());
    QStringList refused;
    QObject::connect(&d.day, &DayJobs::notPreviewed, [&](const QString& s) { refused << s; });
    d.day.preview_import({d.site.folder / "gone.csv"}, false);
    settle(d.workspace);
    REQUIRE(refused.size() == 1);
    CHECK(refused.front() == d.failures.back());
}

TEST_CASE("Files are known for what they are by their names") {
    const test::TemporaryFolder folder;
    CHECK(use_of("a/site.GPKG") == FileUse::Project);
    CHECK(use_of("station1.ptx") == FileUse::Scans);
    CHECK(use_of(folder.path()) == FileUse::Scans);
    CHECK(use_of("day.geojson") == FileUse::Outlines);
    CHECK(use_of("units.csv") == FileUse::Lists);
}

TEST_CASE("A backup is a project of its own, and the open one stays open") {
    Day d;
    d.day.backup(d.site.folder / "copy.gpkg");
    settle(d.workspace);
    CHECK(d.failures.isEmpty());
    app::Project copy = app::Project::open(d.site.folder / "copy.gpkg", store::OpenMode::ReadOnly, {"Bob"});
    CHECK(copy.record().units.size() == 3);
    CHECK(d.workspace.is_open());
}

TEST_CASE("Every kind of record can be listed, and a find changed, added and removed") {
    Day d;
    RecordsModel records(d.workspace);
    records.set_watched(true);
    for (const QString& kind : RecordsModel::kinds()) {
        INFO(kind.toStdString());
        records.set_kind(kind);
        settle(d.workspace);
        CHECK(d.failures.isEmpty());
        CHECK_FALSE(records.name_form().isEmpty());
    }
    records.set_kind(QStringLiteral("find"));
    settle(d.workspace);
    CHECK(records.names() == QStringList{QStringLiteral("7")});
    records.choose(QStringLiteral("7"));
    settle(d.workspace);
    records.set_field(QStringLiteral("material"), QStringLiteral("iron"));
    settle(d.workspace);
    CHECK(d.workspace.snapshot()->record().finds.front().material == "iron");
    records.add(QStringLiteral("8"));
    settle(d.workspace);
    CHECK(records.chosen() == QStringLiteral("8"));
    records.remove();
    settle(d.workspace);
    CHECK(records.names().size() == 1);
}

TEST_CASE("Today's lists name what is open, what may be dug and what sheets lack; a line selects its unit") {
    Day d;
    TodayModel today(d.workspace);
    today.set_watched(true);
    settle(d.workspace);
    CHECK(today.open().size() == 2); // the cut was excavated
    REQUIRE_FALSE(today.next().empty());
    CHECK(today.next().front().unit == QStringLiteral("1"));
    CHECK(today.next().front().text.contains(QStringLiteral("ashy fill")));
    CHECK_FALSE(today.sheets().empty());
    today.choose(QStringLiteral("3"));
    CHECK(d.workspace.snapshot()->index().name(d.workspace.selected()) == "3");
}

TEST_CASE("Edits go on while a long job works on a connection of its own, and both are kept") {
    Day d;
    const auto file = d.site.folder.write("units.csv", "unit,kind,title\n8,layer,hearth\n");
    d.day.import({file}, false);
    d.workspace.edit(QStringLiteral("typing"), [](app::Project& project, Progress&) {
        app::record_kind("unit").add(project, "9", {{"kind", "layer"}});
    });
    settle(d.workspace);
    settle(d.workspace);
    CHECK(d.failures.isEmpty());
    CHECK(d.workspace.snapshot()->record().units.size() == 5);
    CHECK(d.done.size() == 1);
}
