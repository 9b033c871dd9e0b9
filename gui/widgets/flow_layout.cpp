// SPDX-License-Identifier: MIT
#include "gui/widgets/flow_layout.hpp"

#include <QWidget>

#include <algorithm>

namespace planum::gui {

FlowLayout::FlowLayout(int spacing) {
    setContentsMargins(0, 0, 0, 0);
    setSpacing(spacing);
}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) { items_.emplace_back(item); }

int FlowLayout::count() const { return static_cast<int>(items_.size()); }

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index < 0 || index >= count() ? nullptr : items_[static_cast<std::size_t>(index)].get();
}

QLayoutItem* FlowLayout::takeAt(int index) {
    if (itemAt(index) == nullptr) return nullptr;
    QLayoutItem* taken = items_[static_cast<std::size_t>(index)].release();
    items_.erase(items_.begin() + index);
    return taken;
}

Qt::Orientations FlowLayout::expandingDirections() const { return {}; }

bool FlowLayout::hasHeightForWidth() const { return true; }

int FlowLayout::heightForWidth(int width) const { return flow(QRect(0, 0, width, 0), Place::Measure); }

QSize FlowLayout::margins() const {
    const QMargins m = contentsMargins();
    return {m.left() + m.right(), m.top() + m.bottom()};
}

QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const auto& item : items_)
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    return least + margins();
}

QSize FlowLayout::sizeHint() const {
    int width = 0;
    for (const auto& item : items_)
        if (!item->isEmpty()) width += item->sizeHint().width() + spacing();
    return {std::max(0, width - spacing()) + margins().width(), minimumSize().height()};
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    flow(rect, Place::Move);
}

// What is lower than the tallest of its line stands in the middle of it, as text beside a button should.
int FlowLayout::flow(const QRect& whole, Place place) const {
    const QRect rect = whole.marginsRemoved(contentsMargins());
    std::vector<QLayoutItem*> line;
    int x = rect.left();
    int y = rect.top();
    const auto end_line = [&] {
        int height = 0;
        for (const QLayoutItem* item : line) height = std::max(height, item->sizeHint().height());
        x = rect.left();
        for (QLayoutItem* item : line) {
            const QSize size = item->sizeHint();
            const QPoint corner(x, y + (height - size.height()) / 2);
            if (place == Place::Move)
                item->setGeometry(QRect(corner, QSize(std::min(size.width(), rect.width()), size.height())));
            x += size.width() + spacing();
        }
        x = rect.left();
        y += height + spacing();
        line.clear();
    };
    for (const auto& item : items_) {
        if (item->isEmpty()) continue; // hidden
        const int width = item->sizeHint().width();
        if (!line.empty() && x + width > rect.right() + 1) end_line();
        line.push_back(item.get());
        x += width + spacing();
    }
    if (!line.empty()) end_line();
    return std::max(0, y - rect.top() - spacing()) + margins().height();
}

} // namespace planum::gui
