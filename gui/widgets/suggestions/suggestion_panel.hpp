// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/viewmodels/suggestion_list_model.hpp"
#include "gui/widgets/reason_dialog.hpp"

class QLabel;
class QListView;
class QPushButton;
class QScrollArea;

namespace planum::gui {

struct Models;

/// What the surfaces propose and ask: the list, and beside it the one that is open with its evidence and the answers.
class SuggestionPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SuggestionPanel(Models& models);

    void set_ask(AskReason ask) { ask_ = std::move(ask); }

    [[nodiscard]] SuggestionListModel& suggestions() noexcept { return suggestions_; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void show_summary();
    void show_detail();
    [[nodiscard]] QWidget* make_answers();
    void state_relation();
    void compile();

    Models& models_;
    SuggestionListModel suggestions_;
    AskReason ask_;
    QLabel* summary_;
    QPushButton* compile_;
    QListView* list_;
    QScrollArea* scroll_;
};

} // namespace planum::gui
