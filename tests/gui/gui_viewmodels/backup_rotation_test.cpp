// SPDX-License-Identifier: MIT
#include "gui/viewmodels/backup_rotation.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

TEST_CASE("Of many copies the newest of each hour, day and week stay, and the newest of all") {
    QStringList names;
    const QDateTime start(QDate(2025, 3, 1), QTime(8, 0));
    for (int i = 0; i < 24 * 4 * 100; ++i)
        names << start.addSecs(900LL * i).toString(QStringLiteral("yyyy-MM-ddTHHmm"));
    const QStringList gone = superfluous_backups(names);
    CHECK_FALSE(gone.contains(names.back()));
    const auto kept = names.size() - gone.size();
    CHECK(kept >= 24 + 12);
    CHECK(kept <= 24 + 14 + 8);
    QStringList left;
    for (const QString& name : names) {
        if (!gone.contains(name)) left << name;
    }
    CHECK(superfluous_backups(left).isEmpty());
    CHECK(superfluous_backups({QStringLiteral("my own copy")}).isEmpty());
}

TEST_CASE("A changed project gets a copy when it is opened, and one an hour while it changes") {
    test::GuiProject site;
    const test::TemporaryFolder root;
    QDateTime now(QDate(2025, 6, 1), QTime(8, 0));
    Workspace workspace{app::Session{"Ada"}};
    BackupRotation rotation(workspace, root.path(), [&] { return now; });
    const auto copies = [&] {
        const std::filesystem::directory_iterator all(rotation.folder());
        return std::distance(std::filesystem::begin(all), std::filesystem::end(all));
    };
    const auto change = [&](const char* number) {
        workspace.edit(QStringLiteral("typing"), [number](app::Project& project, Progress&) {
            app::record_kind("unit").add(project, number, {});
        });
        settle(workspace);
        settle(workspace);
    };
    workspace.open(site.file, store::OpenMode::ReadWrite);
    settle(workspace);
    settle(workspace);
    CHECK(copies() == 1);
    change("8");
    CHECK(copies() == 1); // within the hour
    now = now.addSecs(2 * 3600);
    change("9");
    CHECK(copies() == 2);
    app::Project copy =
        app::Project::open(rotation.folder() / "2025-06-01T1000.gpkg", store::OpenMode::ReadOnly, {"Bob"});
    CHECK(copy.record().units.size() == 5);
}
