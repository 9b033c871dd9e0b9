// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include <array>

#include "gui/viewmodels/today_model.hpp"

class QLabel;
class QListWidget;

namespace planum::gui {

struct Models;

/// What to do next, in three lists beside each other; a click on a line selects its unit everywhere.
class TodayPanel : public QWidget {
    Q_OBJECT

  public:
    explicit TodayPanel(Models& models);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void fill();

    TodayModel today_;
    std::array<QLabel*, 3> heads_{};
    std::array<QListWidget*, 3> lists_{};
};

} // namespace planum::gui
