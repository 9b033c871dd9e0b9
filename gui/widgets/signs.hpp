// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QRectF>

#include "core/model/diagnostic.hpp"

class QPainter;

namespace planum::gui {

[[nodiscard]] QColor severity_colour(model::Severity severity);

/// The sign of a severity: error a filled octagon with a bar, warning a triangle, remark a ring. Shapes differ, so that
/// it reads without colour. An invalid colour means the theme's own.
void paint_severity(QPainter& painter, const QRectF& box, model::Severity severity, const QColor& colour = {});

} // namespace planum::gui
