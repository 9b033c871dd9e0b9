// SPDX-License-Identifier: MIT
#include "gui/viewmodels/today_model.hpp"

#include <utility>

#include "app/checks/today.hpp"
#include "gui/viewmodels/service_sentences.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

std::vector<TodayModel::Line> named(app::Project& project, const std::vector<std::string>& units) {
    std::vector<TodayModel::Line> lines;
    for (const std::string& name : units) {
        const model::StratigraphicUnit& unit = project.record().units[project.unit_named(name)];
        const QString title = unit.title.empty() ? kind_word(unit.kind, unit.form) : qt(unit.title);
        lines.push_back({qt(name), QStringLiteral("%1  %2").arg(qt(name), title).trimmed()});
    }
    return lines;
}

} // namespace

TodayModel::TodayModel(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::snapshotChanged, this, &TodayModel::read);
    connect(&workspace_, &Workspace::closed, this, [this] {
        open_.clear();
        next_.clear();
        sheets_.clear();
        stale_ = true;
        emit changed();
    });
}

void TodayModel::set_watched(bool watched) {
    watched_ = watched;
    if (watched_ && stale_) read();
}

void TodayModel::read() {
    stale_ = true;
    if (!watched_ || !workspace_.is_open()) return;
    stale_ = false;
    workspace_.read(
        QStringLiteral("today"), tr("Looking what is next"),
        [this](app::Project& project, Progress&) -> JobRunner::Done {
            const app::TodayList today = app::today_of(project);
            std::vector<Line> sheets;
            for (const app::IncompleteSheet& sheet : today.incomplete_sheets) {
                QStringList missing;
                for (const std::string& what : sheet.missing) missing << service_sentence(what);
                sheets.push_back(
                    {qt(sheet.unit), tr("%1 lacks %2").arg(qt(sheet.unit), missing.join(QStringLiteral(", ")))});
            }
            return [this, open = named(project, today.open), next = named(project, today.may_be_dug_next), sheets]() {
                open_ = open;
                next_ = next;
                sheets_ = sheets;
                emit changed();
            };
        });
}

void TodayModel::choose(const QString& unit) {
    if (!workspace_.is_open()) return;
    const auto found = workspace_.snapshot()->index().named(unit.toStdString());
    if (found.size() == 1) workspace_.select(workspace_.snapshot()->record().units[found.front()].id);
}

} // namespace planum::gui
