// SPDX-License-Identifier: MIT
#include "gui/widgets/space/contents_panel.hpp"

#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "gui/viewmodels/models.hpp"
#include "gui/viewmodels/space_model.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_application.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

TEST_CASE("Arrows and the space bar show a scan of another day, and a button follows the time line again") {
    test::ensure_application();
    const test::TemporaryFolder folder;
    (void)test::make_measured_days(folder, folder / "site.gpkg");
    Models models{app::Session{"Ada"}};
    SpaceModel space(models.workspace, models.time);
    ContentsPanel panel(space.contents());
    models.workspace.open(folder / "site.gpkg", store::OpenMode::ReadOnly);
    space.set_watched(true);
    settle(models.workspace);
    auto* tree = panel.findChild<QTreeView*>(QStringLiteral("spaceTree"));
    auto* follow = panel.findChild<QToolButton*>(QStringLiteral("spaceFollow"));
    REQUIRE(tree != nullptr);
    REQUIRE(follow != nullptr);
    panel.show();
    CHECK(tree->currentIndex() == space.contents().current()); // the day on which the time line stands, opened
    CHECK(tree->isExpanded(tree->currentIndex()));
    CHECK_FALSE(follow->isEnabled());
    QTest::keyClick(tree, Qt::Key_Home);
    QTest::keyClick(tree, Qt::Key_Right); // open
    QTest::keyClick(tree, Qt::Key_Down);  // to its scans
    CHECK(tree->currentIndex().data().toString() == QStringLiteral("Scans"));
    QTest::keyClick(tree, Qt::Key_Space);
    settle(models.workspace);
    CHECK(space.scans().size() == 2);
    CHECK(follow->isEnabled());
    follow->click();
    settle(models.workspace);
    CHECK(space.scans().size() == 1);
    CHECK_FALSE(follow->isEnabled());
}
