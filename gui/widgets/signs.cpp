// SPDX-License-Identifier: MIT
#include "gui/widgets/signs.hpp"

#include <QPainter>
#include <QPen>
#include <QPolygonF>

#include <cmath>
#include <numbers>

#include "gui/widgets/theme.hpp"

namespace planum::gui {

QColor severity_colour(model::Severity severity) {
    switch (severity) {
    case model::Severity::Error: return theme().error;
    case model::Severity::Warning: return theme().warning;
    case model::Severity::Info: return theme().remark;
    }
    return theme().ink;
}

void paint_severity(QPainter& painter, const QRectF& box, model::Severity severity, const QColor& colour) {
    const QColor ink = colour.isValid() ? colour : severity_colour(severity);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF c = box.center();
    const double r = box.width() / 2.0;
    if (severity == model::Severity::Error) {
        QPolygonF octagon;
        for (int i = 0; i < 8; ++i) {
            const double a = (i + 0.5) * std::numbers::pi / 4.0;
            octagon << c + QPointF(std::cos(a), std::sin(a)) * r;
        }
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawPolygon(octagon);
        painter.setPen(QPen(colour.isValid() ? theme().accent : theme().paper, r * 0.36));
        painter.drawLine(c - QPointF(r * 0.5, 0.0), c + QPointF(r * 0.5, 0.0));
    } else if (severity == model::Severity::Warning) {
        painter.setPen(QPen(ink, r * 0.32, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(
            QPolygonF({c + QPointF(0.0, -r * 0.8), c + QPointF(r * 0.9, r * 0.75), c + QPointF(-r * 0.9, r * 0.75)}));
    } else {
        painter.setPen(QPen(ink, r * 0.28));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(c, r * 0.7, r * 0.7);
    }
    painter.restore();
}

} // namespace planum::gui
