// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/viewmodels/outline_tool.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace planum::gui {

struct Models;

/// The outline tool above a flat view: draw, which unit, what it is, what it shows; last corner back, finish, cancel.
class OutlineBar : public QWidget {
    Q_OBJECT

  public:
    OutlineBar(Models& models, const QString& view);

    /// How corners of this view become outlines; without one nothing can be drawn, because of `why`.
    void set_ground(OutlineTool::ToOutlines to_outlines, const QString& why = {});

  private:
    void refresh();
    void toggle(bool draw);

    Models& models_;
    QString view_;
    OutlineTool::ToOutlines to_outlines_;
    QString why_not_;
    QToolButton* draw_;
    QLineEdit* unit_;
    QComboBox* category_;
    QComboBox* shows_;
    QToolButton* back_;
    QToolButton* finish_;
    QToolButton* cancel_;
    QLabel* sentence_;
};

} // namespace planum::gui
