// SPDX-License-Identifier: MIT
#include "gui/widgets/flat/flat_canvas.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPinchGesture>
#include <QPolygonF>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

#include "gui/viewmodels/models.hpp"
#include "gui/widgets/flat/region_look.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr double kFitMargin = 24.0; // [px]
constexpr double kSnap = 10.0;      // [px]
constexpr double kCloses = 12.0;    // [px] from the first corner

double apart(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

QPainterPath path_of(const RegionShape& shape, const QTransform& view) {
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (const PointList& ring : shape.rings) {
        if (ring.isEmpty()) continue;
        path.addPolygon(view.map(QPolygonF(ring)));
        path.closeSubpath();
    }
    return path;
}

// The nearest place for a number that hides nothing, in its region if there is one; where all is full, the first.
QRectF moved_aside(const QRectF& box, const QPainterPath& region, const QList<QRectF>& taken) {
    const double up = box.height() + 4.0;
    const double aside = 0.6 * box.width();
    QRectF outside = box;
    for (const double dy : {0.0, -up, up, -2.0 * up, 2.0 * up, -3.0 * up, 3.0 * up}) {
        for (const double dx : {0.0, -aside, aside, -2.0 * aside, 2.0 * aside}) {
            const QRectF there = box.translated(dx, dy);
            const bool is_free =
                std::none_of(taken.begin(), taken.end(), [&](const QRectF& one) { return one.intersects(there); });
            if (!is_free) continue;
            if (region.contains(there.center()) || there == box) return there;
            if (outside == box) outside = there;
        }
    }
    return outside;
}

} // namespace

FlatCanvas::FlatCanvas(Models& models, const QString& name, Up up)
    : models_(models), name_(name), up_(up), handles_(models.edit) {
    setObjectName(name + QStringLiteral("Canvas"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(200, 150);
    grabGesture(Qt::PinchGesture);
    connect(&models_.workspace, &Workspace::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&models_.workspace, &Workspace::proofChanged, this, qOverload<>(&QWidget::update));
    connect(&models_.outline, &OutlineTool::changed, this, qOverload<>(&QWidget::update));
    connect(&models_.edit, &OutlineEdit::changed, this, qOverload<>(&QWidget::update));
}

void FlatCanvas::set_shapes(std::vector<RegionShape> shapes) {
    shapes_ = std::move(shapes);
    if (fitted_) fit();
    update();
}

void FlatCanvas::set_patches(std::vector<RegionShape> patches) {
    patches_ = std::move(patches);
    update();
}

QTransform FlatCanvas::view() const {
    return {scale_, 0.0, 0.0, up_ == Up::Upwards ? -scale_ : scale_, origin_.x(), origin_.y()};
}

void FlatCanvas::fit() {
    fitted_ = true;
    const QRectF all = extent();
    if (all.isNull() || width() < 20 || height() < 20) return;
    scale_ = std::min((width() - 2.0 * kFitMargin) / std::max(all.width(), 1e-6),
                      (height() - 2.0 * kFitMargin) / std::max(all.height(), 1e-6));
    origin_ = {};
    origin_ = QRectF(rect()).center() - view().map(all.center());
    update();
}

void FlatCanvas::zoom(double factor, QPointF around) {
    const QPointF fixed = to_place(around);
    const double whole = std::max({extent().width(), extent().height(), 1e-3});
    scale_ = std::clamp(scale_ * factor, 40.0 / whole, 4.0e5 / whole);
    origin_ += around - view().map(fixed);
    fitted_ = false;
    update();
}

bool FlatCanvas::is_drawing() const { return models_.outline.is_active(name_); }

bool FlatCanvas::is_changing() const { return models_.edit.is_active(name_); }

bool FlatCanvas::is_offering() const { return models_.patches.is_active(name_); }

QPointF FlatCanvas::snapped(QPointF on_screen) const {
    const QPointF place = to_place(on_screen);
    const double near = kSnap / scale_;
    return (is_changing() ? snap(handles_.neighbours(shapes_), place, near) : snap(shapes_, place, near))
        .value_or(place);
}

void FlatCanvas::paint_shapes(QPainter& painter) const {
    const QTransform to_px = view();
    const Proof& proof = models_.workspace.proof();
    for (const RegionShape& shape : shapes_) {
        const bool in_proof =
            !shape.unit.is_nil() && std::find(proof.units.begin(), proof.units.end(), shape.unit) != proof.units.end();
        const bool selected = !shape.unit.is_nil() && shape.unit == models_.workspace.selected();
        const RegionLook look = look_of(shape);
        QColor fill = look.fill;
        if (!proof.units.empty() && !in_proof) fill.setAlphaF(fill.alphaF() * 0.35F);
        painter.setBrush(QBrush(fill, look.pattern));
        painter.setPen(QPen(in_proof   ? theme().error
                            : selected ? theme().accent
                                       : look.line,
                            in_proof || selected ? 3.0 : std::max(1.2, theme().least_line()), look.dashed));
        painter.drawPath(path_of(shape, to_px));
    }
}

// Wide hatching in the accent's colour: nobody drew this.
void FlatCanvas::paint_patches(QPainter& painter) const {
    if (!is_offering()) return;
    const QTransform to_px = view();
    const QFontMetricsF metrics(painter.font());
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const bool chosen = static_cast<int>(i) == models_.patches.chosen();
        QColor fill = theme().accent;
        fill.setAlphaF(chosen ? 0.45F : 0.18F);
        const QPainterPath path = path_of(patches_[i], to_px);
        painter.setPen(Qt::NoPen);
        painter.fillPath(path, fill);
        painter.setBrush(QBrush(theme().accent, Qt::BDiagPattern));
        painter.setPen(QPen(theme().paper, 4.0));
        painter.drawPath(path);
        painter.setPen(QPen(theme().accent, chosen ? 3.0 : 1.8, Qt::DashLine));
        painter.drawPath(path);
        if (path.isEmpty()) continue;
        QRectF box = metrics.boundingRect(patches_[i].label).translated(to_px.map(patches_[i].middle));
        box.translate(-box.width() / 2.0, metrics.ascent() / 2.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().accent);
        painter.drawRoundedRect(box.adjusted(-5.0, -2.0, 5.0, 2.0), 3.0, 3.0);
        painter.setPen(theme().on_accent);
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, patches_[i].label);
    }
}

