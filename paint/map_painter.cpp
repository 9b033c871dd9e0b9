// SPDX-License-Identifier: MIT
#include "paint/map_painter.hpp"

#include <QFontMetricsF>
#include <QImage>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "paint/drawing_painter.hpp"
#include "paint/font_measure.hpp"
#include "strat/layout/drawing_colours.hpp"

namespace planum::paint {

using namespace strat;
using geometry::MapSheet;
using geometry::SheetLook;
using geometry::SheetSign;

namespace {

constexpr double kLabelSize = 9.0; // [pt]
constexpr double kSmallSize = 6.5;
constexpr double kHalo = 2.2;
constexpr double kBelow = 7.5; // from line to line of a label

class MapPainter {
  public:
    MapPainter(QPainter& painter, const MapSheet& sheet, const MapPage& page, double scale)
        : painter_(painter), sheet_(sheet), page_(page), scale_(scale) {}

    void paint() {
        painter_.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
        painter_.save();
        painter_.setClipRect(page_.frame);
        for (const geometry::SheetPicture& picture : sheet_.pictures) paint_picture(picture);
        paint_grid();
        for (const geometry::SheetShape& shape : sheet_.shapes) paint_shape(shape);
        for (const geometry::SheetLine& line : sheet_.lines) paint_line(line);
        paint_signs();
        for (const geometry::SheetLabel& label : sheet_.labels) paint_label(label);
        for (const geometry::SheetMark& mark : sheet_.marks) {
            const QPointF p = at(mark.x, mark.y);
            if (!mark.text.empty() && page_.frame.contains(p)) paint_mark_words(mark, p);
        }
        painter_.restore();
        paint_frame();
        paint_words();
        paint_scale_bar();
        if (!sheet_.is_section) paint_north();
        for (const PlacedKey& key : page_.keys) paint_key(key);
    }

  private:
    [[nodiscard]] QPointF at(double x, double y) const { return page_.on_paper(sheet_, x, y); }

    void set_look(const SheetLook& look) {
        QPen pen(QColor::fromRgb(look.line));
        pen.setWidthF(look.width * kPointsPerMillimetre);
        pen.setJoinStyle(Qt::RoundJoin);
        if (look.dash == geometry::SheetDash::Dashed) pen.setDashPattern({5.0, 3.0});
        if (look.dash == geometry::SheetDash::Dotted) pen.setDashPattern({1.2, 2.2});
        // Square ends would eat half of a gap.
        if (look.dash == geometry::SheetDash::Dashed) pen.setCapStyle(Qt::FlatCap);
        painter_.setPen(look.width > 0.0 ? pen : QPen(Qt::NoPen));
        QColor fill = QColor::fromRgb(look.fill);
        fill.setAlphaF(static_cast<float>(look.opacity));
        painter_.setBrush(look.opacity > 0.0 ? QBrush(fill) : QBrush(Qt::NoBrush));
    }

    void paint_picture(const geometry::SheetPicture& picture) {
        const QImage image(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                           QImage::Format_RGBA8888);
        const QPointF corner = at(picture.left, picture.top);
        const double side = picture.pixel * page_.points_per_metre;
        painter_.drawImage(QRectF(corner.x(), corner.y(), side * picture.width, side * picture.height), image);
    }

    void paint_shape(const geometry::SheetShape& shape) {
        QPainterPath path;
        path.setFillRule(Qt::OddEvenFill);
        for (const geometry::Rings& rings : shape.shape) {
            for (const geometry::Line3& ring : rings) {
                QPolygonF polygon;
                for (const geometry::Point3& p : ring) polygon << at(p[0], p[1]);
                path.addPolygon(polygon);
                path.closeSubpath();
            }
        }
        set_look(shape.look);
        painter_.drawPath(path);
    }

