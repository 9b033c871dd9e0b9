// SPDX-License-Identifier: MIT
#include "gui/widgets/window/paper_menu.hpp"

#include <QAction>
#include <QFileDialog>

#include <utility>

#include "gui/viewmodels/words.hpp"
#include "gui/widgets/choice_dialog.hpp"
#include "gui/widgets/window/export_file.hpp"
#include "gui/widgets/window/main_window.hpp"

namespace planum::gui {

namespace {

// `1 : 20` → 20
double scale_of(const QString& words) { return words.section(QLatin1Char(':'), 1).toDouble(); }

Choice scales() {
    return {PaperMenu::tr("Scale"),
            {QStringLiteral("1 : 10"), QStringLiteral("1 : 20"), QStringLiteral("1 : 50"), QStringLiteral("1 : 100")},
            QStringLiteral("1 : 20"),
            false};
}

QString sheet_filter() { return PaperMenu::tr("On paper (*.pdf);;Picture (*.png)"); }

} // namespace

PaperMenu::PaperMenu(MainWindow& window) : QMenu(tr("Report, plan, section"), &window), window_(window) {
    addAction(tr("Report …"), this, &PaperMenu::ask_report)->setObjectName(QStringLiteral("writeReport"));
    addAction(tr("Plan to scale …"), this, &PaperMenu::ask_plan)->setObjectName(QStringLiteral("writePlan"));
    addAction(tr("Section to scale …"), this, &PaperMenu::ask_section)->setObjectName(QStringLiteral("writeSection"));
    const auto enable = [this] { setEnabled(window_.models().workspace.is_open()); };
    connect(&window_.models().workspace, &Workspace::opened, this, enable);
    connect(&window_.models().workspace, &Workspace::closed, this, enable);
    enable();
}

void PaperMenu::ask_report() {
    const QString whole = tr("the whole record");
    const QStringList chosen = ask_choices(
        &window_, tr("Report"), {{tr("Day"), QStringList{whole} + window_.models().inquiry.days(), whole, true}});
    if (chosen.isEmpty()) return;
    const std::string day = chosen[0] == whole ? std::string() : chosen[0].trimmed().toStdString();
    write(tr("Report"), tr("Report (*.pdf *.html *.xml)"),
          [day](app::Project& project, const std::filesystem::path& file, Progress& progress) {
              return write_report_file(project, file, day, progress);
          });
}

void PaperMenu::ask_plan() {
    const TimeModel& time = window_.models().time;
    QStringList surfaces;
    for (const TimeModel::Stop& stop : time.stops()) surfaces << stop.name;
    if (surfaces.isEmpty()) return window_.models().workspace.say(tr("There is no surface to draw yet."));
    const QStringList chosen = ask_choices(
        &window_, tr("Plan to scale"), {{tr("Surface"), surfaces, surfaces.value(time.current()), false}, scales()});
    if (chosen.size() != 2) return;
    write(tr("Plan"), sheet_filter(),
          [surface = chosen[0].toStdString(),
           scale = scale_of(chosen[1])](app::Project& project, const std::filesystem::path& file, Progress& progress) {
              return write_plan_file(project, file, surface, scale, progress);
          });
}

void PaperMenu::ask_section() {
    QStringList names;
    for (const model::Section& section : window_.models().workspace.snapshot()->record().sections) {
        names << qt(section.name);
    }
    if (names.isEmpty()) return window_.models().workspace.say(tr("There is no section yet."));
    const QStringList chosen =
        ask_choices(&window_, tr("Section to scale"), {{tr("Section"), names, {}, false}, scales()});
    if (chosen.size() != 2) return;
    write(tr("Section"), sheet_filter(),
          [section = chosen[0].toStdString(),
           scale = scale_of(chosen[1])](app::Project& project, const std::filesystem::path& file, Progress& progress) {
              return write_section_file(project, file, section, scale, progress);
          });
}

void PaperMenu::write(const QString& title, const QString& filter, Write how) {
    const QString chosen = QFileDialog::getSaveFileName(&window_, title, {}, filter);
    if (chosen.isEmpty()) return;
    const std::filesystem::path file(chosen.toStdString());
    window_.models().workspace.read(
        QStringLiteral("export"), tr("Writing %1").arg(qt(file.filename().string())),
        [this, file, how = std::move(how)](app::Project& project, Progress& progress) -> JobRunner::Done {
            const QString sentence = how(project, file, progress);
            return [this, sentence] { emit window_.models().day.done(sentence); };
        },
        {}, Job::Kind::Asked);
}

} // namespace planum::gui
