// SPDX-License-Identifier: MIT
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QTranslator>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gui/viewmodels/models.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/view.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

constexpr int kTabletWidth = 1280;
constexpr int kTabletHeight = 800;

void ensure_application() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    if (QCoreApplication::instance() == nullptr) new QApplication(argc, argv);
}

// The longest words that the window has to find room for.
struct German {
    QTranslator translator;

    German() {
        ensure_application();
        if (translator.load(QStringLiteral(":/translations/planum_de.qm")))
            QCoreApplication::installTranslator(&translator);
    }

    ~German() {
        QCoreApplication::removeTranslator(&translator);
        apply_theme(ThemeKind::Light);
    }
};

struct Tablet {
    explicit Tablet(ThemeKind theme) {
        apply_theme(theme);
        {
            app::Project project = app::Project::open(site.file, store::OpenMode::ReadWrite, {"Ada"});
            for (const char* day : {"2025-06-01", "2025-06-02"}) // for a time line
                app::record_kind("surface").add(project, day, {{"area", "A"}, {"first-day", day}});
        }
        window = std::make_unique<MainWindow>(app::Session{"Ada"});
        window->open(site.file, store::OpenMode::ReadWrite);
        window->resize(kTabletWidth, kTabletHeight);
        window->show();
        for (int round = 0; round < 3; ++round) settle(window->models().workspace);
        for (const ViewEntry& entry : all_views()) {
            if (entry.name == "3d") continue; // no OpenGL here
            window->show_view(entry.name);
            settle(window->models().workspace);
        }
    }

    test::GuiProject site;
    std::unique_ptr<MainWindow> window;
};

enum class Side { Width, Height };

// The widgets that want most room, for whoever has to mend it.
std::string largest(const QWidget& window, Side side) {
    std::vector<std::pair<int, std::string>> all;
    for (const QWidget* one : window.findChildren<QWidget*>()) {
        // Tabs that lie behind count as well.
        if (!one->isHidden() || qobject_cast<const QStackedWidget*>(one->parentWidget()) != nullptr)
            all.emplace_back(side == Side::Width ? one->minimumSizeHint().width() : one->minimumSizeHint().height(),
                             std::string(one->metaObject()->className()) + " " + one->objectName().toStdString());
    }
    std::sort(all.rbegin(), all.rend());
    std::string said;
    for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 24); ++i)
        said += std::to_string(all[i].first) + " " + all[i].second + "\n";
    return said;
}

} // namespace

TEST_CASE("The German window fits a tablet in every theme") {
    const German german;
    for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::Sunlight}) {
        const Tablet tablet(theme);
        INFO(to_word(theme).toStdString() << "\n"
                                          << largest(*tablet.window, Side::Width) << "\n"
                                          << largest(*tablet.window, Side::Height));
        CHECK(tablet.window->minimumSizeHint().width() <= kTabletWidth);
        CHECK(tablet.window->minimumSizeHint().height() <= kTabletHeight);
        CHECK(tablet.window->width() == kTabletWidth);
        CHECK(tablet.window->height() == kTabletHeight);
    }
}

TEST_CASE("In the sun everything that is pressed is as high as a finger needs") {
    const German german;
    const Tablet tablet(ThemeKind::Sunlight);
    int seen = 0;
    for (const QWidget* one : tablet.window->findChildren<QWidget*>()) {
        const bool pressed =
            qobject_cast<const QPushButton*>(one) != nullptr || qobject_cast<const QComboBox*>(one) != nullptr ||
            qobject_cast<const QLineEdit*>(one) != nullptr || qobject_cast<const QTabBar*>(one) != nullptr;
        const bool part_of_another = qobject_cast<const QComboBox*>(one->parentWidget()) != nullptr;
        if (!pressed || part_of_another || !one->isVisible()) continue;
        INFO(one->metaObject()->className() << " " << one->objectName().toStdString());
        CHECK(one->height() >= theme().touch - 2);
        ++seen;
    }
    CHECK(seen > 10);
}

TEST_CASE("A button that cannot be pressed looks otherwise than one that can, also in the sun") {
    ensure_application();
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::Sunlight}) {
        apply_theme(kind);
        QPushButton button(QStringLiteral("Register"));
        button.resize(160, 44);
        const QImage live = button.grab().toImage();
        button.setEnabled(false);
        const QImage dead = button.grab().toImage();
        int differing = 0;
        for (int y = 0; y < live.height(); ++y) {
            for (int x = 0; x < live.width(); ++x) differing += live.pixel(x, y) != dead.pixel(x, y) ? 1 : 0;
        }
        INFO(to_word(kind).toStdString());
        CHECK(differing > 150); // the words and the edge
        CHECK(theme().off != theme().ink);
    }
    apply_theme(ThemeKind::Light);
}

TEST_CASE("Below the hint of a card without a unit there is no ground of another colour") {
    ensure_application();
    apply_theme(ThemeKind::Dark);
    const Tablet tablet(ThemeKind::Dark);
    const QWidget* card = tablet.window->view("card");
    REQUIRE(card != nullptr);
    const auto* scroll = card->findChild<QScrollArea*>();
    REQUIRE(scroll != nullptr);
    CHECK_FALSE(scroll->isVisible());
    const QImage shown = const_cast<QWidget*>(card)->grab().toImage();
    CHECK(shown.pixelColor(shown.width() / 2, shown.height() - 20).lightnessF() < 0.3);
    apply_theme(ThemeKind::Light);
}
