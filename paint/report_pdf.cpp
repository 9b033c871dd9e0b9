// SPDX-License-Identifier: MIT
#include "paint/report_pdf.hpp"

#include <algorithm>
#include <array>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "paint/drawing_painter.hpp"
#include "paint/pdf_bytes.hpp"
#include "paint/qt_runtime.hpp"
#include "strat/layout/drawing_colours.hpp"

namespace planum::paint {

using namespace strat;

namespace {

constexpr int kDotsPerInch = 1200;
constexpr double kPointsPerInch = 72.0;
constexpr double kMargin = 50.0; // [pt]
constexpr double kFoot = 26.0;   // [pt] for the line at the bottom
constexpr double kLeastScale = 0.6;

class ReportMaker {
  public:
    ReportMaker(const ReportPdf& report, Progress& progress) : report_(report), progress_(progress) {}

    std::string make() {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter writer(&buffer);
        writer.setResolution(kDotsPerInch);
        writer.setTitle(QString::fromStdString(report_.site));
        writer.setCreator(QStringLiteral("planum"));
        set_page(writer, QPageSize(QPageSize::A4), QPageLayout::Portrait);
        QPainter painter(&writer);
        if (!painter.isActive()) throw Error(ErrorCode::Internal, "the PDF could not be begun");
        painter.scale(kDotsPerInch / kPointsPerInch, kDotsPerInch / kPointsPerInch);
        paint_words(painter, writer);
        if (report_.drawing != nullptr && !report_.drawing->boxes.empty()) paint_matrix(painter, writer);
        painter.end();
        std::string pdf = bytes.toStdString();
        set_creation_date(pdf, {});
        return pdf;
    }

  private:
    void set_page(QPdfWriter& writer, const QPageSize& size, QPageLayout::Orientation orientation) {
        writer.setPageLayout(QPageLayout(size, orientation, QMarginsF(0, 0, 0, 0)));
        page_size_ = writer.pageLayout().fullRect(QPageLayout::Point).size();
    }

    void paint_words(QPainter& painter, QPdfWriter& writer) {
        QTextDocument document;
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setPixelSize(9); // a pixel of the document is a point of the page
        font.setHintingPreference(QFont::PreferNoHinting);
        document.setDefaultFont(font);
        document.setDocumentMargin(0.0);
        document.setHtml(QString::fromStdString(report_.html));
        const QSizeF room(page_size_.width() - 2.0 * kMargin, page_size_.height() - 2.0 * kMargin - kFoot);
        document.setPageSize(room);
        const int word_pages = document.pageCount();
        pages_ = word_pages + (report_.drawing != nullptr && !report_.drawing->boxes.empty() ? 1 : 0);
        for (int page = 0; page < word_pages; ++page) {
            progress_.check();
            progress_.fraction(static_cast<double>(page) / static_cast<double>(pages_));
            if (page > 0) writer.newPage();
            const QRectF part(0.0, page * room.height(), room.width(), room.height());
            painter.save();
            painter.translate(kMargin, kMargin - part.top());
            painter.setClipRect(part);
            QAbstractTextDocumentLayout::PaintContext context;
            context.clip = part;
            context.palette.setColor(QPalette::Text, QColor::fromRgb(kInk));
            document.documentLayout()->draw(&painter, context);
            painter.restore();
            paint_foot(painter, page + 1, {});
        }
    }

    void paint_matrix(QPainter& painter, QPdfWriter& writer) {
        const MatrixDrawing& drawing = *report_.drawing;
        const auto orientation = drawing.width > drawing.height ? QPageLayout::Landscape : QPageLayout::Portrait;
        double scale = 0.0;
        for (const auto paper : {QPageSize::A4, QPageSize::A3, QPageSize::A2, QPageSize::A1, QPageSize::A0}) {
            set_page(writer, QPageSize(paper), orientation);
            scale = std::min({(page_size_.width() - 2.0 * kMargin) / drawing.width,
                              (page_size_.height() - 2.0 * kMargin - kFoot) / drawing.height, 1.0});
            if (scale >= kLeastScale) break;
        }
        writer.newPage();
        painter.save();
        painter.translate(std::max(kMargin, (page_size_.width() - scale * drawing.width) / 2.0), kMargin);
        painter.scale(scale, scale);
        paint_drawing(painter, drawing);
        painter.restore();
        paint_foot(painter, pages_, fmt::format("Harris matrix, scale {:.0f} %", scale * 100.0));
    }

    void paint_foot(QPainter& painter, int page, const std::string& words) {
        const double y = page_size_.height() - kMargin;
        painter.setPen(QPen(QColor::fromRgb(kBandEdge), 0.6));
        painter.drawLine(QPointF(kMargin, y - 12.0), QPointF(page_size_.width() - kMargin, y - 12.0));
        paint_text(painter, {report_.site, {kMargin, y}, 8.0, 0.0, TextAnchor::Start, FontWeight::Bold, kInk});
        const std::string facts =
            fmt::format("{}{}{} · page {} of {}", words, words.empty() ? "" : " · ", report_.date, page, pages_);
        paint_text(
            painter,
            {facts, {page_size_.width() - kMargin, y}, 8.0, 0.0, TextAnchor::End, FontWeight::Regular, kFaintInk});
    }

    const ReportPdf& report_;
    Progress& progress_;
    QSizeF page_size_; // [pt]
    int pages_ = 0;
};

} // namespace

std::string render_report_pdf(const ReportPdf& report, Progress& progress) {
    ensure_qt_runtime();
    progress.step("writing the PDF");
    return ReportMaker(report, progress).make();
}

} // namespace planum::paint
