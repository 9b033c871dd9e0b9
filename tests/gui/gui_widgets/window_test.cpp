// SPDX-License-Identifier: MIT
#include "gui/widgets/window/main_window.hpp"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCompleter>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <set>

#include "gui/widgets/matrix/matrix_canvas.hpp"
#include "gui/widgets/matrix/matrix_view.hpp"
#include "gui/widgets/problems/problem_panel.hpp"
#include "gui/widgets/problems/proof_picture.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/view.hpp"
#include "gui/widgets/window/notice_bar.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/gui_project.hpp"
#include "tests/support/measured_days.hpp"

using namespace planum;
using namespace planum::gui;
using test::settle;

namespace {

void ensure_application() {
    static int argc = 1;
    static char name[] = "test";
    static char* argv[] = {name, nullptr};
    if (QCoreApplication::instance() == nullptr) new QApplication(argc, argv);
    apply_theme(ThemeKind::Light);
}

struct Shown {
    Shown() {
        window.open(site.file, store::OpenMode::ReadWrite);
        window.show();
        settle(window.models().workspace);
        settle(window.models().workspace); // what showing asked for
    }

    template<class Widget>
    Widget* find(const char* name) {
        auto* widget = window.findChild<Widget*>(QString::fromLatin1(name));
        REQUIRE(widget != nullptr);
        return widget;
    }

    void settle_all() {
        settle(window.models().workspace);
        settle(window.models().workspace);
    }

    [[nodiscard]] std::string selected() {
        Workspace& workspace = window.models().workspace;
        return workspace.selected().is_nil() ? "" : workspace.snapshot()->index().name(workspace.selected());
    }

    struct First {
        First() { ensure_application(); }
    } first;

    test::GuiProject site;
    MainWindow window{app::Session{"Ada"}};
};

} // namespace

TEST_CASE("Typing a number in the list and Enter selects the unit everywhere") {
    Shown shown;
    auto* search = shown.find<QLineEdit>("unitSearch");
    QTest::keyClicks(search, QStringLiteral("2"));
    QTest::keyClick(search, Qt::Key_Return);
    shown.settle_all();
    CHECK(shown.selected() == "2");
    CHECK(shown.find<QLabel>("cardTitle")->text().contains(QLatin1Char('2')));
    auto* matrix = dynamic_cast<MatrixView*>(shown.window.view("matrix"));
    REQUIRE(matrix != nullptr);
    CHECK(matrix->model().selected_box().has_value());
}

TEST_CASE("A relation is entered by keys alone: number, Enter, kind, Enter, number, Enter") {
    Shown shown;
    auto* subject = shown.find<QLineEdit>("relationSubject");
    auto* kind = shown.find<QLineEdit>("relationKind");
    auto* object = shown.find<QLineEdit>("relationObject");
    subject->clear();
    QTest::keyClicks(subject, QStringLiteral("1"));
    QTest::keyClick(subject, Qt::Key_Return);
    QTest::keyClicks(kind, QStringLiteral("co"));
    QTest::keyClick(kind, Qt::Key_Return);
    CHECK(kind->text() == QStringLiteral("covers"));
    QTest::keyClicks(object, QStringLiteral("3"));
    QTest::keyClick(object, Qt::Key_Return);
    shown.settle_all();
    CHECK(shown.window.models().workspace.snapshot()->record().relations.size() == 3);
    CHECK(object->text().isEmpty());
    CHECK(subject->text() == QStringLiteral("1"));
}

TEST_CASE("Enter goes on also while the list of completions is open, which then has the keys") {
    Shown shown;
    const auto enter = [](QLineEdit* field, const QString& text) {
        field->clear();
        QTest::keyClicks(field, text);
        field->completer()->popup()->show();
        QTest::keyClick(field->completer()->popup(), Qt::Key_Return);
        CHECK_FALSE(field->completer()->popup()->isVisible());
    };
    enter(shown.find<QLineEdit>("relationSubject"), QStringLiteral("1"));
    enter(shown.find<QLineEdit>("relationKind"), QStringLiteral("co"));
    CHECK(shown.find<QLineEdit>("relationKind")->text() == QStringLiteral("covers"));
    enter(shown.find<QLineEdit>("relationObject"), QStringLiteral("3"));
    shown.settle_all();
    CHECK(shown.window.models().workspace.snapshot()->record().relations.size() == 3);
}

