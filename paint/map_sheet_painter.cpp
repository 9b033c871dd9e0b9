// SPDX-License-Identifier: MIT
#include "paint/map_sheet_painter.hpp"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "paint/map_page.hpp"
#include "paint/map_painter.hpp"
#include "paint/pdf_bytes.hpp"
#include "paint/qt_runtime.hpp"

namespace planum::paint {

using geometry::MapSheet;

namespace {

struct PaperChoice {
    QPageSize size;
    QPageLayout::Orientation orientation = QPageLayout::Portrait;
    double width = 0.0; // [pt]
    double height = 0.0;
};

PaperChoice choose_paper(const MapPage& fitted) {
    const bool across = fitted.width > fitted.height;
    for (const auto name : {QPageSize::A4, QPageSize::A3, QPageSize::A2, QPageSize::A1, QPageSize::A0}) {
        const QSizeF upright = QPageSize(name).size(QPageSize::Point);
        for (const bool turned : {across, !across}) {
            const QSizeF size = turned ? upright.transposed() : upright;
            if (fitted.width > size.width() || fitted.height > size.height()) continue;
            return {QPageSize(name), turned ? QPageLayout::Landscape : QPageLayout::Portrait, size.width(),
                    size.height()};
        }
    }
    return {QPageSize(QSizeF(fitted.width, fitted.height), QPageSize::Point), QPageLayout::Portrait, fitted.width,
            fitted.height};
}

} // namespace

std::string render_map_png(const MapSheet& sheet, const MapSheetOptions& options) {
    constexpr double kMostPixels = 120e6;
    constexpr double kMostSide = 32767.0; // of QImage's painter
    ensure_qt_runtime();
    const MapPage page = lay_out_map(sheet, options.scale);
    const double per_point = options.dpi / 72.0;
    const double width = std::ceil(page.width * per_point);
    const double height = std::ceil(page.height * per_point);
    const double over = std::max({std::sqrt(width * height / kMostPixels), width / kMostSide, height / kMostSide});
    if (over > 1.0) {
        throw Error(ErrorCode::BadInput, fmt::format("a picture of {:.0f} × {:.0f} pixels is too large; 1:{:.0f} fits",
                                                     width, height, std::ceil(1.1 * options.scale * over)));
    }
    QImage image(static_cast<int>(width), static_cast<int>(height), QImage::Format_RGB32);
    if (image.isNull())
        throw Error(ErrorCode::Io, fmt::format("no memory for a picture of {:.0f} × {:.0f} pixels", width, height));
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(per_point, per_point);
    paint_map(painter, sheet, page, options.scale);
    painter.end();
    image.setDotsPerMeterX(static_cast<int>(std::lround(options.dpi / 0.0254)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) throw Error(ErrorCode::Internal, "the picture could not be encoded as PNG");
    return bytes.toStdString();
}

std::string render_map_pdf(const MapSheet& sheet, const MapSheetOptions& options, Progress& progress) {
    constexpr int kDotsPerInch = 1200;      // QPdfWriter rounds coordinates to this
    constexpr double kMostPoints = 14400.0; // of a PDF page
    ensure_qt_runtime();
    progress.step("writing the PDF");
    const MapPage fitted = lay_out_map(sheet, options.scale);
    const double over = std::max(fitted.width, fitted.height) / kMostPoints;
    if (over > 1.0) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("a page of {:.1f} × {:.1f} m is too large; 1:{:.0f} fits", fitted.width / 72.0 * 0.0254,
                                fitted.height / 72.0 * 0.0254, std::ceil(1.1 * options.scale * over)));
    }
    const PaperChoice paper = choose_paper(fitted);
    const MapPage page = lay_out_map(sheet, options.scale, paper.width, paper.height);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(kDotsPerInch);
        writer.setTitle(QString::fromStdString(sheet.title));
        writer.setCreator(QStringLiteral("Planum"));
        writer.setPageLayout(QPageLayout(paper.size, paper.orientation, QMarginsF(0, 0, 0, 0)));
        QPainter painter(&writer);
        painter.scale(kDotsPerInch / 72.0, kDotsPerInch / 72.0);
        paint_map(painter, sheet, page, options.scale);
    }
    std::string pdf = bytes.toStdString();
    set_creation_date(pdf, {});
    return pdf;
}

} // namespace planum::paint
