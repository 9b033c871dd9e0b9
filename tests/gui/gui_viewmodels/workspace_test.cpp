// SPDX-License-Identifier: MIT
#include "gui/viewmodels/workspace.hpp"

#include <QEventLoop>
#include <QStringList>
#include <QTimer>

#include <atomic>
#include <filesystem>
#include <thread>
#include <vector>

#include "app/records/record_kind.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::GuiProject;
using test::settle;

namespace {

struct Open {
    GuiProject site;
    Workspace workspace{app::Session{"Ada"}};
    QStringList failures;

    explicit Open(store::OpenMode mode = store::OpenMode::ReadWrite) {
        QObject::connect(&workspace, &Workspace::failed, [this](const QString& s) { failures << s; });
        workspace.open(site.file, mode);
        settle(workspace);
    }
};

void add_unit(Workspace& workspace, const std::string& number) {
    workspace.edit(QStringLiteral("add"),
                   [number](app::Project& project, Progress&) { app::record_kind("unit").add(project, number, {}); });
}

} // namespace

TEST_CASE("A workspace opens a project in a thread and shows its record") {
    const Open open;
    REQUIRE(open.workspace.is_open());
    CHECK(open.failures.isEmpty());
    CHECK(open.workspace.snapshot()->record().units.size() == 3);
}

TEST_CASE("A file that is no project is one sentence, and nothing is open") {
    test::ensure_core_application();
    test::TemporaryFolder folder;
    Workspace workspace;
    QStringList failures;
    QObject::connect(&workspace, &Workspace::failed, [&](const QString& s) { failures << s; });
    workspace.open(folder.write("x.gpkg", "no database at all"), store::OpenMode::ReadWrite);
    settle(workspace);
    CHECK_FALSE(workspace.is_open());
    CHECK(failures.size() == 1);
}

TEST_CASE("What is edited is on disk at once, and undo and redo say what they do") {
    Open open;
    add_unit(open.workspace, "4");
    settle(open.workspace);
    CHECK(open.site.reopened().record().units.size() == 4);
    CHECK(open.workspace.undo_label() == QStringLiteral("Add unit 4"));
    CHECK(open.workspace.redo_label().isEmpty());
    open.workspace.undo();
    settle(open.workspace);
    CHECK(open.workspace.snapshot()->record().units.size() == 3);
    CHECK(open.workspace.redo_label() == QStringLiteral("Add unit 4"));
    open.workspace.redo();
    settle(open.workspace);
    CHECK(open.workspace.snapshot()->record().units.size() == 4);
    CHECK(open.workspace.redo_label().isEmpty());
}

TEST_CASE("What was taken back and overtaken by another change is not offered again") {
    Open open;
    add_unit(open.workspace, "4");
    settle(open.workspace);
    open.workspace.undo();
    settle(open.workspace);
    add_unit(open.workspace, "5");
    settle(open.workspace);
    CHECK(open.workspace.redo_label().isEmpty());
    CHECK(open.workspace.undo_label() == QStringLiteral("Add unit 5"));
}

TEST_CASE("An edit that cannot be done is one sentence and changes nothing") {
    Open open;
    add_unit(open.workspace, "1");
    settle(open.workspace);
    REQUIRE(open.failures.size() == 1);
    CHECK(open.failures.front().contains(QLatin1Char('1')));
    CHECK(open.workspace.snapshot()->record().units.size() == 3);
}

TEST_CASE("Opened for reading only, nothing can be changed and it says why") {
    Open open(store::OpenMode::ReadOnly);
    add_unit(open.workspace, "4");
    settle(open.workspace);
    CHECK(open.failures.size() == 1);
    CHECK(open.site.reopened().record().units.size() == 3);
}

TEST_CASE("Another program's change is noticed") {
    Open open;
    int notes = 0;
    QObject::connect(&open.workspace, &Workspace::noted, [&](const QString&) { ++notes; });
    {
        app::Project other = app::Project::open(open.site.file, store::OpenMode::ReadWrite, {"Bob"});
        app::record_kind("unit").add(other, "9", {});
    }
    for (int i = 0; i < 100 && notes == 0; ++i) {
        QEventLoop loop;
        QTimer::singleShot(50, &loop, &QEventLoop::quit);
        loop.exec();
        settle(open.workspace);
    }
    CHECK(notes == 1);
    CHECK(open.workspace.snapshot()->record().units.size() == 4);
}

