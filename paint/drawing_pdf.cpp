// SPDX-License-Identifier: MIT
#include "paint/drawing_pdf.hpp"

#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "paint/drawing_painter.hpp"
#include "paint/font_measure.hpp"
#include "paint/legend_strip.hpp"
#include "paint/pdf_bytes.hpp"
#include "paint/qt_runtime.hpp"
#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/wrapped_text.hpp"

namespace planum::paint {

using namespace strat;

namespace {

constexpr int kDotsPerInch = 1200; // QPdfWriter rounds coordinates to this
constexpr double kPointsPerInch = 72.0;

class PdfMaker {
  public:
    PdfMaker(const MatrixDrawing& drawing, const PdfOptions& options, Progress& progress)
        : drawing_(drawing), options_(options), progress_(progress), plan_(plan_poster(drawing, options.poster)) {
        poster_ = options.poster.paging == Paging::Poster && options.poster.paper != Paper::Fitted &&
                  plan_.sheets.size() > 1; // what fits on one needs no map of its sheets
        index_ = poster_ ? sheet_index(drawing, plan_) : std::vector<SheetEntry>{};
        plan_index();
        if (poster_) legend_ = lay_legend(drawing, plan_.page_width - 2.0 * options.poster.margin);
    }

    std::string make() {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setResolution(kDotsPerInch);
        writer.setTitle(QString::fromStdString(drawing_.title));
        writer.setCreator(QStringLiteral("planum"));
        writer.setPageSize(
            QPageSize(QSizeF(plan_.page_width, plan_.page_height), QPageSize::Point, QString(), QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF(0, 0, 0, 0));
        QPainter painter(&writer);
        if (!painter.isActive()) throw Error(ErrorCode::Internal, "the PDF could not be begun");
        painter.scale(kDotsPerInch / kPointsPerInch, kDotsPerInch / kPointsPerInch);
        pages_ = plan_.sheets.size() + (poster_ ? 1 + index_pages() : 0);
        for (const Sheet& sheet : plan_.sheets) {
            progress_.check();
            progress_.fraction(static_cast<double>(page_) / static_cast<double>(pages_));
            next_page(writer);
            paint_sheet(painter, sheet);
        }
        if (poster_) {
            next_page(writer);
            paint_map(painter);
            paint_index(painter, writer);
        }
        painter.end();
        std::string pdf = bytes.toStdString();
        set_creation_date(pdf, options_.created_at);
        return pdf;
    }

  private:
    static constexpr double kIndexText = 8.0;
    static constexpr double kIndexLine = 11.0;
    static constexpr double kHeading = 24.0;
    static constexpr double kIndexGutter = 20.0; // between columns
    static constexpr double kLeader = 14.0;      // from the longest name to the sheet
    static constexpr double kIndexGap = 18.0;    // between map and index on one page
    static constexpr Colour kSheetInk = 0x1f5fa8;

    // Columns as wide as their entries need, but a few long names must not make all the others' columns wide: those
    // are shortened.
    void plan_index() {
        if (index_.empty()) return;
        std::vector<double> widths;
        for (const SheetEntry& e : index_) {
            sheet_width_ = std::max(sheet_width_, measure_.width(e.sheet, kIndexText, FontWeight::Bold));
            widths.push_back(measure_.width(e.unit, kIndexText, FontWeight::Regular));
        }
        std::sort(widths.begin(), widths.end());
        const double most_fit = widths[(widths.size() - 1) * 9 / 10];
        const double widest = plan_.content.width - kIndexGutter - kLeader - sheet_width_;
        constexpr double kSaysEnough = 90.0;
        const bool few_long = widths.back() > std::max(2.0 * most_fit, kSaysEnough);
        name_width_ = std::min(std::max(30.0, few_long ? std::max(most_fit, kSaysEnough) : widths.back()), widest);
        column_width_ = name_width_ + kLeader + sheet_width_ + kIndexGutter;
    }

    void next_page(QPdfWriter& writer) {
        if (page_ > 0) writer.newPage();
        ++page_;
    }

    void paint_sheet(QPainter& painter, const Sheet& sheet) {
        const DrawRect& content = plan_.content;
        painter.save();
        painter.setClipRect(QRectF(content.x, content.y, content.width, content.height));
        painter.translate(content.x, content.y);
        painter.scale(plan_.scale, plan_.scale);
        painter.translate(-sheet.part.x, -sheet.part.y);
        paint_drawing(painter, poster_ ? part_of(sheet.part) : drawing_);
        painter.restore();
        if (poster_) paint_edges(painter, sheet);
        paint_title_block(painter, poster_ ? with_word(options_.words.sheet, sheet.name) : std::string{});
    }

    // Only what the sheet shows, or a poster of a hundred sheets would hold the drawing a hundred times.
    [[nodiscard]] MatrixDrawing part_of(const DrawRect& part) const {
        const auto hidden = [&](const DrawRect& r) {
            constexpr double kSlack = 4.0; // strokes and marks stand out a little
            return r.right() + kSlack < part.x || r.x - kSlack > part.right() || r.bottom() + kSlack < part.y ||
                   r.y - kSlack > part.bottom();
        };
        MatrixDrawing d = drawing_;
        std::erase_if(d.boxes, [&](const DrawnBox& b) { return hidden(b.rect); });
        std::erase_if(d.lines, [&](const DrawnLine& l) {
            for (std::size_t i = 1; i < l.points.size(); ++i) {
                const auto [x0, x1] = std::minmax(l.points[i - 1].x, l.points[i].x);
                const auto [y0, y1] = std::minmax(l.points[i - 1].y, l.points[i].y);
                if (!hidden({x0, y0, x1 - x0, y1 - y0})) return false;
            }
            return true;
        });
        std::erase_if(d.junctions, [&](const DrawPoint& p) { return hidden({p.x, p.y, 0.0, 0.0}); });
        std::erase_if(d.texts, [&](const DrawnText& t) {
            return hidden({t.at.x - t.width, t.at.y - t.size, 2.0 * t.width, 2.0 * t.size});
        });
        return d;
    }

    // Crop marks where the neighbour's half of the overlap begins, and the neighbour's name.
    void paint_edges(QPainter& painter, const Sheet& sheet) {
        const DrawRect& c = plan_.content;
        const double half = options_.poster.overlap / 2.0;
        const double left = sheet.column > 0 ? c.x + half : c.x;
        const double right = sheet.column + 1 < plan_.columns ? c.right() - half : c.right();
        const double top = sheet.row > 0 ? c.y + half : c.y;
        const double bottom = sheet.row + 1 < plan_.rows ? c.bottom() - half : c.bottom();
        painter.setPen(QPen(QColor::fromRgb(kInk), 0.4));
        constexpr double kGap = 3.0;
        constexpr double kLength = 12.0;
        for (const double x : {left, right}) {
            painter.drawLine(QPointF(x, c.y - kGap - kLength), QPointF(x, c.y - kGap));
            painter.drawLine(QPointF(x, c.bottom() + kGap), QPointF(x, c.bottom() + kGap + kLength));
        }
        for (const double y : {top, bottom}) {
            painter.drawLine(QPointF(c.x - kGap - kLength, y), QPointF(c.x - kGap, y));
            painter.drawLine(QPointF(c.right() + kGap, y), QPointF(c.right() + kGap + kLength, y));
        }
        const auto say = [&](const std::string& words, DrawPoint at, TextAnchor anchor) {
            paint_text(painter, {words, at, 7.0, 0.0, anchor, FontWeight::Regular, kFaintInk});
        };
        const auto name = [](std::size_t row, std::size_t column) {
            return row_letters(row) + fmt::format("{}", column + 1);
        };
        const DrawPoint middle = c.centre();
        if (sheet.column > 0) say("◂ " + name(sheet.row, sheet.column - 1), {c.x - 24.0, middle.y}, TextAnchor::Start);
        if (sheet.column + 1 < plan_.columns) {
            say(name(sheet.row, sheet.column + 1) + " ▸", {c.right() + 24.0, middle.y}, TextAnchor::End);
        }
        if (sheet.row > 0) say("▴ " + name(sheet.row - 1, sheet.column), {middle.x, c.y - 8.0}, TextAnchor::Middle);
        if (sheet.row + 1 < plan_.rows) {
            say("▾ " + name(sheet.row + 1, sheet.column), {middle.x, c.bottom() + 9.0}, TextAnchor::Middle);
        }
    }

    void paint_title_block(QPainter& painter, const std::string& right) {
        const double x0 = options_.poster.margin;
        const double x1 = plan_.page_width - options_.poster.margin;
        const double y = plan_.page_height - options_.poster.margin;
        painter.setPen(QPen(QColor::fromRgb(kBandEdge), 0.6));
        const double top = y - plan_.title_block + 14.0;
        painter.drawLine(QPointF(x0, top), QPointF(x1, top));
        paint_legend(painter, drawing_, legend_, {x0, top + 4.0});
        std::string left = options_.site;
        if (!drawing_.title.empty() && drawing_.title != options_.site)
            left += (left.empty() ? "" : " · ") + drawing_.title;
        std::string facts = options_.date;
        if (!facts.empty()) facts += " · ";
        facts += with_word(options_.words.scale, fmt::format("{:.0f}", plan_.scale * 100.0));
        if (!right.empty()) facts += " · " + right;
        facts += " · " + with_number(with_number(options_.words.page, page_), pages_);
        paint_text(painter, {facts, {x1, y - 6.0}, 8.0, 0.0, TextAnchor::End, FontWeight::Regular, kFaintInk});
        const double room = x1 - x0 - measure_.width(facts, 8.0, FontWeight::Regular) - 14.0;
        left = shortened(text::on_one_line(left).text, room, {9.0, FontWeight::Bold}, measure_);
        paint_text(painter, {left, {x0, y - 6.0}, 9.0, 0.0, TextAnchor::Start, FontWeight::Bold, kInk});
    }

    // The whole drawing small and pale, with the sheets' cutting lines and names; below it the index where it is short.
    void paint_map(QPainter& painter) {
        const DrawRect& c = plan_.content;
        paint_heading(painter, options_.words.sheets, c.y);
        const double room = c.height - kHeading - (index_is_beside_map() ? index_height() : 0.0);
        const double scale = std::min({c.width / drawing_.width, room / drawing_.height, 1.0});
        painter.save();
        painter.translate(c.x, c.y + kHeading);
        painter.scale(scale, scale);
        painter.setClipRect(QRectF(0.0, 0.0, drawing_.width, drawing_.height));
        paint_drawing(painter, drawing_);
        painter.restore();
        painter.fillRect(QRectF(c.x, c.y + kHeading, drawing_.width * scale, drawing_.height * scale),
                         QColor(255, 255, 255, 120));
        const double overlap = options_.poster.overlap / plan_.scale;
        for (const Sheet& sheet : plan_.sheets) {
            const double left = sheet.column > 0 ? sheet.part.x + overlap / 2.0 : 0.0;
            const double top = sheet.row > 0 ? sheet.part.y + overlap / 2.0 : 0.0;
            const double right = sheet.column + 1 < plan_.columns ? sheet.part.right() - overlap / 2.0 : drawing_.width;
            const double bottom = sheet.row + 1 < plan_.rows ? sheet.part.bottom() - overlap / 2.0 : drawing_.height;
            const QRectF tile(c.x + left * scale, c.y + kHeading + top * scale, (right - left) * scale,
                              (bottom - top) * scale);
            paint_tile(painter, tile, sheet.name);
        }
        if (index_is_beside_map()) paint_entries(painter, 0, index_.size(), c.bottom() - index_height() + kIndexGap);
        paint_title_block(painter, options_.words.map + (index_is_beside_map() ? ", " + options_.words.index : ""));
    }

    // The name on a plate of its own, or what stands below it would run into it.
    void paint_tile(QPainter& painter, const QRectF& tile, const std::string& name) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor::fromRgb(kSheetInk), 0.7));
        painter.drawRect(tile);
        const double size = std::clamp(std::min(tile.width() / 3.5, tile.height() / 2.0), 4.0, 14.0);
        const double width = measure_.width(name, size, FontWeight::Bold) + size * 0.8;
        const QRectF plate(tile.center().x() - width / 2.0, tile.center().y() - size * 0.75, width, size * 1.5);
        painter.setBrush(QColor::fromRgb(kPaper));
        painter.setPen(QPen(QColor::fromRgb(kSheetInk), 0.5));
        painter.drawRoundedRect(plate, size * 0.3, size * 0.3);
        paint_text(painter, {name,
                             {tile.center().x(), tile.center().y() + size * 0.36},
                             size,
                             0.0,
                             TextAnchor::Middle,
                             FontWeight::Bold,
                             kSheetInk});
    }