    void paint_line(const geometry::SheetLine& line) {
        QPolygonF polygon;
        for (const geometry::Point3& p : line.points) polygon << at(p[0], p[1]);
        set_look(line.look);
        painter_.setBrush(Qt::NoBrush);
        painter_.drawPolyline(polygon);
    }

    template<class Visit>
    void for_steps(std::size_t axis, const Visit& visit) const {
        const double step = tick_step(sheet_, page_, axis);
        const auto first = static_cast<std::int64_t>(std::ceil(sheet_.extent.low[axis] / step - 1e-9));
        for (std::int64_t i = first; static_cast<double>(i) * step <= sheet_.extent.high[axis] + 1e-9; ++i)
            visit(static_cast<double>(i) * step);
    }

    // Crosses on a plan, level lines on a section.
    void paint_grid() {
        painter_.setPen(QPen(QColor::fromRgb(kFaintInk), 0.4));
        for_steps(1, [&](double y) {
            if (sheet_.is_section) {
                painter_.drawLine(at(sheet_.extent.low[0], y), at(sheet_.extent.high[0], y));
                return;
            }
            for_steps(0, [&](double x) {
                const QPointF p = at(x, y);
                painter_.drawLine(p - QPointF(4.0, 0.0), p + QPointF(4.0, 0.0));
                painter_.drawLine(p - QPointF(0.0, 4.0), p + QPointF(0.0, 4.0));
            });
        });
    }

    void paint_frame() {
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(QPen(QColor::fromRgb(kLineInk), 0.8));
        painter_.drawRect(page_.frame);
        const auto number = [this](std::size_t axis, double value) {
            const double step = tick_step(sheet_, page_, axis);
            const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
            return fmt::format("{:.{}f}", value + 0.0, digits);
        };
        for_steps(0, [&](double x) {
            const double px = at(x, 0.0).x();
            painter_.setPen(QPen(QColor::fromRgb(kLineInk), 0.6));
            painter_.drawLine(QPointF(px, page_.frame.bottom()), QPointF(px, page_.frame.bottom() + 3.0));
            words(number(0, x), {px, page_.frame.bottom() + 10.5}, 7.0, TextAnchor::Middle);
        });
        for_steps(1, [&](double y) {
            const double py = at(0.0, y).y();
            painter_.setPen(QPen(QColor::fromRgb(kLineInk), 0.6));
            painter_.drawLine(QPointF(page_.frame.left() - 3.0, py), QPointF(page_.frame.left(), py));
            if (sheet_.is_section) { // upright, so that heights of a low section have room
                words(number(1, y), {page_.frame.left() - 5.0, py + 2.5}, 7.0, TextAnchor::End);
                return;
            }
            painter_.save();
            painter_.translate(page_.frame.left() - 5.0, py);
            painter_.rotate(-90.0);
            words(number(1, y), {0.0, 0.0}, 7.0, TextAnchor::Middle);
            painter_.restore();
        });
    }

    void words(std::string_view text, DrawPoint where, double size, TextAnchor anchor,
               FontWeight weight = FontWeight::Regular, Colour colour = kInk) {
        paint_text(painter_, {text, where, size, 0.0, anchor, weight, colour});
    }