TEST_CASE("A text that is only looked at takes back nothing that another program wrote; a half typed one stays") {
    Shown shown;
    QTest::keyClicks(shown.find<QLineEdit>("unitSearch"), QStringLiteral("3"));
    QTest::keyClick(shown.find<QLineEdit>("unitSearch"), Qt::Key_Return);
    shown.settle_all();
    Workspace& workspace = shown.window.models().workspace;
    const auto write_elsewhere = [&](const char* field, const char* value) {
        workspace.edit(QStringLiteral("elsewhere"), [field, value](app::Project& project, Progress&) {
            app::record_kind("unit").set(project, "3", {{field, value}});
        });
        for (int i = 0; i < 5; ++i) shown.settle_all();
    };
    const auto description = [&] { return shown.find<QPlainTextEdit>("field_description"); };
    shown.window.activateWindow();
    description()->setFocus();
    write_elsewhere("description", "set elsewhere");
    const std::size_t changes = workspace.snapshot()->changes.size();
    CHECK(description()->toPlainText() == QStringLiteral("set elsewhere"));
    for (int i = 0; i < 10; ++i) shown.settle_all();
    CHECK(workspace.snapshot()->changes.size() == changes); // nothing was written back
    description()->setFocus();
    QTest::keyClicks(description(), QStringLiteral("typed "));
    write_elsewhere("title", "another title");
    CHECK(description()->toPlainText() == QStringLiteral("typed set elsewhere"));
    description()->clearFocus();
    for (int i = 0; i < 5; ++i) shown.settle_all();
    const auto& units = workspace.snapshot()->record().units;
    CHECK(std::any_of(units.begin(), units.end(),
                      [](const auto& unit) { return unit.description == "typed set elsewhere"; }));
}

TEST_CASE("The search field keeps the keys when another unit comes into the card") {
    Shown shown;
    auto* search = shown.find<QLineEdit>("unitSearch");
    const auto go_to = [&](const char* unit) {
        search->setFocus();
        search->clear();
        QTest::keyClicks(search, QString::fromLatin1(unit));
        QTest::keyClick(search, Qt::Key_Return);
        shown.settle_all();
    };
    shown.window.activateWindow();
    go_to("3");
    shown.find<QLineEdit>("field_title")->setFocus();
    go_to("1");
    CHECK(shown.window.focusWidget() == search);
    shown.find<QPlainTextEdit>("field_description")->setFocus();
    go_to("3");
    CHECK(shown.window.focusWidget() == search);
}

TEST_CASE("A click on a box selects its unit; a drag to another box wants a relation") {
    Shown shown;
    auto* matrix = dynamic_cast<MatrixView*>(shown.window.view("matrix"));
    REQUIRE(matrix != nullptr);
    REQUIRE(matrix->model().drawing() != nullptr);
    MatrixCanvas& canvas = matrix->canvas();
    const QPoint first = canvas.box_on_screen(0).center().toPoint();
    const QPoint second = canvas.box_on_screen(1).center().toPoint();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, first);
    CHECK(shown.selected() == matrix->model().drawing()->boxes[0].names.front());
    QSignalSpy wanted(&canvas, &MatrixCanvas::relationWanted);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, first);
    QTest::mouseMove(&canvas, second);
    QMouseEvent move(QEvent::MouseMove, second, canvas.mapToGlobal(second), Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, second);
    CHECK(wanted.count() == 1);
}

TEST_CASE("Opening a problem shows its proof in the matrix, and an action asks for a reason") {
    Shown shown;
    shown.window.models().entry.set(RelationEntryModel::Part::Subject, QStringLiteral("3"));
    shown.window.models().entry.set(RelationEntryModel::Part::Kind, QStringLiteral("covers"));
    shown.window.models().entry.set(RelationEntryModel::Part::Object, QStringLiteral("1"));
    shown.window.models().entry.commit();
    shown.settle_all();
    auto* list = shown.find<QListView>("problemList");
    list->setCurrentIndex(list->model()->index(0, 0));
    auto* matrix = dynamic_cast<MatrixView*>(shown.window.view("matrix"));
    CHECK(matrix->model().proof_boxes().size() == 3);
    CHECK(matrix->model().proof_lines().size() == 3);
    auto* panel = dynamic_cast<ProblemPanel*>(shown.window.view("problems"));
    REQUIRE(panel != nullptr);
    QString asked;
    panel->set_ask([&](QWidget*, const QString& what, const QString&) {
        asked = what;
        return ReasonAnswer{QStringLiteral("known undercut"), {}};
    });
    QTest::mouseClick(shown.find<QPushButton>("acceptProblem"), Qt::LeftButton);
    shown.settle_all();
    CHECK_FALSE(asked.isEmpty());
    CHECK(shown.window.models().problems.check().accepted.size() == 1);
}

