// SPDX-License-Identifier: MIT
#include "paint/drawing_painter.hpp"

#include <QFontMetricsF>
#include <QLineF>
#include <QList>
#include <QPainter>
#include <QPainterPath>
#include <QPen>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_style.hpp"

namespace planum::paint {

using namespace strat;

namespace {

QColor colour(Colour value) { return QColor::fromRgb(value); }

QPointF point(const DrawPoint& p) { return {p.x, p.y}; }

QPolygonF polygon(const std::vector<DrawPoint>& points) {
    QPolygonF q;
    q.reserve(static_cast<qsizetype>(points.size()));
    for (const DrawPoint& p : points) q << point(p);
    return q;
}

QPen pen_of(const StrokeStyle& stroke) {
    QPen pen(colour(stroke.colour));
    pen.setWidthF(stroke.width);
    pen.setJoinStyle(Qt::MiterJoin);
    pen.setCapStyle(Qt::FlatCap);
    if (stroke.dash != Dash::Solid) {
        QList<qreal> pattern; // Qt counts in pen widths
        for (const double length : pattern_of(stroke.dash)) pattern.push_back(length / stroke.width);
        pen.setDashPattern(pattern);
    }
    return pen;
}

QRectF rect(const DrawRect& r) { return {r.x, r.y, r.width, r.height}; }

void paint_shape(QPainter& painter, const DrawnBox& box) {
    const BoxOutline outline = outline_of(box);
    const BoxStyle style = style_of(box);
    StrokeStyle stroke = style.stroke;
    stroke.width = std::max(stroke.width, outline.stroke_width);
    painter.setPen(pen_of(stroke));
    painter.setBrush(colour(style.fill));
    painter.drawPolygon(polygon(outline.polygon));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen_of({stroke.colour, style::kLineWidth, Dash::Solid}));
    for (const std::vector<DrawPoint>& inner : outline.strokes) painter.drawPolyline(polygon(inner));
    if (box.has_finds) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour(stroke.colour));
        painter.drawPolygon(polygon(finds_mark(box.rect)));
    }
}

void paint_label(QPainter& painter, const DrawnBox& box) {
    const double top = box.rect.centre().y - style::kLineHeight * static_cast<double>(box.lines.size() - 1) / 2.0;
    for (std::size_t i = 0; i < box.lines.size() && i < box.line_widths.size(); ++i) {
        PaintedText text;
        text.text = box.lines[i];
        text.at = {box.rect.centre().x, top + style::kLineHeight * static_cast<double>(i) + box.text_size * 0.36};
        text.size = box.text_size;
        text.width = box.line_widths[i];
        text.anchor = TextAnchor::Middle;
        text.colour = style_of(box).text;
        paint_text(painter, text);
    }
}

void paint_arrow(QPainter& painter, const DrawnLine& line) {
    const std::vector<DrawPoint> arrow = arrow_head(line);
    if (arrow.empty()) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour(style_of(line).colour));
    painter.drawPolygon(polygon(arrow));
}

void paint_line(QPainter& painter, const DrawnLine& line) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen_of(style_of(line)));
    painter.drawPolyline(polygon(line.points));
    paint_arrow(painter, line);
}

// Solid lines of one colour as one ink: strokes that several orders share would else grow dark at their
// edges, once for each order. Slanting lines (of other engines) are painted as they are.
void paint_lines(QPainter& painter, const MatrixDrawing& drawing, bool red) {
    std::map<std::pair<Colour, double>, std::array<std::vector<AxisStroke>, 2>> inks; // uprights, levels
    for (const DrawnLine& line : drawing.lines) {
        const StrokeStyle style = style_of(line);
        if ((line.in_cycle || line.upwards) != red) continue;
        const bool square = std::adjacent_find(line.points.begin(), line.points.end(),
                                               [](const auto& a, const auto& b) { return a.x != b.x && a.y != b.y; }) ==
                            line.points.end();
        if (!square || style.dash != Dash::Solid) {
            paint_line(painter, line);
            continue;
        }
        paint_arrow(painter, line);
        auto& [uprights, levels] = inks[{style.colour, style.width}];
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const DrawPoint& a = line.points[i - 1];
            const DrawPoint& b = line.points[i];
            if (a.x == b.x) {
                uprights.push_back({a.x, std::min(a.y, b.y), std::max(a.y, b.y)});
            } else {
                levels.push_back({a.y, std::min(a.x, b.x), std::max(a.x, b.x)});
            }
        }
    }
    for (auto& [look, strokes] : inks) {
        QPen pen = pen_of({look.first, look.second, Dash::Solid});
        pen.setCapStyle(Qt::SquareCap); // closes the corners
        painter.setPen(pen);
        QList<QLineF> lines;
        constexpr double kTouch = 0.05;
        for (const AxisStroke& s : joined_strokes(std::move(strokes[0]), kTouch))
            lines << QLineF(s.at, s.low, s.at, s.high);
        for (const AxisStroke& s : joined_strokes(std::move(strokes[1]), kTouch))
            lines << QLineF(s.low, s.at, s.high, s.at);
        painter.drawLines(lines);
    }
}

