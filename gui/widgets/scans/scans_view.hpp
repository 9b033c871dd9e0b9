// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QTableWidget;

namespace planum::gui {

struct Models;

/// The scans with where they stand and how well; adding, markers and registration; what the last one said.
class ScansView : public QWidget {
    Q_OBJECT

  public:
    explicit ScansView(Models& models);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void list_again();

    Models& models_;
    QTableWidget* table_;
    QPushButton* register_;
    QLabel* said_;
};

} // namespace planum::gui
