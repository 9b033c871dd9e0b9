// SPDX-License-Identifier: MIT
#pragma once

#include <QMenu>

#include <filesystem>
#include <functional>

#include "app/project/project.hpp"
#include "core/base/progress.hpp"

namespace planum::gui {

class MainWindow;

/// What is written to scale or to be read on paper: the report of a day or of the whole record, a plan, a section.
class PaperMenu : public QMenu {
    Q_OBJECT

  public:
    explicit PaperMenu(MainWindow& window);

  private:
    using Write = std::function<QString(app::Project&, const std::filesystem::path&, Progress&)>;
    void ask_report();
    void ask_plan();
    void ask_section();
    void ask_free_section();
    /// Asks for the file, then writes it in a thread.
    void write(const QString& title, const QString& filter, Write how);

    MainWindow& window_;
};

} // namespace planum::gui
