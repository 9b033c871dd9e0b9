// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace planum::gui {

/// A line of a list: a sign, a title, and below it a sentence.
class TwoLineDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  protected:
    virtual void paint_sign(QPainter& painter, const QRectF& box, const QModelIndex& index, bool selected) const = 0;
    [[nodiscard]] virtual QString title(const QModelIndex& index) const = 0;
    [[nodiscard]] virtual QString sentence(const QModelIndex& index) const = 0;
};

} // namespace planum::gui
