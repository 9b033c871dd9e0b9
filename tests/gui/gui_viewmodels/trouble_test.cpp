// SPDX-License-Identifier: MIT
#include "gui/viewmodels/models.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "app/records/record_kind.hpp"
#include "core/base/error.hpp"
#include "core/sqlite/database.hpp"
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
    QStringList notes;
    QObject::connect(&second, &Workspace::noted, [&](const QString& s) { notes << s; });
    for (Workspace* one : {&first, &second}) {
        CHECK(notes.isEmpty());
        QObject::connect(one, &Workspace::failed, [&](const QString& s) { failures << s; });
        one->open(site.file, store::OpenMode::ReadWrite);
        settle(*one);
    }
    REQUIRE(notes.size() == 1);
    CHECK(notes.front().contains(QStringLiteral("Another window")));
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

TEST_CASE("A full disk is a sentence, nothing is half written, and the window goes on when there is room again") {
    const test::GuiProject site;
    QStringList failures;
    Models models{app::Session{"Ada"}};
    Workspace& workspace = models.workspace;
    QObject::connect(&workspace, &Workspace::failed, [&](const QString& s) { failures << s; });
    workspace.open(site.file, store::OpenMode::ReadWrite);
    settle(workspace);
    {
        // No file of this process may grow any more, as on a disk without room.
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
        rlimit now = before;
        now.rlim_cur = static_cast<rlim_t>(std::filesystem::file_size(site.file)) + 8192;
        REQUIRE(setrlimit(RLIMIT_FSIZE, &now) == 0);
        workspace.edit(QStringLiteral("add many"), [](app::Project& project, Progress&) {
            project.change("Add many", [&] {
                for (int i = 100; i < 2100; ++i) {
                    model::StratigraphicUnit unit;
                    unit.number = std::to_string(i);
                    unit.description = std::string(200, 'x');
                    project.file().insert(unit);
                }
            });
        });
        settle(workspace);
        REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    }
    REQUIRE(failures.size() == 1);
    INFO(failures.front().toStdString());
    CHECK(failures.front().contains(QStringLiteral("disk")));
    REQUIRE(workspace.is_open());
    CHECK(workspace.snapshot()->record().units.size() == 3);
    workspace.edit(QStringLiteral("add"), adding("8"));
    settle(workspace);
    CHECK(failures.size() == 1);
    CHECK(workspace.snapshot()->record().units.size() == 4);
    app::Project project = site.reopened();
    CHECK(has(project, "8"));
    CHECK_FALSE(has(project, "100"));
    CHECK(project.file().verify(Progress::none()).empty());
}

