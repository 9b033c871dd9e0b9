// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include <array>

class QSlider;

namespace planum::gui {

/// What of the site is cut away in 3D: two ends along x, y and height, as shares of what the scans fill.
class BoxPanel : public QWidget {
    Q_OBJECT

  public:
    BoxPanel();

    void reset();

  signals:
    void changed(const std::array<double, 3>& low, const std::array<double, 3>& high);

  private:
    void say();

    std::array<QSlider*, 3> low_{};
    std::array<QSlider*, 3> high_{};
};

} // namespace planum::gui
