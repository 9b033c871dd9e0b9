// SPDX-License-Identifier: MIT
#pragma once

#include <QMenu>
#include <QStringList>

#include <filesystem>

namespace planum::gui {

class MainWindow;

/// The menu of files: recent projects, import with preview, scans, outlines, measured points, export, backup; and what
/// happens with files dropped on the window.
class ProjectMenu : public QMenu {
    Q_OBJECT

  public:
    explicit ProjectMenu(MainWindow& window);

    /// Does with files what their kinds call for; several kinds at once each in turn.
    void take_files(const QStringList& files);

    /// Writes in the form that the ending names, in a thread.
    void export_to(const std::filesystem::path& file);

    /// Simulates a dig in a new folder, in a thread, and opens its copy with mistakes.
    void make_demo(const std::filesystem::path& folder, bool medium);

    /// Newest first; those that are gone are left out.
    [[nodiscard]] static QStringList recent();

  private:
    void remember();
    void fill_recent(QMenu* menu);
    QStringList ask_files(const QString& title, const QString& filter);
    void ask_export();
    void ask_demo();

    MainWindow& window_;
};

/// All shortcuts of the window with what they do, in a dialog.
void show_shortcuts(MainWindow& window);

} // namespace planum::gui
