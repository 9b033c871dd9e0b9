// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

#include "app/regions/outline.hpp"
#include "gui/viewmodels/region_shapes.hpp"
#include "gui/viewmodels/workspace.hpp"

namespace planum::gui {

/// An outline while it is drawn, on a panorama, in plan or on a section: corners in the coordinates of that view, and
/// what the outline is. One for all views, so that what was chosen stays chosen.
class OutlineTool : public QObject {
    Q_OBJECT

  public:
    /// Turns the finished corners into outlines, in the thread that holds the file. Throws when there is no ground.
    using ToOutlines = std::function<app::OutlineFile(app::Project&, const app::DrawnOutline& labels,
                                                      const PointList& corners, Progress&)>;

    explicit OutlineTool(Workspace& workspace, QObject* parent = nullptr);

    /// A view takes the tool up; what another view had begun is forgotten.
    void begin(const QString& view, ToOutlines to_outlines);
    void end();

    [[nodiscard]] bool is_active(const QString& view) const { return view_ == view && !view_.isEmpty(); }

    void add(QPointF corner);
    void move_last(QPointF corner);
    /// Takes the last corner back; take_forward puts it there again.
    void take_back();
    void take_forward();
    /// Esc: nothing is drawn any more; take_back brings it back.
    void cancel();

    [[nodiscard]] const PointList& corners() const noexcept { return corners_; }

    [[nodiscard]] bool can_finish() const noexcept { return corners_.size() >= 3; }

    void set_unit(const QString& number);

    [[nodiscard]] const QString& unit() const noexcept { return unit_; }

    /// Unset: a unit.
    void set_category(model::RegionCategory category);

    [[nodiscard]] model::RegionCategory category() const noexcept { return category_; }

    /// Unset: by the kind of the unit and the method of the surface.
    void set_shows(std::optional<model::RegionShows> shows);

    [[nodiscard]] std::optional<model::RegionShows> shows() const noexcept { return shows_; }

    /// What the outline is, as chosen; without a shape.
    [[nodiscard]] app::DrawnOutline labels() const;

    /// What the number means: an existing unit, none yet (with near numbers), or empty.
    [[nodiscard]] QString unit_sentence() const;

    /// Hands the outline in as one undo step. A number without a unit makes one.
    void finish();

  signals:
    void changed();
    void finished(const QString& name);

  private:
    Workspace& workspace_;
    QString view_;
    ToOutlines to_outlines_;
    PointList corners_;
    PointList taken_back_; ///< last one first to come again
    PointList cancelled_;
    QString unit_;
    model::RegionCategory category_ = model::RegionCategory::Unit;
    std::optional<model::RegionShows> shows_;
};

} // namespace planum::gui
