// SPDX-License-Identifier: MIT
#include <QAction>
#include <QDialog>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>

#include <functional>
#include <string>
#include <vector>

#include "gui/widgets/matrix/matrix_print.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "gui/widgets/window/notice_bar.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_application.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

// All that a person can press in the menus, submenus included, by the way to it.
void collect(const QMenu& menu, const QString& way, std::vector<std::pair<QString, QAction*>>& all) {
    for (QAction* action : menu.actions()) {
        if (action->isSeparator()) continue;
        const QString here = way + QStringLiteral(" › ") + action->text();
        if (action->menu() != nullptr) {
            emit action->menu()->aboutToShow();
            collect(*action->menu(), here, all);
        } else {
            all.emplace_back(here, action);
        }
    }
}

// Leaves every dialog that comes up, as somebody does who opened it by mistake; counts them.
class Leaver {
  public:
    Leaver() {
        timer_.setInterval(20);
        QObject::connect(&timer_, &QTimer::timeout, [this] {
            QWidget* dialog = QApplication::activeModalWidget();
            if (dialog == nullptr) return;
            ++left_;
            dialog->close();
        });
        timer_.start();
    }

    [[nodiscard]] int left() const noexcept { return left_; }

  private:
    QTimer timer_;
    int left_ = 0;
};

void close_dialogs(const MainWindow& window, int& closed) {
    for (QDialog* dialog : window.findChildren<QDialog*>()) {
        if (!dialog->isVisible()) continue;
        ++closed;
        dialog->close();
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

// Presses every action once. What ends in "…" asks something, or says why it cannot.
void press_everything(MainWindow& window) {
    std::vector<std::pair<QString, QAction*>> all;
    for (QAction* top : window.menuBar()->actions()) collect(*top->menu(), top->text(), all);
    REQUIRE(all.size() > 30);
    for (const auto& [way, action] : all) {
        if (action->objectName() == QStringLiteral("quit") || !action->isEnabled()) continue;
        if (action->text().startsWith(QLatin1Char('/'))) continue; // a recent project: that of another test, and gone
        const std::string name = way.toStdString();
        INFO(name);
        const bool asks = action->text().endsWith(QStringLiteral("…"));
        window.notice().hide();
        const Leaver leaver;
        action->trigger();
        settle(window.models().workspace);
        int closed = 0;
        close_dialogs(window, closed);
        if (asks) CHECK((leaver.left() + closed > 0 || !window.notice().isHidden()));
        CHECK(window.isVisible());
    }
}

} // namespace

TEST_CASE("Every action of the menus can be pressed, and left again, with a project open") {
    test::ensure_application();
    const test::GuiProject site;
    MainWindow window{app::Session{"Ada"}};
    window.open(site.file, store::OpenMode::ReadWrite);
    window.show();
    for (int i = 0; i < 2; ++i) settle(window.models().workspace);
    press_everything(window);
    REQUIRE(window.models().workspace.is_open());
    CHECK(window.models().workspace.snapshot()->record().units.size() == 3);
}

TEST_CASE("Every action of the menus can be pressed without a project") {
    test::ensure_application();
    MainWindow window{app::Session{"Ada"}};
    window.show();
    press_everything(window);
}

TEST_CASE("A drawing is printed on one page as long as its words stay readable, else on several that overlap") {
    const PrintPages small = pages_for(300.0, 200.0, 500.0, 700.0);
    CHECK(small.across == 1);
    CHECK(small.down == 1);
    CHECK(small.scale == Approx(1.0)); // never larger than it is
    const PrintPages shrunk = pages_for(800.0, 700.0, 500.0, 700.0);
    CHECK(shrunk.across == 1);
    CHECK(shrunk.scale == Approx(0.625));
    const PrintPages large = pages_for(3600.0, 1800.0, 500.0, 700.0);
    CHECK(large.scale == Approx(5.0 / 9.0));
    // 3600 pt × 5/9 = 2000 pt on pages of 500 pt of which 12 pt are seen twice: five; 1000 pt on 700 pt: two.
    CHECK(large.across == 5);
    CHECK(large.down == 2);
}
