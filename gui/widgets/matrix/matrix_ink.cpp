// SPDX-License-Identifier: MIT
#include "gui/widgets/matrix/matrix_ink.hpp"

#include <QPainter>
#include <QPen>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "gui/widgets/theme.hpp"
#include "paint/drawing_painter.hpp"
#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_style.hpp"

namespace planum::gui {

using namespace strat;

namespace {

constexpr double kReadable = 4.2; // text lower than so many pixels is left out
constexpr double kShaped = 6.0;   // boxes lower than that are plain rectangles
constexpr double kSmooth = 0.35;  // pixels a point below which antialiasing costs more than it shows
constexpr double kFaint = 0.75;   // [pt] thinner lines than this say least
constexpr double kOverviewPixels = 4096.0;
constexpr double kManyLines = 2000.0; // below that a frame needs no overview

QPointF point(const DrawPoint& p) { return {p.x, p.y}; }

QRectF rect(const DrawRect& r) { return {r.x, r.y, r.width, r.height}; }

QPolygonF polygon(const std::vector<DrawPoint>& points) {
    QPolygonF q;
    q.reserve(static_cast<qsizetype>(points.size()));
    for (const DrawPoint& p : points) q << point(p);
    return q;
}

bool is_square(const DrawnLine& line) {
    return std::adjacent_find(line.points.begin(), line.points.end(), [](const DrawPoint& a, const DrawPoint& b) {
               return a.x != b.x && a.y != b.y;
           }) == line.points.end();
}

// Bounds of a line may have no width: QRectF::intersects calls those empty.
bool meets(const QRectF& seen, const QPointF& a, const QPointF& b) {
    return std::max(a.x(), b.x()) >= seen.left() && std::min(a.x(), b.x()) <= seen.right() &&
           std::max(a.y(), b.y()) >= seen.top() && std::min(a.y(), b.y()) <= seen.bottom();
}

QPen pen_of(const StrokeStyle& stroke, double scale, double stronger) {
    double width = stroke.width * stronger;
    width = std::max(width, theme().least_line() / scale);
    QPen pen(theme().drawn(stroke.colour));
    // Thinner than a pixel would fade away; a hair line stays visible.
    if (width * scale < 1.0) {
        pen.setWidth(0);
    } else {
        pen.setWidthF(width);
    }
    pen.setJoinStyle(Qt::MiterJoin);
    pen.setCapStyle(Qt::FlatCap);
    if (stroke.dash != Dash::Solid && width * scale >= 0.4) {
        QList<qreal> pattern; // Qt counts in pen widths
        for (const double length : pattern_of(stroke.dash)) pattern.push_back(length / width);
        pen.setWidthF(width);
        pen.setDashPattern(pattern);
    }
    return pen;
}

} // namespace

StrokeStyle MatrixInk::look(std::size_t line) const {
    return verdicts_.empty() ? style_of(drawing_->lines[line]) : style_of(verdicts_[line]);
}

MatrixInk::MatrixInk(std::shared_ptr<const MatrixDrawing> made, LineVerdicts verdicts)
    : drawing_(std::move(made)), verdicts_(std::move(verdicts)) {
    const MatrixDrawing& drawing = *drawing_;
    std::map<std::pair<Colour, double>, std::array<std::vector<AxisStroke>, 2>> inks;
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
        const DrawnLine& line = drawing.lines[i];
        const StrokeStyle style = look(i);
        if (line.upwards) arrows_.push_back(i);
        if (style.dash != Dash::Solid || !is_square(line)) {
            other_lines_.push_back(i);
            other_bounds_.push_back(polygon(line.points).boundingRect());
            continue;
        }
        auto& [uprights, levels] = inks[{style.colour, style.width}];
        for (std::size_t p = 1; p < line.points.size(); ++p) {
            const DrawPoint& a = line.points[p - 1];
            const DrawPoint& b = line.points[p];
            if (a.x == b.x) {
                uprights.push_back({a.x, std::min(a.y, b.y), std::max(a.y, b.y)});
            } else {
                levels.push_back({a.y, std::min(a.x, b.x), std::max(a.x, b.x)});
            }
        }
    }
    constexpr double kTouch = 0.05;
    for (auto& [look, strokes] : inks) {
        for (const AxisStroke& s : joined_strokes(std::move(strokes[0]), kTouch)) {
            strokes_.push_back({look.first, look.second, QLineF(s.at, s.low, s.at, s.high)});
        }
        for (const AxisStroke& s : joined_strokes(std::move(strokes[1]), kTouch)) {
            strokes_.push_back({look.first, look.second, QLineF(s.low, s.at, s.high, s.at)});
        }
    }
    // Red last, so that no other line hides a cycle.
    std::stable_sort(strokes_.begin(), strokes_.end(), [](const Stroke& a, const Stroke& b) {
        return std::make_tuple(a.colour == kAlarm, a.colour, a.width) <
               std::make_tuple(b.colour == kAlarm, b.colour, b.width);
    });
    if (static_cast<double>(drawing.lines.size()) >= kManyLines) make_overview();
}

