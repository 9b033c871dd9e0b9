// SPDX-License-Identifier: MIT
#include "gui/widgets/window/main_window.hpp"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFontMetrics>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QTextDocument>
#include <QTimer>
#include <QToolBar>
#include <QUrl>
#include <QVBoxLayout>

#include <initializer_list>
#include <utility>

#include "gui/viewmodels/dock_sizes.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/language.hpp"
#include "gui/widgets/theme.hpp"
#include "gui/widgets/time/time_line.hpp"
#include "gui/widgets/view.hpp"
#include "gui/widgets/window/job_sign.hpp"
#include "gui/widgets/window/notice_bar.hpp"
#include "gui/widgets/window/project_menu.hpp"
#include "gui/widgets/window/start_page.hpp"
#include "gui/widgets/window/tools_menu.hpp"

namespace planum::gui {

namespace {

constexpr int kLookAgain = 50; // [ms] while the window waits for the last edit before it closes

Qt::DockWidgetArea area_of(Place place) {
    switch (place) {
    case Place::Left: return Qt::LeftDockWidgetArea;
    case Place::Right: return Qt::RightDockWidgetArea;
    case Place::Bottom: return Qt::BottomDockWidgetArea;
    case Place::Centre: break;
    }
    return Qt::NoDockWidgetArea;
}

} // namespace

MainWindow::MainWindow(const app::Session& session)
    : models_(session), notice_(new NoticeBar), tabs_(new QTabWidget), state_(new QLabel), problems_(new QLabel) {
    setObjectName(QStringLiteral("window"));
    resize(1600, 1000);
    setDockNestingEnabled(true);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    auto* middle = new QWidget;
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice_);
    column->addWidget(tabs_, 1);
    column->addWidget(new TimeLine(models_.time));
    auto* start = new StartPage(*this);
    column->insertWidget(1, start, 1);
    const auto show_either = [this, start] {
        const bool open = !models_.workspace.file().empty(); // or on its way
        start->setVisible(!open);
        tabs_->setVisible(open);
    };
    connect(&models_.workspace, &Workspace::opened, this, show_either);
    // Queued: where one project is closed for another, the page of neither is shown in between.
    connect(&models_.workspace, &Workspace::closed, this, show_either, Qt::QueuedConnection);
    connect(&models_.workspace, &Workspace::failed, this, show_either);
    show_either();
    tabs_->setDocumentMode(true);
    setCentralWidget(middle);
    // So large that a change of the theme would keep them busy for too long.
    for (QWidget* whole : std::initializer_list<QWidget*>{this, middle, tabs_, tabs_->findChild<QStackedWidget*>()})
        StyledParts::in_parts(*whole);
    make_actions();
    make_views();
    make_status();
    Workspace& workspace = models_.workspace;
    connect(&workspace, &Workspace::failed, notice_, &NoticeBar::say);
    connect(&workspace, &Workspace::overcome, notice_, &NoticeBar::take_back);
    connect(&workspace, &Workspace::noted, this,
            [this](const QString& text) { statusBar()->showMessage(text, 10000); });
    connect(&workspace, &Workspace::opened, notice_, &QWidget::hide);
    for (const auto change : {&Workspace::opened, &Workspace::closed, &Workspace::snapshotChanged}) {
        connect(&workspace, change, this, &MainWindow::refresh);
    }
    connect(&models_.problems, &ProblemListModel::checked, this, &MainWindow::refresh);
    connect(&models_.day, &DayJobs::done, this, [this](const QString& text) { statusBar()->showMessage(text, 15000); });
    connect(&models_.section_line, &SectionLine::handedOver, this, [this] { show_view("section"); });
    setAcceptDrops(true);
    qApp->installEventFilter(this);
    connect(&models_.entry, &RelationEntryModel::committed, this,
            [this](const QString& sentence) { statusBar()->showMessage(tr("recorded: %1").arg(sentence), 6000); });
    refresh();
}

MainWindow::~MainWindow() = default;

