// SPDX-License-Identifier: MIT
#include "paint/paper.hpp"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>

#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "paint/pdf_bytes.hpp"

namespace planum::paint {

PaperChoice choose_paper(double width, double height) {
    const bool across = width > height;
    for (const auto name : {QPageSize::A4, QPageSize::A3, QPageSize::A2, QPageSize::A1, QPageSize::A0}) {
        const QSizeF upright = QPageSize(name).size(QPageSize::Point);
        for (const bool turned : {across, !across}) {
            const QSizeF size = turned ? upright.transposed() : upright;
            if (width > size.width() || height > size.height()) continue;
            return {QPageSize(name), turned ? QPageLayout::Landscape : QPageLayout::Portrait, size.width(),
                    size.height()};
        }
    }
    return cut_paper(width, height);
}

PaperChoice cut_paper(double width, double height) {
    return {QPageSize(QSizeF(width, height), QPageSize::Point), QPageLayout::Portrait, width, height};
}

std::string png_page(double width, double height, double dpi, const std::function<void(QPainter&)>& paint) {
    const double per_point = dpi / 72.0;
    const double columns = std::ceil(width * per_point);
    const double rows = std::ceil(height * per_point);
    QImage image(static_cast<int>(columns), static_cast<int>(rows), QImage::Format_RGB32);
    if (image.isNull())
        throw Error(ErrorCode::Io, fmt::format("no memory for a picture of {:.0f} × {:.0f} pixels", columns, rows));
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(per_point, per_point);
    paint(painter);
    painter.end();
    image.setDotsPerMeterX(static_cast<int>(std::lround(dpi / 0.0254)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) throw Error(ErrorCode::Internal, "the picture could not be encoded as PNG");
    return bytes.toStdString();
}

std::string pdf_page(const PaperChoice& paper, const std::string& title, const std::function<void(QPainter&)>& paint) {
    constexpr int kDotsPerInch = 1200; // QPdfWriter rounds coordinates to this
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(kDotsPerInch);
        writer.setTitle(QString::fromStdString(title));
        writer.setCreator(QStringLiteral("Planum"));
        writer.setPageLayout(QPageLayout(paper.size, paper.orientation, QMarginsF(0, 0, 0, 0)));
        QPainter painter(&writer);
        painter.scale(kDotsPerInch / 72.0, kDotsPerInch / 72.0);
        paint(painter);
    }
    std::string pdf = bytes.toStdString();
    set_creation_date(pdf, {});
    return pdf;
}

} // namespace planum::paint
