// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace planum::gui {

class Job;
class JobRunner;

/// The job under way in the status bar: its name and step, how far it is, and a button that stops it. What nobody asked
/// for by name is said only when it takes more than a second.
class JobSign : public QWidget {
    Q_OBJECT

  public:
    explicit JobSign(JobRunner& jobs);

  private:
    void refresh();
    void say();
    /// Something asked for before anything quiet; nullptr: nothing runs.
    [[nodiscard]] const Job* worth_saying() const;

    JobRunner& jobs_;
    QTimer patience_; ///< runs from when quiet work began to when it is said
    QLabel* text_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

} // namespace planum::gui
