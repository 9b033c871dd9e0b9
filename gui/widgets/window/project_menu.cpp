// SPDX-License-Identifier: MIT
#include "gui/widgets/window/project_menu.hpp"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>

#include "app/demo/demo_job.hpp"
#include "gui/viewmodels/words.hpp"
#include "gui/widgets/choice_dialog.hpp"
#include "gui/widgets/matrix/matrix_print.hpp"
#include "gui/widgets/matrix/matrix_view.hpp"
#include "gui/widgets/window/export_file.hpp"
#include "gui/widgets/window/import_dialog.hpp"
#include "gui/widgets/window/main_window.hpp"
#include "gui/widgets/window/paper_menu.hpp"
#include "paint/font_measure.hpp"

namespace planum::gui {

namespace {

constexpr int kMostRecent = 10;
const QString kRecentKey = QStringLiteral("recent");

DayJobs::Files paths(const QStringList& files) {
    DayJobs::Files all;
    for (const QString& file : files) all.emplace_back(file.toStdString());
    return all;
}

} // namespace

ProjectMenu::ProjectMenu(MainWindow& window) : QMenu(tr("Project"), &window), window_(window) {
    auto* recent_menu = addMenu(tr("Recent projects"));
    addAction(tr("Make a sample dig …"), this, &ProjectMenu::ask_demo)->setObjectName(QStringLiteral("makeDemo"));
    connect(recent_menu, &QMenu::aboutToShow, this, [this, recent_menu] { fill_recent(recent_menu); });
    addSeparator();
    QAction* import = addAction(tr("Import lists …"), this, [this] {
        const QStringList files = ask_files(tr("Lists of units, relations, finds"), tr("All files (*)"));
        if (!files.isEmpty()) (new ImportDialog(window_.models().day, paths(files), &window_))->show();
    });
    import->setObjectName(QStringLiteral("importLists"));
    import->setShortcut(QKeySequence(QStringLiteral("Ctrl+I")));
    addAction(tr("Add scans …"), this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(&window_, tr("Folder of a day's scans"));
        if (!folder.isEmpty()) window_.models().day.add_scans(paths({folder}), {});
    });
    addAction(tr("Import outlines …"), this, [this] {
        const QStringList files = ask_files(tr("Outlines"), tr("Outlines (*.geojson *.json)"));
        if (!files.isEmpty()) window_.models().day.import_outlines(paths(files));
    });
    addAction(tr("Import measured points …"), this, [this] {
        const QStringList files =
            ask_files(tr("Points of the total station"), tr("Points (*.csv *.txt *.dxf);;All files (*)"));
        if (!files.isEmpty()) window_.models().day.import_survey(paths(files));
    });
    addSeparator();
    QAction* write = addAction(tr("Export or print …"), this, &ProjectMenu::ask_export);
    write->setObjectName(QStringLiteral("export"));
    write->setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
    QAction* print = addAction(tr("Print the matrix …"), this, [this] {
        const auto* matrix = dynamic_cast<MatrixView*>(window_.view("matrix"));
        if (matrix == nullptr || matrix->drawing() == nullptr) {
            return window_.models().workspace.say(tr("No matrix is drawn that could be printed."));
        }
        print_matrix(*matrix, &window_);
    });
    print->setObjectName(QStringLiteral("printMatrix"));
    print->setShortcut(QKeySequence::Print);
    addMenu(new PaperMenu(window_));
    addAction(tr("Backup …"), this, [this] {
        const QString file = QFileDialog::getSaveFileName(&window_, tr("Backup"), {}, tr("Planum projects (*.gpkg)"));
        if (!file.isEmpty()) window_.models().day.backup(file.toStdString());
    });
    connect(&window_.models().workspace, &Workspace::opened, this, &ProjectMenu::remember);
}

QStringList ProjectMenu::ask_files(const QString& title, const QString& filter) {
    return QFileDialog::getOpenFileNames(&window_, title, {}, filter);
}

QStringList ProjectMenu::recent() {
    QStringList there;
    for (const QString& file : QSettings().value(kRecentKey).toStringList()) {
        if (QFileInfo::exists(file)) there << file;
    }
    return there;
}

void ProjectMenu::remember() {
    const QString file = qt(window_.models().workspace.file().string());
    QStringList files = recent();
    files.removeAll(file);
    files.prepend(file);
    QSettings().setValue(kRecentKey, QStringList(files.mid(0, kMostRecent)));
}

void ProjectMenu::fill_recent(QMenu* menu) {
    menu->clear();
    for (const QString& file : recent()) {
        menu->addAction(file, this, [this, file] { window_.open(file.toStdString(), store::OpenMode::ReadWrite); });
    }
    if (menu->isEmpty()) menu->addAction(tr("none yet"))->setEnabled(false);
}