    void paint_heading(QPainter& painter, const std::string& words, double top) {
        paint_text(painter,
                   {words, {plan_.content.x, top + 12.0}, 13.0, 0.0, TextAnchor::Start, FontWeight::Bold, kInk});
    }

    [[nodiscard]] std::size_t index_columns() const {
        return std::max<std::size_t>(1, static_cast<std::size_t>((plan_.content.width + kIndexGutter) / column_width_));
    }

    [[nodiscard]] std::size_t index_rows() const {
        return std::max<std::size_t>(1, static_cast<std::size_t>((plan_.content.height - kHeading - 6.0) / kIndexLine));
    }

    // Height of the whole index with its heading and the gap above it.
    [[nodiscard]] double index_height() const {
        const std::size_t rows = (index_.size() + index_columns() - 1) / index_columns();
        return kIndexGap + kHeading + 6.0 + static_cast<double>(rows) * kIndexLine;
    }

    // As long as half of the sheet is left for the map: a page with three rows of names on it is a waste of paper.
    [[nodiscard]] bool index_is_beside_map() const { return index_height() <= plan_.content.height / 2.0; }

    [[nodiscard]] std::size_t index_pages() const {
        if (index_is_beside_map()) return 0;
        const std::size_t per_page = index_columns() * index_rows();
        return (index_.size() + per_page - 1) / per_page;
    }