TEST_CASE("What QGIS saves while the window is open is shown, and what the window enters meanwhile is kept") {
    const test::GuiProject site;
    QStringList failures;
    Models models{app::Session{"Ada"}};
    Workspace& workspace = models.workspace;
    QObject::connect(&workspace, &Workspace::failed, [&](const QString& s) { failures << s; });
    workspace.open(site.file, store::OpenMode::ReadWrite);
    settle(workspace);
    const auto title_of_3 = [&] {
        for (const auto& unit : workspace.snapshot()->record().units) {
            if (unit.number == "3") return unit.title;
        }
        return std::string();
    };
    const auto wait_for = [&](const std::string& title) {
        for (int i = 0; i < 1000 && title_of_3() != title; ++i) {
            QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return title_of_3() == title;
    };
    // As QGIS edits: a log of its own beside the file, and one transaction for what is saved at once.
    sqlite::Database qgis = sqlite::Database::open(site.file, sqlite::Access::ReadWrite);
    REQUIRE(qgis.text("PRAGMA journal_mode = WAL") == "wal");
    qgis.execute("BEGIN IMMEDIATE");
    qgis.execute("UPDATE unit SET title = 'clay floor, burnt' WHERE number = '3'");
    workspace.edit(QStringLiteral("add"), adding("8"));
    settle(workspace);
    REQUIRE(failures.size() == 1);
    INFO(failures.front().toStdString());
    CHECK(failures.front().contains(QStringLiteral("in use by another program")));
    qgis.execute("COMMIT");
    CHECK(wait_for("clay floor, burnt"));
    workspace.edit(QStringLiteral("add"), adding("8"));
    settle(workspace);
    CHECK(failures.size() == 1);
    qgis.execute("UPDATE unit SET title = 'clay floor, swept' WHERE number = '3'"); // saved a second time
    CHECK(wait_for("clay floor, swept"));
    const auto& units = workspace.snapshot()->record().units;
    CHECK(std::any_of(units.begin(), units.end(), [](const auto& one) { return one.number == "8"; }));
    app::Project project = site.reopened();
    CHECK(has(project, "8"));
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

TEST_CASE("That an edit could not be saved stands until one can, whatever is read meanwhile") {
    const test::GuiProject site;
    Workspace workspace{app::Session{"Ada"}};
    QStringList failures;
    QStringList over;
    QObject::connect(&workspace, &Workspace::failed, [&](const QString& s) { failures << s; });
    QObject::connect(&workspace, &Workspace::overcome, [&](const QString& s) { over << s; });
    workspace.open(site.file, store::OpenMode::ReadWrite);
    settle(workspace);
    workspace.edit(QStringLiteral("add"), [](app::Project&, Progress&) { throw Error(ErrorCode::Io, "no room"); });
    settle(workspace);
    REQUIRE(failures == QStringList{QStringLiteral("no room")});
    {
        app::Project another = app::Project::open(site.file, store::OpenMode::ReadWrite, {"Bob"});
        app::record_kind("unit").add(another, "70", {{"kind", "layer"}});
    }
    const auto read_again = [&] { return workspace.snapshot()->record().units.size() == 4; };
    for (int i = 0; i < 400 && !read_again(); ++i) {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    REQUIRE(read_again());
    CHECK(over.isEmpty());
    workspace.edit(QStringLiteral("add"), adding("71"));
    settle(workspace);
    CHECK(over == failures);
}

TEST_CASE("What cannot be saved stays in the card and the entry, and is saved when the file is back") {
    const test::GuiProject site;
    Models models{app::Session{"Ada"}};
    Workspace& workspace = models.workspace;
    workspace.open(site.file, store::OpenMode::ReadWrite);
    settle(workspace);
    int recorded = 0;
    QStringList failures;
    QStringList over;
    QObject::connect(&workspace, &Workspace::failed, [&](const QString& s) { failures << s; });
    QObject::connect(&workspace, &Workspace::overcome, [&](const QString& s) { over << s; });
    QObject::connect(&models.entry, &RelationEntryModel::committed, [&](const QString&) { ++recorded; });
    const auto enter = [&] {
        models.entry.set(RelationEntryModel::Part::Subject, QStringLiteral("1"));
        models.entry.set(RelationEntryModel::Part::Kind, QStringLiteral("covers"));
        models.entry.set(RelationEntryModel::Part::Object, QStringLiteral("3"));
        REQUIRE(models.entry.commit());
        settle(workspace);
    };
    const auto& units = workspace.snapshot()->record().units;
    workspace.select(std::find_if(units.begin(), units.end(), [](const auto& one) { return one.number == "3"; })->id);
    const std::filesystem::path elsewhere = site.folder / "elsewhere.gpkg";
    std::filesystem::rename(site.file, elsewhere);
    models.card.set_field("title", QStringLiteral("typed in the rain"));
    settle(workspace);
    enter();
    CHECK(recorded == 0);
    CHECK(models.entry.text(RelationEntryModel::Part::Object) == QStringLiteral("3"));
    REQUIRE(models.card.unsaved().size() == 1);
    CHECK(models.card.unsaved().front().startsWith(QStringLiteral("3: ")));
    const auto title = [&] {
        const auto& fields = models.card.fields();
        return *std::find_if(fields.begin(), fields.end(), [](const CardField& f) { return f.name == "title"; });
    };
    workspace.select({}); // another unit, and back
    workspace.select(std::find_if(units.begin(), units.end(), [](const auto& one) { return one.number == "3"; })->id);
    CHECK(title().value == QStringLiteral("typed in the rain"));
    CHECK(title().unsaved);
    std::filesystem::rename(elsewhere, site.file);
    for (int i = 0; i < 400 && !models.card.unsaved().isEmpty(); ++i) {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    CHECK(models.card.unsaved().isEmpty());
    CHECK_FALSE(title().unsaved);
    REQUIRE_FALSE(failures.isEmpty());
    REQUIRE_FALSE(over.isEmpty());
    CHECK(over.contains(failures.back())); // what was said of it holds no longer
    REQUIRE(models.entry.commit());
    settle(workspace);
    CHECK(recorded == 1);
    app::Project project = site.reopened();
    const auto& saved = project.record().units;
    CHECK(std::any_of(saved.begin(), saved.end(), [](const auto& one) { return one.title == "typed in the rain"; }));
    CHECK(project.record().relations.size() == 3);
}