void ProjectMenu::take_files(const QStringList& files) {
    DayJobs::Files scans;
    DayJobs::Files outlines;
    DayJobs::Files lists;
    for (const std::filesystem::path& file : paths(files)) {
        switch (use_of(file)) {
        case FileUse::Project: return window_.open(file, store::OpenMode::ReadWrite);
        case FileUse::Scans: scans.push_back(file); break;
        case FileUse::Outlines: outlines.push_back(file); break;
        case FileUse::Lists: lists.push_back(file); break;
        }
    }
    if (!window_.models().workspace.is_open()) {
        window_.models().workspace.say(tr("Open a project first, then drop the files on it."));
        return;
    }
    if (!scans.empty()) window_.models().day.add_scans(scans, {});
    if (!outlines.empty()) window_.models().day.import_outlines(outlines);
    if (!lists.empty()) (new ImportDialog(window_.models().day, lists, &window_))->show();
}

void ProjectMenu::ask_export() {
    const QString file = QFileDialog::getSaveFileName(
        &window_, tr("Export or print"), {},
        tr("Matrix (*.pdf *.svg *.png);;Report (*.xml *.html);;For other programs (*.csv *.json *.lst *.hmcx *.graphml "
           "*.dot *.geojson *.ttl *.xlsx *.dxf *.oxcal)"));
    if (!file.isEmpty()) export_to(file.toStdString());
}

void ProjectMenu::ask_demo() {
    const QString small = tr("small: 12 units, half a minute");
    const QString medium = tr("medium: 40 units, minutes, 600 MB");
    const QStringList chosen =
        ask_choices(&window_, tr("Make a sample dig"), {{tr("Size"), {small, medium}, small, false}});
    if (chosen.isEmpty()) return;
    const QString folder =
        QFileDialog::getSaveFileName(&window_, tr("New folder for the sample dig"), QStringLiteral("sample-dig"));
    if (!folder.isEmpty()) make_demo(folder.toStdString(), chosen[0] == medium);
}

void ProjectMenu::make_demo(const std::filesystem::path& folder, bool medium) {
    app::demo::SimulationOptions options;
    if (medium) options.size = app::demo::DemoSize::Medium;
    window_.models().workspace.jobs().start(
        QStringLiteral("demo"), JobRunner::Queueing::InOrder, tr("Making a sample dig"), Job::Kind::Asked,
        [this, folder, options](Progress& progress) -> JobRunner::Done {
            const paint::FontTextMeasure measure;
            const app::DemoJob made = app::run_demo_job(folder, options, {}, measure, progress);
            return [this, made] { window_.open(made.mistaken_project, store::OpenMode::ReadWrite); };
        },
        [this](const QString& sentence) { window_.models().workspace.say(sentence); });
}

// While the matrix shows what the evidence says, so does what is written of it.
void ProjectMenu::export_to(const std::filesystem::path& file) {
    auto* matrix = dynamic_cast<MatrixView*>(window_.view("matrix"));
    std::shared_ptr<const strat::MatrixDrawing> shown;
    if (matrix != nullptr && matrix->model().shows_evidence()) shown = matrix->drawing_for_paper();
    window_.models().workspace.read(QStringLiteral("export"), tr("Writing %1").arg(qt(file.filename().string())),
                                    [this, file, shown](app::Project& project, Progress& progress) -> JobRunner::Done {
                                        const QString sentence = export_file(project, file, progress, shown.get());
                                        return [this, sentence] { emit window_.models().day.done(sentence); };
                                    });
}

void show_shortcuts(MainWindow& window) {
    QString text = QStringLiteral("<table cellpadding='4'>");
    const auto row = [&](const QString& keys, const QString& what) {
        text +=
            QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>").arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
    };
    for (const QAction* action : window.findChildren<QAction*>()) {
        if (action->shortcut().isEmpty()) continue;
        row(action->shortcut().toString(QKeySequence::NativeText), action->text());
    }
    row(QStringLiteral("+  −  F"), ProjectMenu::tr("larger, smaller, the whole drawing"));
    row(QStringLiteral("← ↑ → ↓"), ProjectMenu::tr("along the orders of the matrix, or move the picture"));
    row(QKeySequence(Qt::Key_Backspace).toString(QKeySequence::NativeText),
        ProjectMenu::tr("while drawing: last corner back"));
    row(QKeySequence(Qt::Key_Escape).toString(QKeySequence::NativeText),
        ProjectMenu::tr("while drawing: cancel (can be taken back)"));
    QDialog dialog(&window);
    dialog.setWindowTitle(ProjectMenu::tr("Shortcuts"));
    auto* list = new QLabel(text + QStringLiteral("</table>"));
    auto* scrolled = new QScrollArea; // a tablet is lower than the list is long
    scrolled->setWidgetResizable(true);
    scrolled->setWidget(list);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* column = new QVBoxLayout(&dialog);
    column->addWidget(scrolled, 1);
    column->addWidget(buttons);
    const QSize wanted = list->sizeHint() + QSize(60, 90);
    dialog.resize(wanted.boundedTo(0.85 * window.screen()->availableSize()));
    dialog.exec();
}

} // namespace planum::gui
