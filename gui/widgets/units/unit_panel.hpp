// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace planum::gui {

struct Models;

/// The list of units: typed text narrows it at once, Enter selects, arrows walk.
class UnitPanel : public QWidget {
    Q_OBJECT

  public:
    explicit UnitPanel(Models& models);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fill_choices();
    void take_filter();
    void follow_selection();
    void count();

    Models& models_;
    QLineEdit* search_;
    QComboBox* kind_;
    QComboBox* status_;
    QComboBox* area_;
    QCheckBox* problems_;
    QTableView* table_;
    QLabel* count_;
    bool following_ = false;
};

} // namespace planum::gui
