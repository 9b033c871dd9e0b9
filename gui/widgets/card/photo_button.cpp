// SPDX-License-Identifier: MIT
#include "gui/widgets/card/photo_button.hpp"

#include <QKeyEvent>
#include <QPainter>

#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr int kEdge = 4; // [px] around picture and title

} // namespace

PhotoButton::PhotoButton(const QString& title) {
    setText(title);
    setToolTip(title);
    setAccessibleName(title);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
}

QSize PhotoButton::room() { return {116, 87}; }

QSize PhotoButton::sizeHint() const { return room() + QSize(2 * kEdge, 3 * kEdge + fontMetrics().height()); }

void PhotoButton::set_picture(const QImage& picture) {
    picture_ = picture;
    update();
}

void PhotoButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const bool strong = hasFocus() || underMouse();
    painter.setPen(QPen(strong ? theme().accent : theme().edge, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(isDown() ? theme().edge : theme().window);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
    const QRectF place(QPointF(kEdge, kEdge), QSizeF(room()));
    if (!picture_.isNull()) {
        QRectF at(QPointF(), (QSizeF(picture_.size()) / devicePixelRatioF()).boundedTo(place.size()));
        at.moveCenter(place.center());
        painter.drawImage(at, picture_);
    }
    painter.setPen(theme().ink);
    const QRectF words(kEdge, height() - kEdge - fontMetrics().height(), width() - 2.0 * kEdge, fontMetrics().height());
    painter.drawText(words, Qt::AlignCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, static_cast<int>(words.width())));
}

void PhotoButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
    QAbstractButton::keyPressEvent(event);
}

} // namespace planum::gui
