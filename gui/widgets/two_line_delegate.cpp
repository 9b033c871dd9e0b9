// SPDX-License-Identifier: MIT
#include "gui/widgets/two_line_delegate.hpp"

#include <QPainter>

#include "gui/widgets/theme.hpp"

namespace planum::gui {

QSize TwoLineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {200, option.fontMetrics.lineSpacing() * 2 + 12};
}

void TwoLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    painter->save();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    if (selected) painter->fillRect(option.rect, theme().accent);
    const QRect inner = option.rect.adjusted(10, 6, -10, -6);
    const int line = option.fontMetrics.lineSpacing();
    const double sign = line * 0.8;
    paint_sign(*painter, QRectF(inner.left(), inner.top() + (line - sign) / 2.0, sign, sign), index, selected);
    const int left = inner.left() + line + 4;
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    painter->setFont(bold);
    painter->setPen(selected ? theme().on_accent : theme().ink);
    const QString head = QFontMetrics(bold).elidedText(title(index), Qt::ElideRight, inner.right() - left);
    painter->drawText(QRect(left, inner.top(), inner.right() - left, line), Qt::AlignVCenter, head);
    painter->setFont(option.font);
    painter->setPen(selected ? theme().on_accent : theme().faint);
    const QString text = option.fontMetrics.elidedText(sentence(index), Qt::ElideRight, inner.right() - left);
    painter->drawText(QRect(left, inner.top() + line, inner.right() - left, line), Qt::AlignVCenter, text);
    painter->restore();
}

} // namespace planum::gui
