// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include <functional>

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
    /// Asks for a reason (and a number where a unit is split); empty: the person thought better of it. Replaced by
    /// tests.
    struct Answer {
        QString because;
        QString number;
    };

    using Ask = std::function<Answer(QWidget* parent, const QString& what, bool wants_number)>;

    explicit ProblemPanel(Models& models);

    void set_ask(Ask ask) { ask_ = std::move(ask); }

  private:
    void show_summary();
    void show_detail();
    void add_suspect(QVBoxLayout* column, std::size_t at, const SuspectLine& suspect);
    void act(std::size_t suspect, ProblemAction action);
    void accept();

    Models& models_;
    Ask ask_;
    QLabel* summary_;
    QListView* list_;
    QScrollArea* scroll_;
};

} // namespace planum::gui
