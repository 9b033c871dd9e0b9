// SPDX-License-Identifier: MIT
#pragma once

#include <QMainWindow>

#include <filesystem>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include "app/project/project.hpp"
#include "gui/viewmodels/models.hpp"

class QAction;
class QDockWidget;
class QLabel;
class QMenu;
class QTabWidget;

namespace planum::gui {

class NoticeBar;
class ProjectMenu;

/// The one window: views in the middle as tabs, units at the left, the record card at the right, problems and
/// history below, what is going on at the foot.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(const app::Session& session = {});
    ~MainWindow() override;

    void open(const std::filesystem::path& file, store::OpenMode mode);

    [[nodiscard]] Models& models() noexcept { return models_; }

    /// The view of that name; nullptr when there is none.
    [[nodiscard]] QWidget* view(std::string_view name) const;
    /// Brings it to the front.
    void show_view(std::string_view name);

    [[nodiscard]] NoticeBar& notice() noexcept { return *notice_; }

    [[nodiscard]] ProjectMenu& project_menu() noexcept { return *project_menu_; }

    /// Asks whether to close although these fields are not saved; tests answer by themselves.
    using AskToClose = std::function<bool(QWidget* parent, const QStringList& unsaved)>;

    void ask_to_close_with(AskToClose ask) { close_anyway_ = std::move(ask); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    static bool ask_to_close(QWidget* parent, const QStringList& unsaved);
    void leave_field();
    [[nodiscard]] bool may_leave(std::function<void()> again);
    void leave_project(std::function<void()> then);
    void make_views();
    void size_docks();
    void make_actions();
    void make_status();
    void show_alone(bool alone);
    void fill_languages(QMenu& menu);
    void refresh();
    void ask_for_project(store::OpenMode mode);
    void make_project();
    QAction* action(const char* name, const QString& text, const QKeySequence& keys);

    Models models_;
    NoticeBar* notice_;
    QTabWidget* tabs_;
    std::map<std::string_view, QWidget*> views_;
    std::map<std::string_view, QDockWidget*> docks_;
    bool docks_sized_ = false; ///< once; then they are as somebody drags them
    ProjectMenu* project_menu_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QAction* alone_ = nullptr;
    QLabel* state_;
    QLabel* problems_;
    AskToClose close_anyway_ = &MainWindow::ask_to_close;
};

} // namespace planum::gui
