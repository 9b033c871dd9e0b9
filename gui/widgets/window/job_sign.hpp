// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace planum::gui {

class JobRunner;

/// The job under way in the status bar: its name and step, how far it is, and a button that stops it.
class JobSign : public QWidget {
    Q_OBJECT

  public:
    explicit JobSign(JobRunner& jobs);

  private:
    void refresh();

    JobRunner& jobs_;
    QLabel* text_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

} // namespace planum::gui
