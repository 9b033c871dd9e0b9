// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include <memory>

#include "core/model/ids.hpp"
#include "gui/viewmodels/matrix_model.hpp"
#include "paint/font_measure.hpp"

class QComboBox;
class QLabel;
class QToolButton;

namespace planum::gui {

class MatrixCanvas;
struct Models;

/// The matrix with what chooses its part: all, around the selected unit, problems only, since a day; folded or not.
class MatrixView : public QWidget {
    Q_OBJECT

  public:
    explicit MatrixView(Models& models);

    [[nodiscard]] MatrixModel& model() noexcept { return matrix_; }

    /// What it shows; null until something is drawn.
    [[nodiscard]] std::shared_ptr<const strat::MatrixDrawing> drawing() const { return matrix_.drawing(); }

    /// The same for print and files: with the evidence in its lines and its key while the view shows it.
    [[nodiscard]] std::shared_ptr<const strat::MatrixDrawing> drawing_for_paper() const;

    [[nodiscard]] MatrixCanvas& canvas() noexcept { return *canvas_; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void ask_again();
    void offer_relation(model::UnitId from, model::UnitId to, const QPoint& at);
    QWidget* make_bar();
    [[nodiscard]] QString words_of_drawing() const;

    Models& models_;
    paint::FontTextMeasure text_;
    MatrixModel matrix_;
    MatrixCanvas* canvas_;
    QComboBox* part_;
    QComboBox* fold_;
    QToolButton* titles_;
    QToolButton* evidence_;
    QLabel* count_;
};

} // namespace planum::gui
