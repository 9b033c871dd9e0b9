// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/widgets/reason_dialog.hpp"

class QLabel;
class QListView;
class QScrollArea;
class QVBoxLayout;

namespace planum::gui {

enum class ProblemAction;
struct Models;
struct ProblemDetail;
struct SuspectLine;

/// What contradicts what: the list, and beside it the problem that is open with its proof, suspects, their reasons and
/// one button an action.
class ProblemPanel : public QWidget {
    Q_OBJECT

  public:
    explicit ProblemPanel(Models& models);

    void set_ask(AskReason ask) { ask_ = std::move(ask); }

  private:
    void show_summary();
    void show_detail();
    void show_page(QWidget* page);
    void add_suspect(QVBoxLayout* column, std::size_t at, const SuspectLine& suspect);
    void act(std::size_t suspect, ProblemAction action);
    void accept();

    Models& models_;
    AskReason ask_;
    QLabel* summary_;
    QListView* list_;
    QScrollArea* scroll_;
    QVBoxLayout* detail_ = nullptr; ///< the words of the open problem, below them its picture
};

} // namespace planum::gui