// So that moving over ten thousand boxes costs no more than over ten.
void MatrixInk::make_overview() {
    overview_scale_ = kOverviewPixels / std::max(drawing_->width, drawing_->height);
    overview_ = QImage(static_cast<int>(std::ceil(drawing_->width * overview_scale_)),
                       static_cast<int>(std::ceil(drawing_->height * overview_scale_)), QImage::Format_RGB32);
    QPainter painter(&overview_);
    painter.scale(overview_scale_, overview_scale_);
    paint(painter, QRectF(0.0, 0.0, drawing_->width, drawing_->height), overview_scale_);
}

void MatrixInk::paint_ground(QPainter& painter, const QRectF& seen) const {
    painter.fillRect(seen, theme().drawn(kPaper));
    for (const DrawnBand& band : drawing_->bands) {
        if (!seen.intersects(rect(band.rect))) continue;
        painter.setPen(QPen(theme().drawn(kBandEdge), 0));
        painter.setBrush(theme().drawn(band.shaded ? kBandShade : kPaper));
        painter.drawRect(rect(band.rect));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().drawn(kFrameEdge), 1.0));
    for (const DrawnFrame& frame : drawing_->frames) painter.drawRoundedRect(rect(frame.rect), 4.0, 4.0);
}

void MatrixInk::paint_line(QPainter& painter, const DrawnLine& line, const StrokeStyle& style, double scale) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen_of(style, scale, 1.0));
    painter.drawPolyline(polygon(line.points));
}

void MatrixInk::paint_lines(QPainter& painter, const QRectF& seen, double scale) const {
    const auto paint_others = [&](bool faint) {
        for (std::size_t i = 0; i < other_lines_.size(); ++i) {
            const StrokeStyle style = look(other_lines_[i]);
            if ((style.width < kFaint) != faint) continue;
            if (!meets(seen, other_bounds_[i].topLeft(), other_bounds_[i].bottomRight())) continue;
            paint_line(painter, drawing_->lines[other_lines_[i]], style, scale);
        }
    };
    if (!verdicts_.empty()) paint_others(true); // what nobody could judge lies below what somebody did
    QList<QLineF> lines;
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
        const Stroke& stroke = strokes_[i];
        if (meets(seen, stroke.line.p1(), stroke.line.p2())) lines << stroke.line;
        const bool last_of_look = i + 1 == strokes_.size() || strokes_[i + 1].colour != stroke.colour ||
                                  strokes_[i + 1].width != stroke.width;
        if (!last_of_look || lines.isEmpty()) continue;
        QPen pen = pen_of({stroke.colour, stroke.width, Dash::Solid}, scale, 1.0);
        pen.setCapStyle(Qt::SquareCap);
        painter.setPen(pen);
        painter.drawLines(lines);
        lines.clear();
    }
    if (verdicts_.empty()) paint_others(true);
    paint_others(false);
    painter.setPen(Qt::NoPen);
    for (const std::size_t i : arrows_) {
        painter.setBrush(theme().drawn(look(i).colour));
        painter.drawPolygon(polygon(arrow_head(drawing_->lines[i])));
    }
    if (scale * kJunctionRadius < 0.7) return;
    painter.setBrush(theme().drawn(kLineInk));
    for (const DrawPoint& p : drawing_->junctions) {
        if (seen.contains(point(p))) painter.drawEllipse(point(p), kJunctionRadius, kJunctionRadius);
    }
}

