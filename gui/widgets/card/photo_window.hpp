// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QImage>

#include <filesystem>
#include <vector>

#include "gui/viewmodels/unit_card_model.hpp"

class QLabel;
class QToolButton;

namespace planum::gui {

/// One photo or drawing as large as the screen allows; the arrows go to the unit's others, Esc closes. Deletes itself
/// when it is closed.
class PhotoWindow : public QDialog {
    Q_OBJECT

  public:
    PhotoWindow(Workspace& workspace, std::vector<CardPicture> pictures, std::size_t at, QWidget* parent);

    [[nodiscard]] const QImage& picture() const noexcept { return picture_; }

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void go(int steps);
    void read();
    void fit();

    Workspace& workspace_;
    std::filesystem::path project_;
    std::vector<CardPicture> pictures_;
    std::size_t at_;
    QImage picture_;
    QLabel* shown_;
    QLabel* caption_;
    QToolButton* back_;
    QToolButton* on_;
};

} // namespace planum::gui
