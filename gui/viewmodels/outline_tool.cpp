// SPDX-License-Identifier: MIT
#include "gui/viewmodels/outline_tool.hpp"

#include <utility>

#include "app/regions/region_import.hpp"
#include "app/regions/region_names.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

OutlineTool::OutlineTool(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
    connect(&workspace_, &Workspace::closed, this, &OutlineTool::end);
    // The unit that is looked at is the likeliest one to be drawn.
    connect(&workspace_, &Workspace::selectionChanged, this, [this] {
        if (!workspace_.is_open() || workspace_.selected().is_nil() || !corners_.isEmpty()) return;
        set_unit(qt(workspace_.snapshot()->index().name(workspace_.selected())));
    });
}

void OutlineTool::begin(const QString& view, ToOutlines to_outlines) {
    view_ = view;
    to_outlines_ = std::move(to_outlines);
    corners_.clear();
    taken_back_.clear();
    cancelled_.clear();
    emit changed();
}

void OutlineTool::end() { begin({}, {}); }

void OutlineTool::add(QPointF corner) {
    if (view_.isEmpty()) return;
    corners_ << corner;
    taken_back_.clear();
    cancelled_.clear();
    emit changed();
}

void OutlineTool::move_last(QPointF corner) {
    if (corners_.isEmpty()) return;
    corners_.last() = corner;
    emit changed();
}

void OutlineTool::take_back() {
    if (corners_.isEmpty()) {
        corners_ = std::exchange(cancelled_, {});
    } else {
        taken_back_ << corners_.takeLast();
    }
    emit changed();
}

void OutlineTool::take_forward() {
    if (taken_back_.isEmpty()) return;
    corners_ << taken_back_.takeLast();
    emit changed();
}

void OutlineTool::cancel() {
    if (corners_.isEmpty()) return end();
    cancelled_ = std::exchange(corners_, {});
    taken_back_.clear();
    emit changed();
}

void OutlineTool::set_unit(const QString& number) {
    if (number == unit_) return;
    unit_ = number;
    emit changed();
}

void OutlineTool::set_category(model::RegionCategory category) {
    category_ = category;
    emit changed();
}

void OutlineTool::set_shows(std::optional<model::RegionShows> shows) {
    shows_ = shows;
    emit changed();
}

QString OutlineTool::unit_sentence() const {
    const std::string typed{text::trim(unit_.toStdString())};
    if (category_ != model::RegionCategory::Unit || typed.empty() || !workspace_.is_open()) return {};
    const auto& snapshot = *workspace_.snapshot();
    const auto found = snapshot.index().named(typed);
    if (found.empty()) {
        const auto near = app::proposed_numbers(snapshot.record(), typed);
        const QString hint =
            near.empty() ? QString() : QLatin1Char(' ') + tr("Near it: %1.").arg(qt(text::join(near, ", ")));
        return tr("No unit %1 yet; it will be made.").arg(unit_.trimmed()) + hint;
    }
    const model::StratigraphicUnit& unit = snapshot.record().units[found.front()];
    return QStringLiteral("%1 %2").arg(kind_word(unit.kind, unit.form), qt(unit.title)).trimmed();
}

app::DrawnOutline OutlineTool::labels() const {
    app::DrawnOutline labels;
    labels.where = "outline";
    labels.category = category_;
    if (category_ == model::RegionCategory::Unit) labels.unit = unit_.trimmed().toStdString();
    labels.shows = shows_;
    return labels;
}

void OutlineTool::finish() {
    if (!can_finish() || view_.isEmpty()) return;
    auto name = std::make_shared<QString>();
    workspace_.edit(
        tr("Draw an outline"),
        [labels = labels(), corners = corners_, to_outlines = to_outlines_, name](app::Project& project,
                                                                                  Progress& progress) {
            const app::OutlineFile file = to_outlines(project, labels, corners, progress);
            if (file.outlines.empty()) {
                throw Error(ErrorCode::BadInput,
                            file.notes.empty() ? "nothing to draw on" : file.notes.front().message);
            }
            app::RegionImportOptions options;
            options.create_units = true;
            options.label = labels.unit.empty() ? "Draw an outline" : "Draw an outline of " + labels.unit;
            options.update = true; // a line drawn over the old one replaces it
            const app::RegionImportReport report = app::import_outlines(project, file, options);
            if (!report.refused.empty()) throw Error(ErrorCode::BadInput, report.refused.front().message);
            if (!report.fresh.empty()) *name = qt(report.fresh.front());
            if (!report.redrawn.empty()) *name = qt(report.redrawn.front());
        },
        [this, name] { emit finished(*name); });
    corners_.clear();
    taken_back_.clear();
    cancelled_.clear();
    emit changed();
}

} // namespace planum::gui
