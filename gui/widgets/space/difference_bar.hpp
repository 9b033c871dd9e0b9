// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/viewmodels/difference_model.hpp"

class QComboBox;
class QLabel;

namespace planum::gui {

/// The key of a difference: from lower over grey to higher, with what the ends and the grey stand for.
class DifferenceScale : public QWidget {
    Q_OBJECT

  public:
    void show_key(const DifferenceKey& key);

    [[nodiscard]] QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    DifferenceKey key_;
};

/// With which surface the one in 3D is compared, and what the colours mean.
class DifferenceBar : public QWidget {
    Q_OBJECT

  public:
    explicit DifferenceBar(DifferenceModel& difference);

  private:
    void refresh();

    DifferenceModel& difference_;
    QComboBox* choice_;
    DifferenceScale* scale_;
    QLabel* said_;
};

} // namespace planum::gui
