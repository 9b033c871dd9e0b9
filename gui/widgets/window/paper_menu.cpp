// SPDX-License-Identifier: MIT
#include "gui/widgets/window/paper_menu.hpp"

#include <QAction>
#include <QFileDialog>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "gui/viewmodels/words.hpp"
#include "gui/widgets/choice_dialog.hpp"
#include "gui/widgets/window/export_file.hpp"
#include "gui/widgets/window/main_window.hpp"

namespace planum::gui {

namespace {

// `1 : 20` → 20
double scale_of(const QString& words) { return words.section(QLatin1Char(':'), 1).toDouble(); }

// `12.5 3` or `12,5 3` or `12.5; 3`; nullopt: no two numbers.
std::optional<std::array<double, 2>> place_of(const QString& words) {
    static const QRegularExpression between(QStringLiteral("[;\\s]+"));
    const QStringList parts = words.trimmed().split(between, Qt::SkipEmptyParts);
    if (parts.size() != 2) return std::nullopt;
    std::array<double, 2> place{};
    for (qsizetype i = 0; i < 2; ++i) {
        bool number = false;
        place.at(static_cast<std::size_t>(i)) =
            QString(parts[i]).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&number);
        if (!number) return std::nullopt;
    }
    return place;
}

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
    addAction(tr("Section between two points …"), this, &PaperMenu::ask_free_section)
        ->setObjectName(QStringLiteral("writeFreeSection"));
    const auto enable = [this] {
        setEnabled(window_.models().workspace.is_open());
        for (QAction* action : actions()) action->setEnabled(isEnabled());
    };
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

// Two places as they stand on the sheet of the total station, `x y`; begun with a line through the middle of what is
// outlined on the surface in front, or else of the levels.
void PaperMenu::ask_free_section() {
    const model::Record& record = window_.models().workspace.snapshot()->record();
    double low_x = 1e300;
    double high_x = -1e300;
    double low_y = 1e300;
    double high_y = -1e300;
    const auto take = [&](double x, double y) {
        low_x = std::min(low_x, x);
        high_x = std::max(high_x, x);
        low_y = std::min(low_y, y);
        high_y = std::max(high_y, y);
    };
    for (const model::Region& region : record.regions) {
        if (!region.section.is_nil()) continue;
        for (const model::Polygon& polygon : region.outline) {
            for (const auto& p : polygon.outer) take(p[0], p[1]);
        }
    }
    if (low_x > high_x) take(0.0, 0.0), take(10.0, 0.0);
    const QString middle = QString::number((low_y + high_y) / 2.0, 'f', 2);
    const auto place = [&](double x) { return QStringLiteral("%1 %2").arg(QString::number(x, 'f', 2), middle); };
    const QStringList chosen = ask_choices(
        &window_, tr("Section between two points"),
        {{tr("From x y [m]"), {place(low_x)}, {}, true}, {tr("To x y [m]"), {place(high_x)}, {}, true}, scales()});
    if (chosen.size() != 3) return;
    const auto from = place_of(chosen[0]);
    const auto to = place_of(chosen[1]);
    if (!from || !to) return window_.models().workspace.say(tr("A place is two numbers: x and y in metres."));
    write(tr("Section"), sheet_filter(),
          [from = *from, to = *to, scale = scale_of(chosen[2])](app::Project& project,
                                                                const std::filesystem::path& file, Progress& progress) {
              return write_free_section_file(project, file, from, to, scale, progress);
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
