// SPDX-License-Identifier: MIT
#include "gui/viewmodels/models.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "app/records/record_kind.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

Workspace::Edit adding(const char* unit) {
    return [unit](app::Project& project, Progress&) {
        app::record_kind("unit").add(project, unit, {{"kind", "layer"}});
    };
}

bool has(app::Project& project, const char* unit) {
    const auto& units = project.record().units;
    return std::any_of(units.begin(), units.end(), [&](const auto& one) { return one.number == unit; });
}

} // namespace

TEST_CASE("Two windows on one project keep what either enters") {
    const test::GuiProject site;
    Workspace first{app::Session{"Ada"}};
    Workspace second{app::Session{"Bob"}};
    QStringList failures;
    for (Workspace* one : {&first, &second}) {
        QObject::connect(one, &Workspace::failed, [&](const QString& s) { failures << s; });
        one->open(site.file, store::OpenMode::ReadWrite);
        settle(*one);
    }
    first.edit(QStringLiteral("add"), adding("8"));
    settle(first);
    second.edit(QStringLiteral("add"), adding("9"));
    settle(second);
    first.edit(QStringLiteral("add"), adding("10"));
    settle(first);
    INFO(failures.join(QLatin1Char('\n')).toStdString());
    CHECK(failures.isEmpty());
    app::Project project = site.reopened();
    for (const char* unit : {"1", "8", "9", "10"}) CHECK(has(project, unit));
}

TEST_CASE("A window that closes during a job leaves the project as it was before the job, and sound") {
    const test::GuiProject site;
    std::atomic<bool> began = false;
    {
        std::optional<Models> models(std::in_place, app::Session{"Ada"});
        models->workspace.open(site.file, store::OpenMode::ReadWrite);
        settle(models->workspace);
        models->workspace.edit(QStringLiteral("add"), adding("8"));
        settle(models->workspace);
        models->workspace.work(QStringLiteral("long"), [&began](app::Project& project, Progress& progress) {
            project.change("half a job", [&] {
                model::StratigraphicUnit unit;
                unit.number = "99";
                project.file().insert(unit);
                began = true;
                for (;;) {
                    progress.check();
                    std::this_thread::yield();
                }
            });
        });
        while (!began) std::this_thread::yield();
    }
    app::Project project = site.reopened();
    CHECK(has(project, "8"));
    CHECK_FALSE(has(project, "99"));
    CHECK(project.file().verify(Progress::none()).empty());
}

TEST_CASE("A window that closes while the surfaces are compared ends at once") {
    const test::GuiProject application;
    const test::TemporaryFolder folder;
    static_cast<void>(test::make_measured_days(folder, folder / "site.gpkg"));
    {
        Models models{app::Session{"Ada"}};
        models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadWrite);
        while (!models.workspace.is_open()) QCoreApplication::processEvents();
        CHECK(models.problems.is_comparing_surfaces());
    }
    app::Project project = app::Project::open(folder / "site.gpkg", store::OpenMode::ReadOnly, {"Bob"});
    CHECK(project.file().verify(Progress::none()).empty());
}
