// SPDX-License-Identifier: MIT
#pragma once

#include <QMenu>

namespace planum::gui {

class MainWindow;
struct Answer;

/// What is wanted now and then: the project verified, two readings or registrations compared, ground that is not
/// outlined yet. The answers come in a window of their own.
class ToolsMenu : public QMenu {
    Q_OBJECT

  public:
    explicit ToolsMenu(MainWindow& window);

  private:
    void clean();
    void write_region_points();
    void compare_readings();
    void compare_runs();
    void choose_run(const QString& what, bool accept);
    void show_answer(const Answer& answer);

    MainWindow& window_;
};

} // namespace planum::gui
