// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QWidget>

namespace planum::gui {

struct Models;

/// The measured proof of the height contradiction that is open: both faces in plan and a cross-section, as `planum
/// check
/// --show` draws them. Hidden for problems of other kinds. A click shows it as large as the screen allows.
class ProofPicture : public QWidget {
    Q_OBJECT

  public:
    explicit ProofPicture(Models& models);

    [[nodiscard]] const QImage& picture() const noexcept { return picture_; }

    [[nodiscard]] QSize sizeHint() const override;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }

    [[nodiscard]] int heightForWidth(int width) const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

  private:
    void draw_again();
    void take(const QString& problem, QImage picture, QString sentence);
    [[nodiscard]] QRectF box() const;

    Models& models_;
    QString problem_; ///< whose picture it is; empty: none
    QImage picture_;
    QString sentence_; ///< in place of a picture
};

} // namespace planum::gui
