// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace planum::gui {

class MainWindow;

/// What one can begin with while no project is open: a new one, one that is there, one of the last ones, a sample.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(MainWindow& window);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void fill_recent();

    MainWindow& window_;
    QVBoxLayout* recent_;
};

} // namespace planum::gui
