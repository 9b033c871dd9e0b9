// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace planum::gui {

class SectionLine;

/// What to click for a section line, how thick what stays is, and what can be done with it.
class SectionLineBar : public QWidget {
    Q_OBJECT

  public:
    explicit SectionLineBar(SectionLine& line);

  signals:
    /// Look straight at it.
    void faceWanted();

  private:
    void refresh();

    SectionLine& line_;
    QLabel* said_;
    QDoubleSpinBox* thickness_;
    QToolButton* face_;
    QToolButton* over_;
};

} // namespace planum::gui
