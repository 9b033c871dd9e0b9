// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QTransform>

#include <vector>

#include "gui/viewmodels/region_shapes.hpp"

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace planum::gui {

class OutlineEdit;

/// The corners of an outline that is being changed, under the pointer of a flat canvas: large dots at the corners,
/// small ones in the middle of the lines, which become corners when they are dragged.
class OutlineHandles {
  public:
    explicit OutlineHandles(OutlineEdit& edit) : edit_(edit) {}

    void paint(QPainter& painter, const QTransform& view, QPointF pointer) const;

    /// True: the press took a corner or a line, which moves until release().
    bool press(const QTransform& view, QPointF on_screen);
    /// Moves what was taken; false: nothing is.
    bool drag(QPointF place);
    /// True: something was taken, and its move is over.
    bool release();
    /// A click that took nothing: another region is chosen, a right click takes a corner away.
    void click(const QTransform& view, const QMouseEvent& event, const RegionShape* under);
    /// True: the key was for the outline.
    bool key(const QKeyEvent& event);

    /// Neighbours that corners snap to: all regions but this one.
    [[nodiscard]] std::vector<RegionShape> neighbours(const std::vector<RegionShape>& shapes) const;

  private:
    OutlineEdit& edit_;
    bool taken_ = false;
};

} // namespace planum::gui
