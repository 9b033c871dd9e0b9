// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QWidget>

#include <memory>
#include <optional>

#include "core/model/ids.hpp"
#include "gui/viewmodels/matrix_model.hpp"
#include "gui/widgets/matrix/matrix_ink.hpp"

namespace planum::gui {

/// The drawing on the screen: wheel, pinch or + and − zoom at the pointer, dragging the ground moves it, a click
/// selects a unit, dragging from one unit to another asks for a relation.
class MatrixCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit MatrixCanvas(MatrixModel& model);

    void fit();
    void zoom(double factor, QPointF around);
    /// Brings the selected unit, or the proof, into sight; leaves the view alone where it is in sight already.
    void show_selected();
    void show_proof();

    [[nodiscard]] double scale() const noexcept { return scale_; }

    /// Where a box stands in the widget [px]; for tests and for the menu of a relation.
    [[nodiscard]] QRectF box_on_screen(std::size_t box) const;

  signals:
    /// Somebody drew a line from one unit to another.
    void relationWanted(planum::model::UnitId from, planum::model::UnitId to, QPoint at);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void take_drawing();
    void keep_in_sight();
    void walk(int key);
    void show_rect(const QRectF& in_drawing, double most_scale);
    [[nodiscard]] QRectF seen() const;

    [[nodiscard]] QPointF to_drawing(QPointF on_screen) const { return (on_screen - origin_) / scale_; }

    [[nodiscard]] std::optional<std::size_t> box_at(QPointF on_screen) const;

    MatrixModel& model_;
    std::shared_ptr<const strat::MatrixDrawing> drawing_;
    std::shared_ptr<const MatrixInk> ink_;
    double scale_ = 1.0; ///< [px per pt]
    QPointF origin_;     ///< of the drawing on the screen [px]
    bool fitted_ = true; ///< follows the window's size until somebody zooms
    std::size_t hovered_ = MatrixInk::kNone;
    std::optional<QPointF> pressed_;
    QPointF origin_when_pressed_;
    std::optional<std::size_t> from_box_;
    QPointF pointer_;
    bool dragging_ = false;
};

} // namespace planum::gui
