// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gui/viewmodels/section_model.hpp"
#include "gui/widgets/flat/flat_canvas.hpp"
#include "gui/widgets/flat/flat_page.hpp"

namespace planum::gui {

class OutlineBar;

/// The plan of the surface that the time line shows: site grid, outlines, finds, levels, stations, sections.
class PlanCanvas : public FlatCanvas {
    Q_OBJECT

  public:
    explicit PlanCanvas(Models& models);

    void refresh();
    /// Draws these lines instead of those before.
    void show_sections(std::vector<SectionModel::Line> sections);

  protected:
    void paint_ground(QPainter& painter, const QRectF& seen) override;
    void paint_over(QPainter& painter) override;

    [[nodiscard]] QList<QRectF> kept_free() const override;

    [[nodiscard]] QRectF extent() const override { return extent_; }

    [[nodiscard]] QString empty_text() const override;

  private:
    struct Mark {
        enum class Kind { Find, Level, Station } kind = Kind::Find;
        QPointF place;
        QString label;
        model::UnitId unit;
    };

    void paint_marks(QPainter& painter);
    void paint_scale_bar(QPainter& painter);

    QRectF extent_;
    std::vector<Mark> marks_;
    std::vector<SectionModel::Line> sections_;
};

class PlanView : public FlatPage {
    Q_OBJECT

  public:
    explicit PlanView(Models& models);

  protected:
    [[nodiscard]] QString words_for(QPointF place) const override;

  private:
    void refresh();

    Models& models_;
    PlanCanvas* canvas_;
    OutlineBar* bar_;
    model::SurfaceId ground_of_; ///< what the bar draws on
};

} // namespace planum::gui
