// SPDX-License-Identifier: MIT
#include "gui/widgets/flat/outline_handles.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "gui/viewmodels/outline_edit.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

// As far from its middle as a finger misses a dot.
double reach() { return 0.5 * theme().touch; }

double scale_of(const QTransform& view) { return std::abs(view.m11()); }

} // namespace

void OutlineHandles::paint(QPainter& painter, const QTransform& view, QPointF pointer) const {
    const double corner_size = theme().touch >= 40 ? 9.0 : 6.5;
    const auto under = edit_.corner_at(view.inverted().map(pointer), reach() / scale_of(view));
    for (std::size_t r = 0; r < edit_.rings().size(); ++r) {
        const OutlineEdit::Ring& ring = edit_.rings()[r];
        for (std::size_t c = 0; c < ring.size(); ++c) {
            const auto middle = edit_.middle_of({r, c});
            if (!middle) continue;
            const QPointF from = view.map(ring[c].at);
            const QPointF to = view.map(ring[(c + 1) % ring.size()].at);
            const bool untouched = ring[c].runs_to && ring[c].runs_to == ring[(c + 1) % ring.size()].original;
            painter.setPen(QPen(theme().paper, untouched ? 3.5 : 5.0));
            painter.drawLine(from, to);
            painter.setPen(QPen(theme().accent, untouched ? 1.5 : 2.5));
            painter.drawLine(from, to);
            if (std::hypot(to.x() - from.x(), to.y() - from.y()) < 3.0 * corner_size) continue;
            painter.setPen(QPen(theme().accent, 1.5));
            painter.setBrush(theme().paper);
            painter.drawEllipse(view.map(*middle), corner_size * 0.5, corner_size * 0.5);
        }
        for (std::size_t c = 0; c < ring.size(); ++c) {
            if (!ring[c].seen) continue;
            const OutlineEdit::Handle here{r, c};
            const bool held = edit_.held() == here;
            painter.setPen(QPen(theme().accent, 2.0));
            painter.setBrush(held ? theme().accent : theme().paper);
            const double size = held || under == here ? corner_size * 1.25 : corner_size;
            painter.drawEllipse(view.map(ring[c].at), size, size);
        }
    }
}

bool OutlineHandles::press(const QTransform& view, QPointF on_screen) {
    const QPointF place = view.inverted().map(on_screen);
    const double near = reach() / scale_of(view);
    if (const auto corner = edit_.corner_at(place, near)) {
        edit_.grab(*corner);
        taken_ = true;
    } else if (const auto line = edit_.middle_at(place, near)) {
        edit_.insert(*line, *edit_.middle_of(*line));
        taken_ = true;
    }
    return taken_;
}

bool OutlineHandles::drag(QPointF place) {
    if (taken_) edit_.move(place);
    return taken_;
}

bool OutlineHandles::release() { return std::exchange(taken_, false); }

void OutlineHandles::click(const QTransform& view, const QMouseEvent& event, const RegionShape* under) {
    if (event.button() == Qt::RightButton) {
        const auto corner = edit_.corner_at(view.inverted().map(event.position()), reach() / scale_of(view));
        if (corner) edit_.remove(*corner);
        return;
    }
    // What is changed already is finished or given up first.
    if (under != nullptr && !edit_.is_changed()) edit_.choose(under->region);
}

bool OutlineHandles::key(const QKeyEvent& event) {
    if (event.matches(QKeySequence::Undo)) {
        edit_.take_back();
    } else if (event.matches(QKeySequence::Redo)) {
        edit_.take_forward();
    } else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        edit_.finish();
    } else if (event.key() == Qt::Key_Escape) {
        edit_.cancel();
    } else if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace) {
        if (edit_.can_remove()) edit_.remove(*edit_.held());
    } else {
        return false;
    }
    return true;
}

std::vector<RegionShape> OutlineHandles::neighbours(const std::vector<RegionShape>& shapes) const {
    std::vector<RegionShape> others;
    std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(others),
                 [&](const RegionShape& shape) { return shape.region != edit_.region(); });
    return others;
}

} // namespace planum::gui