    // Pages as full as one another, or the last would be nearly empty.
    void paint_index(QPainter& painter, QPdfWriter& writer) {
        const std::size_t pages = index_pages();
        for (std::size_t page = 0; page < pages; ++page) {
            next_page(writer);
            paint_entries(painter, index_.size() * page / pages, index_.size() * (page + 1) / pages, plan_.content.y);
            paint_title_block(painter, options_.words.index);
        }
    }

    // In columns of one height, downwards.
    void paint_entries(QPainter& painter, std::size_t first, std::size_t end, double top) {
        paint_heading(painter, options_.words.unit_and_sheet, top);
        const std::size_t rows = (end - first + index_columns() - 1) / index_columns();
        for (std::size_t i = first; i < end; ++i) {
            const double x = plan_.content.x + static_cast<double>((i - first) / rows) * column_width_;
            const double y = top + kHeading + 6.0 + static_cast<double>((i - first) % rows) * kIndexLine;
            paint_entry(painter, index_[i], {x, y});
        }
    }

    // Name, dots that lead the eye, sheet.
    void paint_entry(QPainter& painter, const SheetEntry& entry, DrawPoint at) {
        constexpr TextLook kLook{kIndexText, FontWeight::Regular};
        const std::string name = shortened_inside(entry.unit, name_width_, kLook, measure_);
        const double right = at.x + name_width_ + kLeader + sheet_width_;
        const double from = at.x + measure_.width(name, kLook.size, kLook.weight) + 3.0;
        const double to = right - measure_.width(entry.sheet, kIndexText, FontWeight::Bold) - 3.0;
        QPen dots(QColor::fromRgb(kFaintInk), 0.5);
        dots.setDashPattern({1.0, 4.0});
        painter.setPen(dots);
        if (to > from) painter.drawLine(QPointF(to, at.y - 0.4), QPointF(from, at.y - 0.4));
        paint_text(painter, {name, at, kIndexText, 0.0, TextAnchor::Start, FontWeight::Regular, kInk});
        paint_text(painter, {entry.sheet, {right, at.y}, kIndexText, 0.0, TextAnchor::End, FontWeight::Bold, kInk});
    }

    const MatrixDrawing& drawing_;
    const PdfOptions& options_;
    Progress& progress_;
    PosterPlan plan_;
    FontTextMeasure measure_;
    std::vector<SheetEntry> index_;
    double name_width_ = 0.0; // in a column of the index [pt]
    double sheet_width_ = 0.0;
    double column_width_ = 60.0; // gutter included
    LegendStrip legend_;
    bool poster_ = false;
    std::size_t page_ = 0;
    std::size_t pages_ = 0;
};

} // namespace

std::string render_pdf(const MatrixDrawing& drawing, const PdfOptions& options, Progress& progress) {
    ensure_qt_runtime();
    progress.step("writing the PDF");
    return PdfMaker(drawing, options, progress).make();
}

} // namespace planum::paint