TEST_CASE("What cannot be done is said in the window and does not stop it") {
    Shown shown;
    auto* number = shown.find<QLineEdit>("newUnit");
    QTest::keyClicks(number, QStringLiteral("1"));
    QTest::keyClick(number, Qt::Key_Return);
    shown.settle_all();
    CHECK_FALSE(shown.window.notice().isHidden());
    CHECK_FALSE(shown.window.notice().sentence().isEmpty());
}

TEST_CASE("A notice goes when what it says is over, and undo says what it took back") {
    Shown shown;
    const auto elsewhere = shown.site.folder / "elsewhere.gpkg";
    std::filesystem::rename(shown.site.file, elsewhere);
    auto* number = shown.find<QLineEdit>("newUnit");
    QTest::keyClicks(number, QStringLiteral("77"));
    QTest::keyClick(number, Qt::Key_Return);
    shown.settle_all();
    REQUIRE_FALSE(shown.window.notice().isHidden());
    std::filesystem::rename(elsewhere, shown.site.file);
    number->clear();
    QTest::keyClicks(number, QStringLiteral("78"));
    QTest::keyClick(number, Qt::Key_Return);
    shown.settle_all();
    CHECK(shown.window.notice().isHidden());
    shown.find<QAction>("undo")->trigger();
    shown.settle_all();
    CHECK(shown.window.statusBar()->currentMessage().contains(QStringLiteral("Add unit 78")));
}

// Where the keys go cannot be seen here: without a screen every list of completions takes the window's activity away.
TEST_CASE("A relation that could not be saved stands in the entry again, and Enter on it is enough") {
    Shown shown;
    auto* subject = shown.find<QLineEdit>("relationSubject");
    auto* kind = shown.find<QLineEdit>("relationKind");
    auto* object = shown.find<QLineEdit>("relationObject");
    QSignalSpy back(&shown.window.models().entry, &RelationEntryModel::cameBack);
    const auto elsewhere = shown.site.folder / "elsewhere.gpkg";
    std::filesystem::rename(shown.site.file, elsewhere);
    subject->clear();
    QTest::keyClicks(subject, QStringLiteral("1"));
    QTest::keyClick(subject, Qt::Key_Return);
    QTest::keyClicks(kind, QStringLiteral("covers"));
    QTest::keyClick(kind, Qt::Key_Return);
    QTest::keyClicks(object, QStringLiteral("3"));
    QTest::keyClick(object, Qt::Key_Return);
    shown.settle_all();
    CHECK(back.size() == 1);
    CHECK(object->text() == QStringLiteral("3"));
    std::filesystem::rename(elsewhere, shown.site.file);
    QTest::keyClick(object, Qt::Key_Return);
    shown.settle_all();
    CHECK(back.size() == 1);
    CHECK(shown.window.models().workspace.snapshot()->record().relations.size() == 3);
}

TEST_CASE("A view alone has the whole window; a panel that is asked for brings the others back") {
    Shown shown;
    const auto visible = [&] {
        const auto docks = shown.window.findChildren<QDockWidget*>();
        return std::count_if(docks.begin(), docks.end(), [](const QDockWidget* dock) { return dock->isVisible(); });
    };
    REQUIRE(visible() > 2);
    const auto before = visible();
    shown.find<QAction>("viewAlone")->trigger();
    CHECK(visible() == 0);
    shown.window.show_view("plan");
    CHECK(visible() == 0);
    shown.window.show_view("units");
    CHECK(visible() == before);
    CHECK_FALSE(shown.find<QAction>("viewAlone")->isChecked());
}

