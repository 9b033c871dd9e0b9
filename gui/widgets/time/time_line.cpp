// SPDX-License-Identifier: MIT
#include "gui/widgets/time/time_line.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

#include "gui/viewmodels/time_model.hpp"
#include "gui/widgets/theme.hpp"

namespace planum::gui {

namespace {

constexpr double kSide = 70.0; // [px] left and right of the line
constexpr double kLine = 16.0; // [px] from the top

} // namespace

TimeLine::TimeLine(TimeModel& time) : time_(time) {
    setObjectName(QStringLiteral("timeLine"));
    setAccessibleName(tr("Surfaces in time"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&time_, &TimeModel::changed, this, &TimeLine::refresh);
    connect(&time_, &TimeModel::moved, this, &TimeLine::refresh);
    refresh();
}

QSize TimeLine::sizeHint() const { return {400, std::max(46, theme().touch + 8)}; }

void TimeLine::refresh() {
    setVisible(!time_.stops().empty());
    if (time_.current() >= 0) {
        const TimeModel::Stop& stop = time_.stops()[static_cast<std::size_t>(time_.current())];
        setAccessibleDescription(stop.name + QStringLiteral(", ") + stop.detail);
    }
    update();
}

double TimeLine::x_of(int stop) const {
    const auto count = static_cast<double>(time_.stops().size());
    if (count < 2.0) return width() / 2.0;
    return kSide + (width() - 2.0 * kSide) * stop / (count - 1.0);
}

int TimeLine::stop_at(double x) const {
    const int count = static_cast<int>(time_.stops().size());
    if (count < 2) return 0;
    const double share = (x - kSide) / std::max(width() - 2.0 * kSide, 1.0);
    return std::clamp(static_cast<int>(std::lround(share * (count - 1))), 0, count - 1);
}

void TimeLine::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme().window);
    painter.setPen(QPen(theme().edge, 1.0));
    painter.drawLine(0, 0, width(), 0);
    const int count = static_cast<int>(time_.stops().size());
    painter.setPen(QPen(theme().faint, 2.0));
    painter.drawLine(QPointF(x_of(0), kLine), QPointF(x_of(count - 1), kLine));
    double free_from = 0.0;
    const auto name_of = [&](int i) { return time_.stops()[static_cast<std::size_t>(i)].name; };
    // The current one's name first, then as many others as there is room for.
    const QFontMetricsF metrics(font());
    const double current_half = metrics.horizontalAdvance(name_of(time_.current())) / 2.0 + 10.0;
    for (int i = 0; i < count; ++i) {
        const bool current = i == time_.current();
        const double x = x_of(i);
        painter.setPen(QPen(current ? theme().accent : theme().faint, 2.0));
        painter.setBrush(current ? theme().accent : theme().paper);
        painter.drawEllipse(QPointF(x, kLine), current ? 8.0 : 5.0, current ? 8.0 : 5.0);
        const double half = metrics.horizontalAdvance(name_of(i)) / 2.0 + 4.0;
        const double current_x = x_of(time_.current());
        const bool hides_current =
            !current && x + half > current_x - current_half && x - half < current_x + current_half;
        if (!current && (x - half < free_from || hides_current)) continue;
        painter.setPen(current ? theme().ink : theme().faint);
        painter.drawText(QRectF(x - half, kLine + 9.0, 2.0 * half, metrics.height()), Qt::AlignCenter, name_of(i));
        free_from = x + half;
    }
}

void TimeLine::mousePressEvent(QMouseEvent* event) { time_.go_to(stop_at(event->position().x())); }

void TimeLine::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) time_.go_to(stop_at(event->position().x()));
}

void TimeLine::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left: return time_.go_to(time_.current() - 1);
    case Qt::Key_Right: return time_.go_to(time_.current() + 1);
    case Qt::Key_Home: return time_.go_to(0);
    case Qt::Key_End: return time_.go_to(static_cast<int>(time_.stops().size()) - 1);
    default: QWidget::keyPressEvent(event);
    }
}

bool TimeLine::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && !time_.stops().empty()) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto& stop = time_.stops()[static_cast<std::size_t>(stop_at(help->pos().x()))];
        QToolTip::showText(help->globalPos(),
                           stop.name + QLatin1Char('\n') + stop.day + QLatin1Char('\n') + stop.detail, this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace planum::gui
