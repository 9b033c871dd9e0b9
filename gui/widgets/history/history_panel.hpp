// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QTableWidget;

namespace planum::gui {

struct Models;

/// All changes of the project, newest first; those taken back are struck out.
class HistoryPanel : public QWidget {
    Q_OBJECT

  public:
    explicit HistoryPanel(Models& models);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fill();
    void colour();

    Models& models_;
    QTableWidget* table_;
};

} // namespace planum::gui
