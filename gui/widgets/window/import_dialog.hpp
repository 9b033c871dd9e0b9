// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

#include "gui/viewmodels/day_jobs.hpp"

class QCheckBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace planum::gui {

/// What an import would do: new, differing, not understood. Nothing is written before the button is pressed.
class ImportDialog : public QDialog {
    Q_OBJECT

  public:
    ImportDialog(DayJobs& day, DayJobs::Files files, QWidget* parent);

  private:
    void show_preview(const ImportPreview& preview);
    void look_again();

    DayJobs& day_;
    DayJobs::Files files_;
    QCheckBox* update_;
    QLabel* heading_;
    QPlainTextEdit* text_;
    QPushButton* import_;
};

} // namespace planum::gui