    // White around the letters, so that they are read on any ground.
    void halo(std::string_view text, DrawPoint where, double size, TextAnchor anchor, FontWeight weight) {
        const QString letters = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
        const QFont font = drawing_font(weight);
        const double shrink = size / kFontPixels;
        const double width = QFontMetricsF(font).horizontalAdvance(letters) * shrink;
        QPainterPath path;
        path.addText(QPointF(0.0, 0.0), font, letters);
        painter_.save();
        painter_.translate(where.x - (anchor == TextAnchor::Middle ? width / 2.0
                                      : anchor == TextAnchor::End  ? width
                                                                   : 0.0),
                           where.y);
        painter_.scale(shrink, shrink);
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(QPen(Qt::white, kHalo / shrink, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter_.drawPath(path);
        painter_.restore();
        words(text, where, size, anchor, weight);
    }

    [[nodiscard]] QRectF box_of(std::string_view text, QPointF base, double size, TextAnchor anchor,
                                FontWeight weight) const {
        const double width = measure_.width(text, size, weight);
        const double left = anchor == TextAnchor::Middle ? base.x() - width / 2.0
                            : anchor == TextAnchor::End  ? base.x() - width
                                                         : base.x();
        return {left - 1.0, base.y() - 0.8 * size, width + 2.0, size};
    }

    // Moved a little where a sign or another label is in the way.
    void paint_label(const geometry::SheetLabel& label) {
        const double up = label.below.empty() ? 3.2 : -0.3;
        const QPointF middle = at(label.x, label.y) + QPointF(0.0, up);
        QPointF base = middle;
        for (const QPointF& step : {QPointF(0, 0), QPointF(0, -9), QPointF(0, 9), QPointF(-15, 0), QPointF(15, 0)}) {
            const auto boxes = label_boxes(label, middle + step);
            const bool free = std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) {
                return other.intersects(boxes[0]) || (!label.below.empty() && other.intersects(boxes[1]));
            });
            if (!free) continue;
            base = middle + step;
            break;
        }
        const auto boxes = label_boxes(label, base);
        halo(label.text, {base.x(), base.y()}, kLabelSize, TextAnchor::Middle, FontWeight::Bold);
        taken_.push_back(boxes[0]);
        if (label.below.empty()) return;
        halo(label.below, {base.x(), base.y() + kBelow}, kSmallSize, TextAnchor::Middle, FontWeight::Regular);
        taken_.push_back(boxes[1]);
    }

    [[nodiscard]] std::array<QRectF, 2> label_boxes(const geometry::SheetLabel& label, QPointF base) const {
        return {box_of(label.text, base, kLabelSize, TextAnchor::Middle, FontWeight::Bold),
                box_of(label.below, base + QPointF(0.0, kBelow), kSmallSize, TextAnchor::Middle, FontWeight::Regular)};
    }

    void paint_sign(SheetSign sign, QPointF p) {
        painter_.setPen(QPen(QColor::fromRgb(kInk), 0.8));
        painter_.setBrush(Qt::white);
        switch (sign) {
        case SheetSign::None: return;
        case SheetSign::Level:
            painter_.drawPolygon(QPolygonF({p, p + QPointF(-2.6, -4.6), p + QPointF(2.6, -4.6)}));
            return;
        case SheetSign::Find:
            painter_.drawPolygon(
                QPolygonF({p + QPointF(0, -3), p + QPointF(3, 0), p + QPointF(0, 3), p + QPointF(-3, 0)}));
            return;
        case SheetSign::Station:
            painter_.drawEllipse(p, 3.5, 3.5);
            painter_.drawLine(p - QPointF(3.5, 0), p + QPointF(3.5, 0));
            painter_.drawLine(p - QPointF(0, 3.5), p + QPointF(0, 3.5));
            return;
        }
    }

    void paint_signs() {
        for (const geometry::SheetMark& mark : sheet_.marks) {
            const QPointF p = at(mark.x, mark.y);
            if (!page_.frame.contains(p)) continue;
            paint_sign(mark.sign, p);
            taken_.emplace_back(p.x() - 3.0, p.y() - 5.0, 6.0, 6.5);
        }
    }

    // Right of the sign, left, below or above, wherever there is room.
    void paint_mark_words(const geometry::SheetMark& mark, QPointF p) {
        struct Place {
            QPointF base;
            TextAnchor anchor;
        };

        const std::array<Place, 4> places = {
            Place{p + QPointF(4.5, 0.6), TextAnchor::Start}, Place{p + QPointF(-4.5, 0.6), TextAnchor::End},
            Place{p + QPointF(0.0, 7.5), TextAnchor::Middle}, Place{p + QPointF(0.0, -6.5), TextAnchor::Middle}};
        for (const Place& place : places) {
            const QRectF box = box_of(mark.text, place.base, kSmallSize, place.anchor, FontWeight::Regular);
            if (!page_.frame.contains(box)) continue;
            if (std::any_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return other.intersects(box); }))
                continue;
            halo(mark.text, {place.base.x(), place.base.y()}, kSmallSize, place.anchor, FontWeight::Regular);
            taken_.push_back(box);
            return;
        }
    }