void MainWindow::make_views() {
    QDockWidget* last_below = nullptr;
    for (const ViewEntry& entry : all_views()) {
        QWidget* view = entry.make(models_);
        views_[entry.name] = view;
        auto* show = new QAction(view_title(entry), this);
        show->setShortcut(QKeySequence(QString::fromLatin1(entry.shortcut)));
        connect(show, &QAction::triggered, this, [this, name = entry.name] { show_view(name); });
        findChild<QMenu*>(QStringLiteral("viewMenu"))->addAction(show);
        if (entry.place == Place::Centre) {
            tabs_->addTab(view, view_title(entry));
            continue;
        }
        auto* dock = new QDockWidget(view_title(entry));
        dock->setObjectName(QStringLiteral("dock_") + QString::fromLatin1(entry.name.data()));
        dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
        dock->setWidget(view);
        addDockWidget(area_of(entry.place), dock);
        docks_[entry.name] = dock;
        if (entry.place != Place::Bottom) continue;
        if (last_below != nullptr) tabifyDockWidget(last_below, dock);
        last_below = dock;
    }
    for (const auto& [name, dock] : docks_) {
        if (name == "problems") dock->raise();
    }
}

// When it is known how large the window is: a tablet's docks leave the middle more than they would on a desk.
void MainWindow::size_docks() {
    const QFontMetrics metrics = fontMetrics();
    const DockSizes sizes = dock_sizes(metrics.horizontalAdvance(QLatin1Char('0')), metrics.lineSpacing(), size());
    resizeDocks({docks_.at("units"), docks_.at("card")}, {sizes.units, sizes.card}, Qt::Horizontal);
    resizeDocks({docks_.at("problems")}, {sizes.below}, Qt::Vertical);
}

// Every word of the window would have to be set again, so what is chosen holds from the next start on.
void MainWindow::fill_languages(QMenu& menu) {
    for (const QString& code : languages()) {
        QAction* choice = menu.addAction(language_name(code));
        choice->setObjectName(QStringLiteral("language_") + code);
        choice->setCheckable(true);
        choice->setChecked(code == chosen_language());
        connect(choice, &QAction::triggered, this, [this, code, &menu] {
            choose_language(code);
            for (QAction* other : menu.actions())
                other->setChecked(other->objectName() == QStringLiteral("language_") + code);
            statusBar()->showMessage(tr("%1 from the next start on").arg(language_name(code)), 10000);
        });
    }
}

