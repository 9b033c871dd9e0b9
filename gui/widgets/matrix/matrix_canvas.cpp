// SPDX-License-Identifier: MIT
#include "gui/widgets/matrix/matrix_canvas.hpp"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPinchGesture>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/viewmodels/words.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr double kLeast = 0.005;
constexpr double kMost = 8.0;
constexpr double kFitMargin = 12.0; // [px]

QRectF rect(const strat::DrawRect& r) { return {r.x, r.y, r.width, r.height}; }

} // namespace

MatrixCanvas::MatrixCanvas(MatrixModel& model) : model_(model) {
    setObjectName(QStringLiteral("matrixCanvas"));
    setAccessibleName(tr("Drawing of the matrix"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(200, 150);
    setAttribute(Qt::WA_OpaquePaintEvent);
    grabGesture(Qt::PinchGesture);
    model_.set_prepare([](std::shared_ptr<const strat::MatrixDrawing> drawing, const LineVerdicts& verdicts) {
        return std::static_pointer_cast<const void>(std::make_shared<const MatrixInk>(std::move(drawing), verdicts));
    });
    connect(&model_, &MatrixModel::drawn, this, &MatrixCanvas::take_drawing);
    connect(&model_, &MatrixModel::pointedOut, this, qOverload<>(&QWidget::update));
    take_drawing();
}

void MatrixCanvas::take_drawing() {
    const bool first = drawing_ == nullptr;
    drawing_ = model_.drawing();
    ink_ = std::static_pointer_cast<const MatrixInk>(model_.prepared());
    hovered_ = MatrixInk::kNone;
    setAccessibleDescription(drawing_ ? qt(drawing_->description) : QString());
    if (drawing_ && (first || fitted_)) fit();
    update();
}

QRectF MatrixCanvas::seen() const {
    return {to_drawing({0.0, 0.0}), to_drawing({static_cast<double>(width()), static_cast<double>(height())})};
}

void MatrixCanvas::fit() {
    fitted_ = true;
    if (!drawing_ || width() < 10) return;
    show_rect(QRectF(0.0, 0.0, drawing_->width, drawing_->height), 1.6);
    fitted_ = true;
}

void MatrixCanvas::show_rect(const QRectF& in_drawing, double most_scale) {
    const double fits = std::min((width() - 2.0 * kFitMargin) / std::max(in_drawing.width(), 1.0),
                                 (height() - 2.0 * kFitMargin) / std::max(in_drawing.height(), 1.0));
    scale_ = std::clamp(fits, kLeast, most_scale);
    origin_ = rect().center() - in_drawing.center() * scale_;
    update();
}

void MatrixCanvas::zoom(double factor, QPointF around) {
    const QPointF fixed = to_drawing(around);
    scale_ = std::clamp(scale_ * factor, kLeast, kMost);
    origin_ = around - fixed * scale_;
    fitted_ = false;
    keep_in_sight();
    update();
}

// At least a strip of the drawing stays in the window.
void MatrixCanvas::keep_in_sight() {
    if (!drawing_) return;
    constexpr double kStrip = 60.0;
    origin_.setX(std::clamp(origin_.x(), kStrip - drawing_->width * scale_, width() - kStrip));
    origin_.setY(std::clamp(origin_.y(), kStrip - drawing_->height * scale_, height() - kStrip));
}

QRectF MatrixCanvas::box_on_screen(std::size_t box) const {
    const QRectF r = gui::rect(drawing_->boxes.at(box).rect);
    return {origin_ + r.topLeft() * scale_, r.size() * scale_};
}

void MatrixCanvas::show_selected() {
    const auto box = model_.selected_box();
    if (!box || !drawing_) return;
    const QRectF there = box_on_screen(*box);
    if (QRectF(rect()).adjusted(20, 20, -20, -20).contains(there) && there.height() > 9.0) return;
    fitted_ = false;
    scale_ = std::clamp(std::max(scale_, 0.8), kLeast, kMost);
    origin_ = QRectF(rect()).center() - gui::rect(drawing_->boxes[*box].rect).center() * scale_;
    update();
}

void MatrixCanvas::show_proof() {
    if (!drawing_ || model_.proof_boxes().empty()) return;
    QRectF all;
    for (const std::size_t box : model_.proof_boxes()) all = all.united(gui::rect(drawing_->boxes[box].rect));
    for (const std::size_t line : model_.proof_lines()) {
        for (const strat::DrawPoint& p : drawing_->lines[line].points) {
            all = all.united(QRectF(p.x - 4.0, p.y - 4.0, 8.0, 8.0));
        }
    }
    fitted_ = false;
    show_rect(all.adjusted(-30.0, -30.0, 30.0, 30.0), 1.5);
}

std::optional<std::size_t> MatrixCanvas::box_at(QPointF on_screen) const {
    if (!drawing_) return std::nullopt;
    const QPointF at = to_drawing(on_screen);
    return model_.index().box_at({at.x(), at.y()});
}

void MatrixCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme().window);
    if (!drawing_ || !ink_ || drawing_->boxes.empty()) {
        painter.setPen(theme().faint);
        const QString none = drawing_ ? tr("No units to draw. Import lists of units and relations, or add a unit in "
                                           "the record card.")
                                      : tr("No drawing yet.");
        const QString text = model_.trouble().isEmpty() ? none : model_.trouble();
        painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, text);
        return;
    }
    const QRectF page(0.0, 0.0, drawing_->width, drawing_->height);
    const QRectF part = seen().intersected(page);
    painter.translate(origin_);
    painter.scale(scale_, scale_);
    painter.setClipRect(page);
    const QImage& overview = ink_->overview();
    if (!overview.isNull() && scale_ <= ink_->overview_scale() * 1.05) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, scale_ > ink_->overview_scale() * 0.15);
        painter.drawImage(page, overview);
    } else {
        ink_->paint(painter, part, scale_);
    }
    MatrixInk::Pointed pointed;
    pointed.selected = model_.selected_box().value_or(MatrixInk::kNone);
    pointed.hovered = hovered_;
    pointed.proof_boxes = &model_.proof_boxes();
    pointed.proof_lines = &model_.proof_lines();
    ink_->paint_pointed(painter, part, scale_, pointed);
    if (!from_box_ || !dragging_) return;
    painter.setPen(QPen(theme().accent, 2.0 / scale_, Qt::DashLine));
    painter.drawLine(gui::rect(drawing_->boxes[*from_box_].rect).center(), to_drawing(pointer_));
}

