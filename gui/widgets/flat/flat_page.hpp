// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QWidget>

class QLabel;

namespace planum::gui {

class FlatCanvas;
class OutlineBar;

/// What plan, section and panorama have alike: at the head what is looked at, the outline bar, the place under the
/// pointer and Fit; below them the canvas, which takes the keys.
class FlatPage : public QWidget {
    Q_OBJECT

  public:
    FlatPage();

  protected:
    /// Once, when the parts are made. `choices` get a line of their own above the outline bar.
    void lay_out(const QString& name, FlatCanvas* canvas, OutlineBar* bar, const QList<QWidget*>& choices = {});

    /// In words, for the head; `place` as the canvas counts.
    [[nodiscard]] virtual QString words_for(QPointF place) const = 0;

  private:
    QLabel* place_;
};

} // namespace planum::gui
