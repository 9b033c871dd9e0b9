// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "gui/render/point_set.hpp"
#include "gui/viewmodels/difference_model.hpp"
#include "gui/viewmodels/space_model.hpp"

class QComboBox;
class QLabel;
class QToolButton;

namespace planum::gui {

struct Models;
class BoxPanel;
class ContentsPanel;
class DifferenceBar;
class FlightCameras;
class SectionLineBar;
class SpaceCanvas;

/// 3D with its choices. Where there is no OpenGL it says so in place of the picture.
class SpaceView : public QWidget {
    Q_OBJECT

  public:
    explicit SpaceView(Models& models);

    /// Null where there is no OpenGL, or nobody has looked yet.
    [[nodiscard]] SpaceCanvas* canvas() const noexcept { return usable_ ? canvas_ : nullptr; }

    /// Colours the points so; nothing happens where there is no canvas.
    void show_colour(PointColour colour);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void make_scene();
    void make_canvas();
    void say_unusable(const QString& why);
    QWidget* make_bar();
    void make_colours();
    void watch_difference();
    QToolButton* make_section_button();
    void show_section_line();
    QToolButton* make_flight_button();
    void ask_flight();

    Models& models_;
    SpaceModel space_;
    DifferenceModel difference_;
    SpaceCanvas* canvas_ = nullptr;
    QComboBox* colour_ = nullptr;
    DifferenceBar* compared_ = nullptr;
    BoxPanel* box_ = nullptr;
    SectionLineBar* section_ = nullptr;
    FlightCameras* cameras_ = nullptr;
    ContentsPanel* contents_ = nullptr;
    QWidget* scene_ = nullptr; ///< all that is of use where there is OpenGL only; null: nobody has looked yet
    QLabel* said_;
    bool usable_ = true;
};

} // namespace planum::gui