// Numbers stand in the middle of their region, or beside it where a mark lies that they would hide.
void FlatCanvas::paint_labels(QPainter& painter) const {
    const QTransform to_px = view();
    QList<QRectF> taken = kept_free();
    const QFont plain = painter.font();
    QFont font = plain;
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    for (const RegionShape& shape : shapes_) {
        const QPointF middle = to_px.map(shape.middle);
        QRectF box = metrics.boundingRect(shape.label).translated(middle);
        box.translate(-box.width() / 2.0, metrics.ascent() / 2.0 - 1.0);
        const QRectF around = to_px.mapRect(bounds_of(std::vector<RegionShape>{shape}));
        if (around.width() < box.width() * 0.7 || around.height() < box.height() * 0.5) continue;
        box = moved_aside(box, path_of(shape, to_px), taken);
        taken << box.adjusted(-4.0, -1.0, 4.0, 1.0);
        QColor ground = theme().paper;
        ground.setAlphaF(0.85F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawRoundedRect(box.adjusted(-4.0, -1.0, 4.0, 1.0), 3.0, 3.0);
        painter.setPen(theme().ink);
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, shape.label);
    }
    painter.setFont(plain);
}

void FlatCanvas::paint_tool(QPainter& painter) const {
    if (!is_drawing()) return;
    QPolygonF line = view().map(QPolygonF(models_.outline.corners()));
    QColor fill = theme().accent;
    fill.setAlphaF(0.18F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    if (line.size() >= 3) painter.drawPolygon(line);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().paper, 5.0));
    painter.drawPolyline(line);
    painter.setPen(QPen(theme().accent, 2.5));
    painter.drawPolyline(line);
    const QPointF next = view().map(snapped(pointer_));
    painter.setPen(QPen(theme().accent, 1.5, Qt::DashLine));
    if (!line.isEmpty() && underMouse()) painter.drawLine(line.last(), next);
    painter.setPen(QPen(theme().accent, 2.0));
    painter.setBrush(theme().paper);
    for (qsizetype i = 0; i < line.size(); ++i) painter.drawEllipse(line[i], i == 0 ? 6.5 : 4.5, i == 0 ? 6.5 : 4.5);
    if (underMouse() && apart(next, pointer_) > 0.5) painter.drawRect(QRectF(next - QPointF(5, 5), QSizeF(10, 10)));
}

void FlatCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), up_ == Up::Upwards ? theme().paper : theme().window);
    if (extent().isNull()) {
        painter.setPen(theme().faint);
        painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, empty_text());
        return;
    }
    painter.save();
    painter.setTransform(view(), true);
    paint_ground(painter, QRectF(to_place({0.0, 0.0}), to_place(QPointF(width(), height()))).normalized());
    painter.restore();
    painter.setRenderHint(QPainter::Antialiasing);
    paint_shapes(painter);
    paint_over(painter);
    paint_labels(painter);
    paint_patches(painter);
    paint_tool(painter);
    if (is_changing()) handles_.paint(painter, view(), pointer_);
}

void FlatCanvas::wheelEvent(QWheelEvent* event) {
    zoom(std::pow(1.22, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

void FlatCanvas::mousePressEvent(QMouseEvent* event) {
    setFocus();
    if (is_changing() && event->button() == Qt::LeftButton && handles_.press(view(), event->position())) return;
    pressed_ = event->position();
    origin_when_pressed_ = origin_;
    dragging_ = false;
}

void FlatCanvas::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    emit hovered(to_place(pointer_));
    if (is_changing() && handles_.drag(snapped(pointer_))) return;
    if (pressed_ && (dragging_ || (pointer_ - *pressed_).manhattanLength() >= QApplication::startDragDistance())) {
        dragging_ = true;
        fitted_ = false;
        origin_ = origin_when_pressed_ + (pointer_ - *pressed_);
        update();
    }
    if (is_drawing() || is_changing()) update();
    setCursor(is_drawing() ? Qt::CrossCursor : dragging_ ? Qt::ClosedHandCursor : Qt::ArrowCursor);
}

void FlatCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (handles_.release()) return;
    const bool click = pressed_ && !dragging_;
    pressed_.reset();
    dragging_ = false;
    if (!click) return;
    if (is_drawing()) {
        OutlineTool& tool = models_.outline;
        if (event->button() == Qt::RightButton) return tool.finish();
        const bool closes = tool.can_finish() && apart(to_screen(tool.corners().front()), event->position()) < kCloses;
        return closes ? tool.finish() : tool.add(snapped(event->position()));
    }
    const RegionShape* under = region_under(shapes_, to_place(event->position()));
    if (is_changing()) return handles_.click(view(), *event, under);
    if (is_offering()) {
        const RegionShape* patch = region_under(patches_, to_place(event->position()));
        if (patch != nullptr) return models_.patches.choose(static_cast<int>(patch - patches_.data()));
    }
    if (under != nullptr && !under->unit.is_nil()) models_.workspace.select(under->unit);
}

void FlatCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!is_drawing() && !is_changing()) zoom(1.8, event->position());
}

void FlatCanvas::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = QRectF(rect()).center();
    if (is_changing() && handles_.key(*event)) return;
    if (is_offering()) {
        PatchModel& offered = models_.patches;
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return offered.finish();
        if (event->key() == Qt::Key_Escape) return offered.chosen() < 0 ? offered.end() : offered.choose(-1);
    }
    if (is_drawing()) {
        OutlineTool& tool = models_.outline;
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return tool.finish();
        if (event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete) return tool.take_back();
        if (event->key() == Qt::Key_Escape) return tool.cancel();
        if (event->matches(QKeySequence::Undo)) return tool.take_back();
        if (event->matches(QKeySequence::Redo)) return tool.take_forward();
    }
    constexpr double kStep = 80.0;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoom(1.25, middle);
    case Qt::Key_Minus: return zoom(0.8, middle);
    case Qt::Key_Home:
    case Qt::Key_F: return fit();
    case Qt::Key_Left: origin_.rx() += kStep; break;
    case Qt::Key_Right: origin_.rx() -= kStep; break;
    case Qt::Key_Up: origin_.ry() += kStep; break;
    case Qt::Key_Down: origin_.ry() -= kStep; break;
    default: QWidget::keyPressEvent(event); return;
    }
    fitted_ = false;
    update();
}

void FlatCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (fitted_) fit();
}

bool FlatCanvas::event(QEvent* event) {
    // Ctrl+Z takes a corner back while somebody draws, not the last change of the record.
    if (event->type() == QEvent::ShortcutOverride && (is_drawing() || is_changing())) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::Gesture) {
        if (auto* pinch = static_cast<QPinchGesture*>(static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture))) {
            zoom(pinch->scaleFactor(), mapFromGlobal(pinch->centerPoint()));
            return true;
        }
    }
    return QWidget::event(event);
}

} // namespace planum::gui