QAction* MainWindow::action(const char* name, const QString& text, const QKeySequence& keys) {
    auto* made = new QAction(text, this);
    made->setObjectName(QString::fromLatin1(name));
    made->setShortcut(keys);
    made->setToolTip(keys.isEmpty() ? text
                                    : QStringLiteral("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText)));
    return made;
}

void MainWindow::make_actions() {
    QAction* fresh = action("newProject", tr("New project …"), QKeySequence::New);
    QAction* open_it = action("openProject", tr("Open …"), QKeySequence::Open);
    QAction* look = action("openReadOnly", tr("Open for reading only …"), {});
    QAction* quit = action("quit", tr("Quit"), QKeySequence::Quit);
    undo_ = action("undo", tr("Undo"), QKeySequence::Undo);
    redo_ = action("redo", tr("Redo"), QKeySequence::Redo);
    QAction* find = action("find", tr("Find a unit"), QKeySequence::Find);
    QAction* relate = action("relate", tr("Add a relation"), QKeySequence(QStringLiteral("Ctrl+R")));
    alone_ = action("viewAlone", tr("View alone"), QKeySequence(Qt::Key_F11));
    alone_->setCheckable(true);
    connect(alone_, &QAction::toggled, this, &MainWindow::show_alone);
    connect(fresh, &QAction::triggered, this, &MainWindow::make_project);
    connect(open_it, &QAction::triggered, this, [this] { ask_for_project(store::OpenMode::ReadWrite); });
    connect(look, &QAction::triggered, this, [this] { ask_for_project(store::OpenMode::ReadOnly); });
    connect(quit, &QAction::triggered, this, &QWidget::close);
    connect(undo_, &QAction::triggered, this, [this] {
        const QPointer<QWidget> field = focusWidget();
        leave_field(); // what is being typed is the last thing that was done
        models_.workspace.undo();
        if (field != nullptr) field->setFocus();
    });
    connect(redo_, &QAction::triggered, &models_.workspace, &Workspace::redo);
    connect(find, &QAction::triggered, this, [this] { show_view("units"); });
    connect(relate, &QAction::triggered, this, [this] {
        alone_->setChecked(false);
        findChild<QWidget*>(QStringLiteral("relationEntry"))->setFocus();
        findChild<QLineEdit*>(QStringLiteral("relationSubject"))->selectAll(); // what is typed is another unit
    });

    project_menu_ = new ProjectMenu(*this);
    menuBar()->addMenu(project_menu_);
    project_menu_->insertActions(project_menu_->actions().front(), {fresh, open_it, look});
    project_menu_->addSeparator();
    project_menu_->addAction(quit);
    QMenu* edit = menuBar()->addMenu(tr("Edit"));
    edit->addActions({undo_, redo_, find, relate});
    QMenu* view = menuBar()->addMenu(tr("View"));
    view->setObjectName(QStringLiteral("viewMenu"));
    view->addAction(alone_);
    view->addSeparator();
    menuBar()->addMenu(new ToolsMenu(*this));
    QMenu* looks = menuBar()->addMenu(tr("Theme"));
    for (const auto& [kind, text] : {std::pair{ThemeKind::Light, tr("Light")}, std::pair{ThemeKind::Dark, tr("Dark")},
                                     std::pair{ThemeKind::Sunlight, tr("Sunlight")}}) {
        looks->addAction(text, this, [kind = kind] { apply_theme(kind, StyledParts::Pace::InTurns); });
    }
    fill_languages(*menuBar()->addMenu(tr("Language")));
    QAction* keys = action("shortcuts", tr("Shortcuts"), QKeySequence(Qt::Key_F1));
    connect(keys, &QAction::triggered, this, [this] { show_shortcuts(*this); });
    menuBar()->addMenu(tr("Help"))->addAction(keys);
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->addActions({open_it, undo_, redo_, find, relate, alone_});
}

void MainWindow::make_status() {
    statusBar()->setSizeGripEnabled(false);
    state_->setObjectName(QStringLiteral("state"));
    // What was done is said at the left for a while; how things stand, at the right for good.
    statusBar()->addPermanentWidget(new JobSign(models_.workspace.jobs()));
    statusBar()->addPermanentWidget(state_);
    statusBar()->addPermanentWidget(problems_);
}

void MainWindow::refresh() {
    Workspace& workspace = models_.workspace;
    const bool open = workspace.is_open();
    const QString undo = workspace.undo_label();
    const QString redo = workspace.redo_label();
    const bool writable = open && workspace.read_only_because().isEmpty();
    const auto shortened = [](const QString& text) {
        return text.size() > 34 ? text.left(32) + QStringLiteral("…") : text;
    };
    undo_->setEnabled(writable && !undo.isEmpty());
    undo_->setText(undo.isEmpty() ? tr("Undo") : tr("Undo: %1").arg(shortened(undo)));
    undo_->setToolTip(undo);
    redo_->setEnabled(writable && !redo.isEmpty());
    redo_->setText(redo.isEmpty() ? tr("Redo") : tr("Redo: %1").arg(shortened(redo)));
    redo_->setToolTip(redo);
    if (!open) {
        setWindowTitle(QStringLiteral("Planum"));
        state_->setText(tr("no project open"));
        problems_->clear();
        return;
    }
    const model::Record& record = workspace.snapshot()->record();
    const QString name = record.settings.name.empty() ? qt(workspace.file().stem().string()) : qt(record.settings.name);
    setWindowTitle(QStringLiteral("%1 – Planum").arg(name));
    QString state = tr("%1: %2 units, %3 relations").arg(name).arg(record.units.size()).arg(record.relations.size());
    if (!workspace.read_only_because().isEmpty()) state += QStringLiteral("  ·  ") + workspace.read_only_because();
    state_->setText(state);
    problems_->setText(models_.problems.is_checked() ? models_.problems.summary() : QString());
}

void MainWindow::open(const std::filesystem::path& file, store::OpenMode mode) {
    leave_project([this, file, mode] { models_.workspace.open(file, mode); });
}

void MainWindow::ask_for_project(store::OpenMode mode) {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Open a project"), {}, tr("Planum projects (*.gpkg);;All files (*)"));
    if (!file.isEmpty()) open(file.toStdString(), mode);
}

void MainWindow::make_project() {
    QString file = QFileDialog::getSaveFileName(this, tr("New project"), {}, tr("Planum projects (*.gpkg)"));
    if (file.isEmpty()) return;
    if (!file.endsWith(QLatin1String(".gpkg"))) file += QStringLiteral(".gpkg");
    model::ProjectSettings settings;
    settings.name = std::filesystem::path(file.toStdString()).stem().string();
    leave_project([this, file, settings] { models_.workspace.create(file.toStdString(), settings); });
}

QWidget* MainWindow::view(std::string_view name) const {
    const auto it = views_.find(name);
    return it == views_.end() ? nullptr : it->second;
}

// On a tablet lists and card leave little room for a drawing. What lay in front of the panels below does so again.
void MainWindow::show_alone(bool alone) {
    for (const auto& [name, dock] : docks_) {
        if (alone) dock->setProperty("wasInFront", !dock->visibleRegion().isEmpty());
        dock->setVisible(!alone);
    }
    if (alone) return;
    for (const auto& [name, dock] : docks_) {
        if (dock->property("wasInFront").toBool()) dock->raise();
    }
}

void MainWindow::show_view(std::string_view name) {
    QWidget* shown = view(name);
    if (shown == nullptr) return;
    const auto dock = docks_.find(name);
    if (dock != docks_.end()) {
        alone_->setChecked(false);
        dock->second->show();
        dock->second->raise();
    } else {
        tabs_->setCurrentWidget(shown);
    }
    shown->setFocus();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) files << url.toLocalFile();
    }
    project_menu_->take_files(files);
    event->acceptProposedAction();
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (!std::exchange(docks_sized_, true)) size_docks();
}

