// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QTransform>
#include <QWidget>

#include <optional>
#include <vector>

#include "gui/viewmodels/region_shapes.hpp"
#include "gui/widgets/flat/outline_handles.hpp"

namespace planum::gui {

struct Models;

/// A flat picture of ground to look at and to draw on: plan, section and panorama are this with different grounds.
/// Places are metres with y upwards, or pixels with y downwards. Wheel and pinch zoom at the pointer, dragging moves,
/// also while drawing; a click selects, or sets a corner while the outline tool is up. While an outline is changed, its
/// corners are dragged.
class FlatCanvas : public QWidget {
    Q_OBJECT

  public:
    enum class Up { Upwards, Downwards };

    /// `name` is the view's, by which the outline tool knows who draws.
    FlatCanvas(Models& models, const QString& name, Up up);

    void set_shapes(std::vector<RegionShape> shapes);

    [[nodiscard]] const std::vector<RegionShape>& shapes() const noexcept { return shapes_; }

    /// Patches of changed ground, in the order of the patch model.
    void set_patches(std::vector<RegionShape> patches);

    void fit();
    void zoom(double factor, QPointF around);

    [[nodiscard]] QPointF to_screen(QPointF place) const { return view().map(place); }

    [[nodiscard]] QPointF to_place(QPointF on_screen) const { return view().inverted().map(on_screen); }

    /// Pixels on the screen per unit of the picture.
    [[nodiscard]] double scale() const noexcept { return scale_; }

  signals:
    void hovered(QPointF place);

  protected:
    /// What lies below the regions; the painter is in places, `seen` bounds what is to be seen.
    virtual void paint_ground(QPainter& painter, const QRectF& seen) = 0;
    /// What lies above them; the painter is in pixels of the screen.
    virtual void paint_over(QPainter& painter) = 0;

    /// What numbers of regions shall not hide, on the screen [px].
    [[nodiscard]] virtual QList<QRectF> kept_free() const { return {}; }

    /// What fit() shows; null: nothing yet.
    [[nodiscard]] virtual QRectF extent() const = 0;
    /// Shown where there is nothing to see.
    [[nodiscard]] virtual QString empty_text() const = 0;

    Models& models() noexcept { return models_; }

    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

  private:
    [[nodiscard]] QTransform view() const;
    void paint_shapes(QPainter& painter) const;
    void paint_labels(QPainter& painter) const;
    void paint_patches(QPainter& painter) const;
    void paint_tool(QPainter& painter) const;
    [[nodiscard]] bool is_drawing() const;
    [[nodiscard]] bool is_changing() const;
    [[nodiscard]] bool is_offering() const;
    [[nodiscard]] QPointF snapped(QPointF on_screen) const;

    Models& models_;
    QString name_;
    Up up_;
    std::vector<RegionShape> shapes_;
    std::vector<RegionShape> patches_;
    double scale_ = 1.0;
    QPointF origin_; ///< of the places, on the screen
    bool fitted_ = true;
    std::optional<QPointF> pressed_;
    QPointF origin_when_pressed_;
    QPointF pointer_;
    OutlineHandles handles_;
    bool dragging_ = false;
};

} // namespace planum::gui