    void paint_words() {
        const double left = kMapMargin + 14.0;
        words(sheet_.title, {left, kMapMargin + 12.0}, page_.title_size, TextAnchor::Start, FontWeight::Bold);
        words(sheet_.subtitle, {left, kMapMargin + 26.0}, 8.5, TextAnchor::Start, FontWeight::Regular, kFaintInk);
        words(sheet_.site, {page_.width - kMapMargin - 14.0, kMapMargin + 12.0}, 8.5, TextAnchor::End,
              FontWeight::Regular, kFaintInk);
    }

    void paint_scale_bar() {
        const double length = round_length(150.0 / page_.points_per_metre);
        const double part = length * page_.points_per_metre / 4.0;
        const double x = kMapMargin + 14.0;
        const double y = page_.foot + 6.0;
        painter_.setPen(QPen(QColor::fromRgb(kInk), 0.6));
        for (int i = 0; i < 4; ++i) {
            painter_.setBrush(QColor::fromRgb(i % 2 == 0 ? kInk : kPaper));
            painter_.drawRect(QRectF(x + i * part, y, part, 4.0));
        }
        words("0", {x, y + 12.5}, 7.0, TextAnchor::Middle);
        words(fmt::format("{:g}", length / 2.0), {x + 2.0 * part, y + 12.5}, 7.0, TextAnchor::Middle);
        words(fmt::format("{:g} m", length), {x + 4.0 * part, y + 12.5}, 7.0, TextAnchor::Middle);
        words(fmt::format("1 : {:g}", scale_), {x + 4.0 * part + 22.0, y + 5.5}, 9.0, TextAnchor::Start,
              FontWeight::Bold);
    }

    void paint_north() {
        const QPointF n(page_.width - kMapMargin - 22.0, page_.foot + 8.0);
        painter_.setPen(QPen(QColor::fromRgb(kInk), 0.6));
        painter_.setBrush(QColor::fromRgb(kInk));
        painter_.drawPolygon(QPolygonF({n + QPointF(0, -11), n + QPointF(5, 8), n + QPointF(0, 4)}));
        painter_.setBrush(Qt::white);
        painter_.drawPolygon(QPolygonF({n + QPointF(0, -11), n + QPointF(-5, 8), n + QPointF(0, 4)}));
        words("N", {n.x(), n.y() + 17.0}, 8.0, TextAnchor::Middle, FontWeight::Bold);
    }

    void paint_key(const PlacedKey& placed) {
        if (placed.key->sign != SheetSign::None) {
            paint_sign(placed.key->sign,
                       placed.swatch.center() + QPointF(0.0, placed.key->sign == SheetSign::Level ? 2.3 : 0.0));
        } else {
            set_look(placed.key->look);
            if (placed.key->look.opacity > 0.0) {
                painter_.drawRect(placed.swatch);
            } else {
                const double y = placed.swatch.center().y();
                painter_.drawLine(QPointF(placed.swatch.left(), y), QPointF(placed.swatch.right(), y));
            }
        }
        words(placed.key->text, {placed.text_x, placed.base_line}, 8.0, TextAnchor::Start);
    }

    QPainter& painter_;
    const MapSheet& sheet_;
    const MapPage& page_;
    double scale_;
    FontTextMeasure measure_;
    std::vector<QRectF> taken_;
};

} // namespace

void paint_map(QPainter& painter, const MapSheet& sheet, const MapPage& page, double scale) {
    MapPainter(painter, sheet, page, scale).paint();
}

} // namespace planum::paint