void MatrixCanvas::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        origin_ += QPointF(steps * 60.0, 0.0);
        keep_in_sight();
        update();
    } else {
        zoom(std::pow(1.22, steps), event->position());
    }
    event->accept();
}

void MatrixCanvas::mousePressEvent(QMouseEvent* event) {
    setFocus();
    pressed_ = event->position();
    origin_when_pressed_ = origin_;
    dragging_ = false;
    from_box_ = event->button() == Qt::LeftButton ? box_at(event->position()) : std::nullopt;
}

void MatrixCanvas::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    if (!pressed_) {
        const std::size_t now = box_at(pointer_).value_or(MatrixInk::kNone);
        if (now != hovered_) update();
        hovered_ = now;
        setCursor(now == MatrixInk::kNone ? Qt::OpenHandCursor : Qt::PointingHandCursor);
        return;
    }
    if (!dragging_ && (pointer_ - *pressed_).manhattanLength() < QApplication::startDragDistance()) return;
    dragging_ = true;
    if (!from_box_) {
        fitted_ = false;
        origin_ = origin_when_pressed_ + (pointer_ - *pressed_);
        keep_in_sight();
        setCursor(Qt::ClosedHandCursor);
    } else {
        hovered_ = box_at(pointer_).value_or(MatrixInk::kNone);
    }
    update();
}

void MatrixCanvas::mouseReleaseEvent(QMouseEvent* event) {
    const auto box = box_at(event->position());
    if (!dragging_ && box && event->button() == Qt::LeftButton) model_.select_box(*box);
    if (dragging_ && from_box_ && box && *box != *from_box_) {
        const auto& from = drawing_->boxes[*from_box_].units;
        const auto& to = drawing_->boxes[*box].units;
        if (!from.empty() && !to.empty()) {
            emit relationWanted(from.front(), to.front(), event->globalPosition().toPoint());
        }
    }
    pressed_.reset();
    from_box_.reset();
    dragging_ = false;
    setCursor(Qt::OpenHandCursor);
    update();
}

void MatrixCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!box_at(event->position())) zoom(1.8, event->position());
}

void MatrixCanvas::leaveEvent(QEvent*) {
    hovered_ = MatrixInk::kNone;
    update();
}

// Arrows walk along the orders where a unit is selected, else they move the drawing.
void MatrixCanvas::walk(int key) {
    const auto box = model_.selected_box();
    if (!box) {
        constexpr double kStep = 80.0;
        origin_ += QPointF(key == Qt::Key_Left    ? kStep
                           : key == Qt::Key_Right ? -kStep
                                                  : 0.0,
                           key == Qt::Key_Up     ? kStep
                           : key == Qt::Key_Down ? -kStep
                                                 : 0.0);
        keep_in_sight();
        update();
        return;
    }
    const strat::DrawRect from = drawing_->boxes[*box].rect;
    std::size_t best = MatrixInk::kNone;
    double least = 1e18;
    const auto consider = [&](std::size_t other) {
        const strat::DrawPoint c = drawing_->boxes[other].rect.centre();
        const double d = std::hypot(c.x - from.centre().x, c.y - from.centre().y);
        if (d < least) {
            least = d;
            best = other;
        }
    };
    if (key == Qt::Key_Down) {
        for (const std::size_t line : model_.index().lines_below(*box)) consider(drawing_->lines[line].earlier);
    } else if (key == Qt::Key_Up) {
        for (const std::size_t line : model_.index().lines_above(*box)) consider(drawing_->lines[line].later);
    } else {
        for (std::size_t i = 0; i < drawing_->boxes.size(); ++i) {
            const strat::DrawRect& r = drawing_->boxes[i].rect;
            const bool level = std::abs(r.centre().y - from.centre().y) < from.height;
            const bool side = key == Qt::Key_Left ? r.centre().x < from.x : r.centre().x > from.right();
            if (i != *box && level && side) consider(i);
        }
    }
    if (best == MatrixInk::kNone) return;
    model_.select_box(best);
    show_selected();
}

void MatrixCanvas::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = QRectF(rect()).center();
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoom(1.25, middle);
    case Qt::Key_Minus: return zoom(0.8, middle);
    case Qt::Key_Home:
    case Qt::Key_F: return fit();
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        if (drawing_) walk(event->key());
        return;
    default: QWidget::keyPressEvent(event);
    }
}

void MatrixCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (fitted_) fit();
}

bool MatrixCanvas::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto box = box_at(help->pos());
        QToolTip::showText(help->globalPos(), box ? qt(drawing_->boxes[*box].title) : QString(), this);
        return true;
    }
    if (event->type() == QEvent::Gesture) {
        if (auto* pinch = static_cast<QPinchGesture*>(static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture))) {
            zoom(pinch->scaleFactor(), mapFromGlobal(pinch->centerPoint()));
            return true;
        }
    }
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) model_.prepare_again();
    return QWidget::event(event);
}

} // namespace planum::gui