void paint_ground(QPainter& painter, const MatrixDrawing& drawing) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour(kPaper));
    painter.drawRect(QRectF(0.0, 0.0, drawing.width, drawing.height));
    for (const DrawnBand& band : drawing.bands) {
        painter.setPen(pen_of({kBandEdge, 0.5, Dash::Solid}));
        painter.setBrush(colour(band.shaded ? kBandShade : kPaper));
        painter.drawRect(rect(band.rect));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen_of({kFrameEdge, 1.0, Dash::Solid}));
    for (const DrawnFrame& frame : drawing.frames) painter.drawRoundedRect(rect(frame.rect), 4.0, 4.0);
}

void paint_words(QPainter& painter, const DrawnText& t) {
    const bool strong = t.role == "title" || t.role == "legend";
    const PaintedText text{t.text,
                           t.at,
                           t.size,
                           t.width,
                           t.anchor,
                           t.bold ? FontWeight::Bold : FontWeight::Regular,
                           strong ? kInk : kFaintInk};
    if (!t.upright) {
        paint_text(painter, text);
        return;
    }
    painter.save();
    painter.translate(t.at.x, t.at.y);
    painter.rotate(-90.0);
    painter.translate(-t.at.x, -t.at.y);
    paint_text(painter, text);
    painter.restore();
}

} // namespace

QFont drawing_font(FontWeight weight) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(kFontPixels);
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setBold(weight == FontWeight::Bold);
    return font;
}

void paint_text(QPainter& painter, const PaintedText& text) {
    const QString words = QString::fromUtf8(text.text.data(), static_cast<qsizetype>(text.text.size()));
    const QFont font = drawing_font(text.weight);
    const double natural = QFontMetricsF(font).horizontalAdvance(words);
    const double scale = text.size / kFontPixels;
    const double stretch = text.width > 0.0 && natural > 0.0 ? text.width / (natural * scale) : 1.0;
    const double width = natural * scale * stretch;
    double x = text.at.x;
    if (text.anchor == TextAnchor::Middle) x -= width / 2.0;
    if (text.anchor == TextAnchor::End) x -= width;
    painter.save();
    painter.translate(x, text.at.y);
    painter.scale(scale * stretch, scale);
    painter.setFont(font);
    painter.setPen(colour(text.colour));
    painter.drawText(QPointF(0.0, 0.0), words);
    painter.restore();
}

void paint_sample(QPainter& painter, const LegendSample& sample) {
    if (sample.kind == LegendSample::Kind::Box) {
        paint_shape(painter, sample.box);
    } else {
        paint_line(painter, sample.line);
    }
}

void paint_drawing(QPainter& painter, const MatrixDrawing& drawing) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    paint_ground(painter, drawing);
    // Cycles last, so that no other line hides them.
    for (const bool red : {false, true}) paint_lines(painter, drawing, red);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour(kLineInk));
    for (const DrawPoint& p : drawing.junctions) painter.drawEllipse(point(p), kJunctionRadius, kJunctionRadius);
    for (const DrawnBox& box : drawing.boxes) {
        paint_shape(painter, box);
        paint_label(painter, box);
    }
    for (const LegendSample& sample : drawing.legend) paint_sample(painter, sample);
    for (const DrawnText& t : drawing.texts) paint_words(painter, t);
}

} // namespace planum::paint
