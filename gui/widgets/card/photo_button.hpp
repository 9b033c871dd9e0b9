// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractButton>
#include <QImage>

namespace planum::gui {

/// A small picture with its title below, to be pressed by a click, Enter or the space bar.
class PhotoButton : public QAbstractButton {
    Q_OBJECT

  public:
    explicit PhotoButton(const QString& title);

    void set_picture(const QImage& picture);

    [[nodiscard]] const QImage& picture() const noexcept { return picture_; }

    /// Room of the picture [px]; multiply by the display's ratio for what has to be read.
    [[nodiscard]] static QSize room();

    [[nodiscard]] QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QImage picture_;
};

} // namespace planum::gui
