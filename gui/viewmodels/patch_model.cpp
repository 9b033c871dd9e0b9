// SPDX-License-Identifier: MIT
#include "gui/viewmodels/patch_model.hpp"

#include <memory>
#include <utility>

#include "app/regions/region_import.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygon_overlay.hpp"
#include "gui/viewmodels/sentences.hpp"
#include "gui/viewmodels/time_model.hpp"
#include "gui/viewmodels/words.hpp"

namespace planum::gui {

namespace {

RegionShape shape_of_patch(const app::ReadyPatch& patch) {
    RegionShape shape;
    shape.label = patch.proposed.empty() ? QStringLiteral("?") : qt(patch.proposed) + QStringLiteral(" ?");
    shape.area = patch.area;
    const auto middle = geometry::inner_place(patch.shape);
    shape.middle = QPointF(middle[0], middle[1]);
    for (const geometry::Rings& polygon : patch.shape) {
        for (const geometry::Line3& line : polygon) {
            PointList ring;
            for (const auto& p : line) ring << QPointF(p[0], p[1]);
            shape.rings.push_back(std::move(ring));
        }
    }
    return shape;
}

} // namespace

PatchModel::PatchModel(Workspace& workspace, TimeModel& time, OutlineTool& labels, QObject* parent)
    : QObject(parent), workspace_(workspace), time_(time), labels_(labels) {
    connect(&workspace_, &Workspace::closed, this, &PatchModel::end);
    connect(&workspace_, &Workspace::snapshotChanged, this, &PatchModel::look);
    connect(&time_, &TimeModel::moved, this, [this] {
        forget();
        look();
    });
    connect(&labels_, &OutlineTool::changed, this, [this] {
        if (!view_.isEmpty()) emit changed(); // another number may be taken, or none
    });
}

void PatchModel::begin(const QString& view) {
    view_ = view;
    forget();
    look();
    emit changed();
}

void PatchModel::end() {
    if (view_.isEmpty()) return;
    view_.clear();
    forget();
    emit changed();
}

void PatchModel::forget() {
    patches_.clear();
    shapes_.clear();
    notes_.clear();
    trouble_.clear();
    chosen_ = -1;
}

void PatchModel::look() {
    if (view_.isEmpty() || !workspace_.is_open() || time_.current() < 0) return;
    looking_ = true;
    chosen_ = -1;
    emit changed();
    app::PatchQuery query;
    query.surface = time_.stops()[static_cast<std::size_t>(time_.current())].name.toStdString();
    workspace_.read(
        QStringLiteral("patches"), tr("Looking for ground without outlines"),
        [this, query](app::Project& project, Progress& progress) -> JobRunner::Done {
            auto found = std::make_shared<app::ReadyPatches>(app::ready_patches(project, query, progress));
            return [this, found] {
                forget();
                looking_ = false;
                patches_ = std::move(found->patches);
                for (const app::ReadyPatch& patch : patches_) shapes_.push_back(shape_of_patch(patch));
                for (const std::string& note : found->notes) notes_ << in_window_language(note);
                emit changed();
            };
        },
        [this](const QString& sentence) {
            forget();
            looking_ = false;
            trouble_ = sentence;
            emit changed();
        });
}

void PatchModel::choose(int patch) {
    if (patch < -1 || patch >= static_cast<int>(patches_.size())) return;
    chosen_ = patch;
    if (patch >= 0) {
        labels_.set_category(model::RegionCategory::Unit);
        labels_.set_unit(qt(patches_[static_cast<std::size_t>(patch)].proposed));
    }
    emit changed();
}

bool PatchModel::can_finish() const {
    return chosen_ >= 0 && !looking_ &&
           (labels_.category() != model::RegionCategory::Unit || !labels_.unit().trimmed().isEmpty());
}

void PatchModel::finish() {
    if (!can_finish()) return;
    const app::ReadyPatch& patch = patches_[static_cast<std::size_t>(chosen_)];
    app::DrawnOutline outline = labels_.labels();
    outline.where = "patch";
    outline.on_surface = patch.on_surface;
    outline.notes = patch.because;
    outline.drawn_on = "patch";
    outline.shape = patch.shape;
    workspace_.edit(tr("Name changed ground"), [outline](app::Project& project, Progress&) {
        app::RegionImportOptions options;
        options.create_units = true;
        options.label = outline.unit.empty() ? "Outline changed ground" : "Outline changed ground as " + outline.unit;
        const app::RegionImportReport report = app::import_outlines(project, {{outline}, {}}, options);
        if (!report.refused.empty()) throw Error(ErrorCode::BadInput, report.refused.front().message);
        if (!report.conflicts.empty()) throw Error(ErrorCode::Conflict, report.conflicts.front().message);
    });
}

QString PatchModel::sentence() const {
    if (looking_) return tr("comparing with the surface before …");
    if (!trouble_.isEmpty()) return trouble_;
    if (patches_.empty()) return notes_.isEmpty() ? tr("All ground that changed is outlined.") : notes_.front();
    if (chosen_ < 0)
        return tr("%n patch(es) changed and have no outline: click into one.", nullptr,
                  static_cast<int>(patches_.size()));
    const app::ReadyPatch& patch = patches_[static_cast<std::size_t>(chosen_)];
    const QString numbers = tr("%1 m², %2 m").arg(number_word(patch.area, 2)).arg(number_word(patch.change, 2));
    return QStringLiteral("%1 (%2)").arg(in_window_language(patch.because), numbers);
}

} // namespace planum::gui
