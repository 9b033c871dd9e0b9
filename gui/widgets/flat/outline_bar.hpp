// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/viewmodels/outline_edit.hpp"
#include "gui/viewmodels/outline_tool.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace planum::gui {

struct Models;

/// The outline tool above a flat view: draw, which unit, what it is, what it shows; change an outline, a corner away;
/// name ground that changed; last step back, finish, cancel.
class OutlineBar : public QWidget {
    Q_OBJECT

  public:
    /// Whether the view can offer ground that changed and has no outline.
    enum class Offers { Nothing, Patches };

    OutlineBar(Models& models, const QString& view, Offers offers = Offers::Nothing);

    /// How corners of this view become outlines and outlines corners; without one nothing can be drawn, because of
    /// `why`.
    void set_ground(OutlineTool::ToOutlines to_outlines, const QString& why = {}, EditGround edit = {});

  private:
    void refresh();
    void toggle(bool draw);
    void toggle_change(bool change);
    void toggle_offer(bool offer);
    void step_back();
    void finish();
    void cancel();
    void say_what_buttons_do();
    [[nodiscard]] bool is_drawing() const;
    [[nodiscard]] bool is_changing() const;
    [[nodiscard]] bool is_offering() const;

    Models& models_;
    QString view_;
    OutlineTool::ToOutlines to_outlines_;
    EditGround edit_ground_;
    QString why_not_;
    QToolButton* draw_;
    QToolButton* change_;
    QToolButton* offer_;
    QToolButton* remove_;
    QLineEdit* unit_;
    QComboBox* category_;
    QComboBox* shows_;
    QToolButton* back_;
    QToolButton* finish_;
    QToolButton* cancel_;
    QLabel* sentence_;
};

} // namespace planum::gui