void MatrixInk::paint_box(QPainter& painter, const DrawnBox& box, double scale) const {
    const BoxStyle style = style_of(box);
    const double high = box.rect.height * scale;
    if (high < kShaped) {
        painter.setPen(Qt::NoPen);
        const bool marked = box.in_cycle || box.mark != Mark::None;
        painter.setBrush(theme().drawn(marked || high < 3.0 ? style.stroke.colour : style.fill));
        painter.drawRect(rect(box.rect));
        if (high >= 3.0 && !marked) {
            painter.setPen(QPen(theme().drawn(style.stroke.colour), 0));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(rect(box.rect));
        }
        return;
    }
    const BoxOutline outline = outline_of(box);
    StrokeStyle stroke = style.stroke;
    stroke.width = std::max(stroke.width, outline.stroke_width);
    painter.setPen(pen_of(stroke, scale, 1.0));
    painter.setBrush(theme().drawn(style.fill));
    painter.drawPolygon(polygon(outline.polygon));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen_of({stroke.colour, style::kLineWidth, Dash::Solid}, scale, 1.0));
    for (const std::vector<DrawPoint>& inner : outline.strokes) painter.drawPolyline(polygon(inner));
    if (box.has_finds) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().drawn(stroke.colour));
        painter.drawPolygon(polygon(finds_mark(box.rect)));
    }
    if (box.text_size * scale < kReadable) return;
    const double top = box.rect.centre().y - style::kLineHeight * static_cast<double>(box.lines.size() - 1) / 2.0;
    for (std::size_t i = 0; i < box.lines.size() && i < box.line_widths.size(); ++i) {
        paint::PaintedText text;
        text.text = box.lines[i];
        text.at = {box.rect.centre().x, top + style::kLineHeight * static_cast<double>(i) + box.text_size * 0.36};
        text.size = box.text_size;
        text.width = box.line_widths[i];
        text.anchor = TextAnchor::Middle;
        text.colour = theme().drawn(style.text).rgb() & 0xffffffU;
        paint::paint_text(painter, text);
    }
}

void MatrixInk::paint_words(QPainter& painter, const QRectF& seen, double scale) const {
    for (const DrawnText& t : drawing_->texts) {
        if (t.size * scale < kReadable || !seen.adjusted(-t.width, -t.width, t.width, t.width).contains(point(t.at))) {
            continue;
        }
        const bool strong = t.role == "title" || t.role == "legend";
        const paint::PaintedText text{
            t.text,
            t.at,
            t.size,
            t.width,
            t.anchor,
            t.bold ? FontWeight::Bold : FontWeight::Regular,
            static_cast<unsigned>(theme().drawn(strong ? kInk : kFaintInk).rgb() & 0xffffffU)};
        painter.save();
        painter.translate(t.at.x, t.at.y);
        if (t.upright) painter.rotate(-90.0);
        painter.translate(-t.at.x, -t.at.y);
        paint::paint_text(painter, text);
        painter.restore();
    }
}

void MatrixInk::paint(QPainter& painter, const QRectF& seen, double scale) const {
    painter.setRenderHint(QPainter::Antialiasing, false);
    paint_ground(painter, seen);
    painter.setRenderHint(QPainter::Antialiasing, scale > kSmooth);
    paint_lines(painter, seen, scale);
    for (const DrawnBox& box : drawing_->boxes) {
        if (seen.intersects(rect(box.rect))) paint_box(painter, box, scale);
    }
    for (const LegendSample& sample : drawing_->legend) {
        if (sample.kind == LegendSample::Kind::Box) {
            if (seen.intersects(rect(sample.box.rect))) paint_box(painter, sample.box, scale);
        } else {
            const StrokeStyle style = style_of(sample.line);
            paint_line(painter, sample.line, style, scale);
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme().drawn(style.colour));
            painter.drawPolygon(polygon(arrow_head(sample.line)));
        }
    }
    paint_words(painter, seen, scale);
}

void MatrixInk::paint_pointed(QPainter& painter, const QRectF& seen, double scale, const Pointed& pointed) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const bool proof = pointed.proof_boxes != nullptr && !pointed.proof_boxes->empty();
    if (proof) {
        QColor veil = theme().drawn(kPaper);
        veil.setAlphaF(theme().kind == ThemeKind::Dark ? 0.66F : 0.74F);
        painter.fillRect(seen, veil);
        for (const std::size_t i : *pointed.proof_lines) {
            const DrawnLine& line = drawing_->lines[i];
            painter.setBrush(Qt::NoBrush);
            QPen pen(theme().error, std::max(1.8, 2.0 / scale), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
            if (line.uncertain) pen.setStyle(Qt::DashLine);
            painter.setPen(pen);
            painter.drawPolyline(polygon(line.points));
        }
        for (const std::size_t i : *pointed.proof_boxes) paint_box(painter, drawing_->boxes[i], scale);
    }
    const auto ring = [&](std::size_t at, double width, const QColor& colour) {
        if (at >= drawing_->boxes.size()) return;
        const double grow = std::max(2.0, 2.5 / scale);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, std::max(width, width / scale)));
        painter.drawRoundedRect(rect(drawing_->boxes[at].rect).adjusted(-grow, -grow, grow, grow), 3.0, 3.0);
    };
    if (pointed.hovered != pointed.selected) ring(pointed.hovered, 1.0, theme().faint);
    ring(pointed.selected, 2.2, theme().accent);
}

} // namespace planum::gui
