// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

namespace planum::gui {

class TimeModel;

/// The surfaces as stops on a line; a click, a drag or the arrows go to one. Plan, panorama and 3D follow.
class TimeLine : public QWidget {
    Q_OBJECT

  public:
    explicit TimeLine(TimeModel& time);

    [[nodiscard]] QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void refresh();
    [[nodiscard]] double x_of(int stop) const;
    [[nodiscard]] int stop_at(double x) const;

    TimeModel& time_;
};

} // namespace planum::gui
