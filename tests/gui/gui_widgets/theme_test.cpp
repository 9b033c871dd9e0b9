// SPDX-License-Identifier: MIT
#include <QApplication>
#include <QDockWidget>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <memory>
#include <vector>

#include "gui/viewmodels/models.hpp"
#include "gui/widgets/styled_parts.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/view.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_application.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::ensure_application;
using test::settle;

namespace {

constexpr int kTurns = 300; // of the event loop: more than there are parts

std::unique_ptr<MainWindow> opened(const test::GuiProject& site) {
    auto window = std::make_unique<MainWindow>(app::Session{"Ada"});
    window->open(site.file, store::OpenMode::ReadOnly);
    window->resize(1400, 900);
    window->show();
    for (int round = 0; round < 3; ++round) settle(window->models().workspace);
    return window;
}

void look_at(MainWindow& window, const ViewEntry& entry) {
    window.show_view(entry.name);
    settle(window.models().workspace);
}

void change_theme(ThemeKind kind) {
    apply_theme(kind, StyledParts::Pace::InTurns);
    for (int turn = 0; turn < kTurns; ++turn) QApplication::processEvents();
}

// Where two pictures differ, or an empty rectangle.
QRect difference(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return a.rect();
    QRect all;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (a.pixel(x, y) != b.pixel(x, y)) all |= QRect(x, y, 1, 1);
        }
    }
    return all;
}

struct LightAgain {
    ~LightAgain() { apply_theme(ThemeKind::Light); }
};

} // namespace

TEST_CASE("A theme that is chosen while the window is open looks as if it had opened in it") {
    ensure_application();
    const LightAgain afterwards;
    const test::GuiProject site;
    auto window = opened(site);
    for (const ViewEntry& entry : all_views()) look_at(*window, entry);
    change_theme(ThemeKind::Dark);
    std::vector<QImage> changed;
    for (const ViewEntry& entry : all_views()) {
        look_at(*window, entry);
        changed.push_back(window->grab().toImage());
    }
    window.reset();
    window = opened(site);
    for (const ViewEntry& entry : all_views()) look_at(*window, entry);
    for (std::size_t i = 0; i < all_views().size(); ++i) {
        look_at(*window, all_views()[i]);
        const QRect where = difference(changed[i], window->grab().toImage());
        INFO(all_views()[i].name << ": from " << where.x() << ", " << where.y() << ", " << where.width() << " x "
                                 << where.height());
        CHECK(where.isEmpty());
    }
}

TEST_CASE("Rows are as high as a finger needs, and letters as large, when the sun comes out") {
    ensure_application();
    const LightAgain afterwards;
    const test::GuiProject site;
    const auto window = opened(site);
    const auto* table = window->findChild<QTableView*>(QStringLiteral("unitTable"));
    REQUIRE(table != nullptr);
    const int before = table->verticalHeader()->defaultSectionSize();
    const auto* tabs = window->findChild<QTabWidget*>();
    REQUIRE(tabs != nullptr);
    CHECK(tabs->styleSheet().isEmpty());
    change_theme(ThemeKind::Sunlight);
    CHECK(table->verticalHeader()->defaultSectionSize() >= theme().touch - 2);
    for (const QWidget* one : window->findChildren<QWidget*>()) {
        INFO(one->metaObject()->className() << " " << one->objectName().toStdString());
        CHECK(one->font().pointSizeF() >= theme().text_points); // headings are larger
    }
    change_theme(ThemeKind::Light);
    CHECK(table->verticalHeader()->defaultSectionSize() == before);
}

TEST_CASE("Titles of docks are written as large as the theme writes") {
    ensure_application();
    const LightAgain afterwards;
    const test::GuiProject site;
    const auto title = [](MainWindow& window) {
        auto* dock = window.findChild<QDockWidget*>(QStringLiteral("dock_units"));
        return dock->grab(QRect(0, 0, 100, 24)).toImage();
    };
    auto window = opened(site);
    change_theme(ThemeKind::Sunlight);
    const QImage changed = title(*window);
    window.reset();
    window = opened(site);
    CHECK(difference(changed, title(*window)).isEmpty());
}

TEST_CASE("Widgets that were asked for their size before they had a place take the sheet of where they stand") {
    ensure_application();
    const LightAgain afterwards;
    auto* inner = new QPushButton(QStringLiteral("Add"));
    (void)inner->sizeHint(); // a part for now
    CHECK_FALSE(inner->styleSheet().isEmpty());
    QWidget whole;
    auto* column = new QVBoxLayout(&whole);
    column->addWidget(inner);
    whole.show();
    CHECK(inner->styleSheet().isEmpty());
    CHECK_FALSE(whole.styleSheet().isEmpty());
    const QString former = whole.styleSheet();
    change_theme(ThemeKind::Dark);
    CHECK(whole.styleSheet() != former);
}

TEST_CASE("What is marked to be in parts has no sheet, each of its children one") {
    ensure_application();
    QWidget whole;
    StyledParts::in_parts(whole);
    auto* column = new QVBoxLayout(&whole);
    auto* left = new QLabel(QStringLiteral("left"));
    auto* right = new QLabel(QStringLiteral("right"));
    column->addWidget(left);
    column->addWidget(right);
    whole.show();
    CHECK(whole.styleSheet().isEmpty());
    CHECK_FALSE(left->styleSheet().isEmpty());
    CHECK(left->styleSheet() == right->styleSheet());
}