TEST_CASE("Another project is opened only when what could not be saved may be lost") {
    Shown shown;
    const test::GuiProject other;
    Workspace& workspace = shown.window.models().workspace;
    workspace.select(workspace.snapshot()->record().units.front().id);
    shown.settle_all();
    std::filesystem::rename(shown.site.file, shown.site.folder / "elsewhere.gpkg");
    shown.window.models().card.set_field("title", QStringLiteral("typed in the rain"));
    shown.settle_all();
    REQUIRE(shown.window.models().card.unsaved().size() == 1);
    int asked = 0;
    bool lose = false;
    shown.window.ask_to_close_with([&](QWidget*, const QStringList&) {
        ++asked;
        return lose;
    });
    const auto opens = [&] {
        shown.window.open(other.file, store::OpenMode::ReadWrite);
        for (int i = 0; i < 100 && asked == 0; ++i) QTest::qWait(20); // one more try to save may be on its way
        shown.settle_all();
        return workspace.file() == other.file;
    };
    CHECK_FALSE(opens());
    CHECK(asked == 1);
    CHECK(shown.window.models().card.unsaved().size() == 1);
    asked = 0;
    lose = true;
    CHECK(opens());
    CHECK(asked == 1);
}

TEST_CASE("Ctrl+Z in a field in which nothing was typed takes back the last change of the record") {
    Shown shown;
    Workspace& workspace = shown.window.models().workspace;
    workspace.select(workspace.snapshot()->record().units.front().id);
    shown.settle_all();
    auto* field = shown.window.findChild<QPlainTextEdit*>();
    REQUIRE(field != nullptr);
    QKeyEvent key(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    key.ignore(); // as Qt asks
    QApplication::sendEvent(field, &key);
    CHECK_FALSE(key.isAccepted()); // so it is a shortcut
    field->insertPlainText(QStringLiteral("ash"));
    QApplication::sendEvent(field, &key);
    CHECK(key.isAccepted());
}

TEST_CASE("Without a project the window offers what one can begin with, the last ones too") {
    Shown shown;
    CHECK(shown.find<QWidget>("startPage")->isHidden());
    shown.window.models().workspace.close();
    shown.settle_all();
    CHECK(shown.find<QWidget>("startPage")->isVisible());
    for (const char* begin : {"start_newProject", "start_openProject", "start_makeDemo"})
        CHECK(shown.find<QPushButton>(begin)->isVisible());
    const auto buttons = shown.find<QWidget>("startPage")->findChildren<QToolButton*>();
    REQUIRE_FALSE(buttons.isEmpty());
    CHECK(buttons.front()->toolTip().toStdString() == shown.site.file.string());
    buttons.front()->click();
    shown.settle_all();
    CHECK(shown.window.models().workspace.is_open());
    CHECK(shown.find<QWidget>("startPage")->isHidden());
}

TEST_CASE("Every view has a name of its own, a title and an accessible focus") {
    Shown shown;
    std::set<std::string_view> names;
    for (const ViewEntry& entry : all_views()) {
        INFO(entry.name);
        CHECK(names.insert(entry.name).second);
        CHECK_FALSE(view_title(entry).isEmpty());
        REQUIRE(shown.window.view(entry.name) != nullptr);
        CHECK(shown.window.view(entry.name)->objectName().toStdString() == entry.name);
    }
}

TEST_CASE("The window can be drawn in every theme, with and without a project") {
    Shown shown;
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Sunlight, ThemeKind::Light}) {
        apply_theme(kind);
        shown.settle_all();
        CHECK_FALSE(shown.window.grab().isNull());
    }
    shown.window.models().workspace.close();
    shown.settle_all();
    CHECK_FALSE(shown.window.grab().isNull());
}

TEST_CASE("A problem that was measured is shown with both faces and a section; one of another kind without") {
    ensure_application();
    const test::TemporaryFolder folder;
    {
        app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
        app::record_kind("relation").add(project, "2 covers 1", {});
        app::record_kind("relation").add(project, "3 covers 3", {});
    }
    MainWindow window;
    window.open(folder / "site.gpkg", store::OpenMode::ReadOnly);
    window.show();
    for (int i = 0; i < 3; ++i) settle(window.models().workspace);
    auto* picture = window.findChild<ProofPicture*>(QStringLiteral("proofPicture"));
    REQUIRE(picture != nullptr);
    ProblemListModel& problems = window.models().problems;
    std::set<bool> seen;
    for (int row = 0; row < problems.rowCount(); ++row) {
        problems.open(row);
        settle(window.models().workspace);
        const bool measured = problems.data(problems.index(row), ProblemListModel::CodeRole).toString() ==
                              QStringLiteral("height-contradiction");
        CHECK(picture->isHidden() != measured);
        CHECK(picture->picture().isNull() != measured);
        seen.insert(measured);
    }
    CHECK(seen.size() == 2);
}