TEST_CASE("A file that is taken away is one sentence, and what was read stays to be seen") {
    Open open;
    std::filesystem::remove(open.site.file);
    for (int i = 0; i < 100 && open.failures.isEmpty(); ++i) {
        QEventLoop loop;
        QTimer::singleShot(50, &loop, &QEventLoop::quit);
        loop.exec();
    }
    CHECK(open.failures.size() == 1);
    CHECK(open.workspace.is_open());
}

TEST_CASE("An edit right after another program wrote takes nothing of that back") {
    Open open;
    {
        app::Project other = app::Project::open(open.site.file, store::OpenMode::ReadWrite, {"Bob"});
        app::record_kind("unit").set(other, "3", {{"title", "burnt floor"}});
    }
    open.workspace.edit(QStringLiteral("edit"), [](app::Project& project, Progress&) {
        app::record_kind("unit").set(project, "3", {{"status", "excavated"}});
    });
    settle(open.workspace);
    CHECK(open.failures.isEmpty());
    const auto& snapshot = *open.workspace.snapshot();
    const model::StratigraphicUnit& unit = snapshot.record().units[snapshot.index().named("3").front()];
    CHECK(unit.title == "burnt floor");
    CHECK(unit.status == model::UnitStatus::Excavated);
}

TEST_CASE("A newer reading replaces the older one of its lane") {
    Open open;
    std::atomic<bool> first_ran_to_its_end = false;
    std::vector<int> outcomes;
    open.workspace.read(QStringLiteral("test"), {}, [&](app::Project&, Progress& progress) -> JobRunner::Done {
        while (!progress.stop_token().stop_requested()) std::this_thread::yield();
        first_ran_to_its_end = true;
        return [&] { outcomes.push_back(1); };
    });
    open.workspace.read(QStringLiteral("test"), {},
                        [&](app::Project&, Progress&) -> JobRunner::Done { return [&] { outcomes.push_back(2); }; });
    settle(open.workspace);
    CHECK(outcomes == std::vector<int>{2});
}

TEST_CASE("Closing while a job runs stops it and leaves the project as it was") {
    GuiProject site;
    {
        Workspace workspace{app::Session{"Ada"}};
        workspace.open(site.file, store::OpenMode::ReadWrite);
        settle(workspace);
        workspace.edit(QStringLiteral("long"), [](app::Project& project, Progress& progress) {
            project.change("Add many", [&] {
                model::StratigraphicUnit unit;
                unit.number = "77";
                project.file().insert(unit);
                while (true) progress.check(); // until somebody closes the window
            });
        });
        QCoreApplication::processEvents();
    }
    CHECK(site.reopened().record().units.size() == 3);
}

TEST_CASE("A lane that is cancelled says nothing, neither what ran nor what waited, and others go on") {
    Open open;
    std::atomic<bool> runs = false;
    std::vector<int> outcomes;
    JobRunner& jobs = open.workspace.jobs();
    const auto start = [&](const QString& lane, JobRunner::Work work) {
        jobs.start(lane, JobRunner::Queueing::InOrder, {}, Job::Kind::Quiet, std::move(work),
                   [&](const QString& sentence) { open.failures << sentence; });
    };
    start(QStringLiteral("given up"), [&](Progress& progress) -> JobRunner::Done {
        runs = true;
        while (!progress.stop_token().stop_requested()) std::this_thread::yield();
        return [&] { outcomes.push_back(1); };
    });
    start(QStringLiteral("given up"), [&](Progress&) -> JobRunner::Done { return [&] { outcomes.push_back(2); }; });
    start(QStringLiteral("other"), [&](Progress&) -> JobRunner::Done { return [&] { outcomes.push_back(3); }; });
    while (!runs) std::this_thread::yield();
    jobs.cancel(QStringLiteral("given up"));
    jobs.cancel(QStringLiteral("never heard of"));
    settle(open.workspace);
    CHECK(outcomes == std::vector<int>{3});
    CHECK(open.failures.isEmpty());
    start(QStringLiteral("given up"), [&](Progress&) -> JobRunner::Done { return [&] { outcomes.push_back(4); }; });
    settle(open.workspace);
    CHECK(outcomes == std::vector<int>{3, 4});
}
