// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QWidget>

#include <filesystem>
#include <vector>

#include "gui/viewmodels/unit_card_model.hpp"

class QLabel;
class QVBoxLayout;

namespace planum::gui {

class FlowLayout;
class PhotoButton;

/// The photos and drawings of the unit as small pictures; a click or Enter shows one large. What cannot be shown is
/// said below them, each with its path. Pictures are read in a thread, one after the other.
class PhotoStrip : public QWidget {
    Q_OBJECT

  public:
    explicit PhotoStrip(Workspace& workspace);

    /// Shows these; nothing is read again when they are the same as before.
    void show_pictures(const std::vector<CardPicture>& pictures);

  private:
    void read(std::size_t at);
    void take(std::size_t at, const QImage& image, const QString& sentence);
    void say_trouble();

    Workspace& workspace_;
    std::filesystem::path project_; ///< whose pictures they are
    std::vector<CardPicture> pictures_;
    std::vector<PhotoButton*> buttons_;
    std::vector<QString> trouble_; ///< for each picture: why it is not shown; empty where it is
    QLabel* heading_;
    QWidget* strip_;
    FlowLayout* flow_;
    QLabel* said_;
    std::size_t shown_ = 0; ///< counts: what was read for pictures shown before comes too late
};

} // namespace planum::gui