// A field in which nothing was typed has nothing to take back: Ctrl+Z is then the record's.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo))
        return QMainWindow::eventFilter(watched, event);
    const auto* line = qobject_cast<QLineEdit*>(watched);
    const auto* text = qobject_cast<QPlainTextEdit*>(watched);
    const bool untouched =
        (line != nullptr && !line->isUndoAvailable()) || (text != nullptr && !text->document()->isUndoAvailable());
    if (!untouched) return QMainWindow::eventFilter(watched, event);
    event->ignore();
    return true;
}

void MainWindow::leave_field() {
    if (QWidget* field = focusWidget()) field->clearFocus();
}

// What somebody did a moment ago is saved first, and `again` called then; what could not be is asked about.
bool MainWindow::may_leave(std::function<void()> again) {
    leave_field();
    if (models_.workspace.is_saving()) {
        statusBar()->showMessage(tr("saving …"));
        QTimer::singleShot(kLookAgain, this, std::move(again));
        return false;
    }
    const QStringList unsaved = models_.card.unsaved();
    return unsaved.isEmpty() || close_anyway_(this, unsaved);
}

void MainWindow::leave_project(std::function<void()> then) {
    if (may_leave([this, then] { leave_project(then); })) then();
}

// Long jobs are stopped and leave the project as it was.
void MainWindow::closeEvent(QCloseEvent* event) {
    if (!may_leave([this] { close(); })) return event->ignore();
    models_.workspace.jobs().cancel_all();
    event->accept();
}

bool MainWindow::ask_to_close(QWidget* parent, const QStringList& unsaved) {
    QMessageBox box(QMessageBox::Warning, tr("Not saved"),
                    tr("These fields could not be saved, and are lost when the project closes:\n%1")
                        .arg(unsaved.join(QLatin1Char('\n'))),
                    QMessageBox::NoButton, parent);
    const QPushButton* lose = box.addButton(tr("Close all the same"), QMessageBox::DestructiveRole);
    box.setDefaultButton(box.addButton(tr("Keep the project open"), QMessageBox::RejectRole));
    box.exec();
    return box.clickedButton() == lose;
}

} // namespace planum::gui
