// SPDX-License-Identifier: MIT
#include "gui/widgets/matrix/matrix_print.hpp"

#include <QCoreApplication>
#include <QPageLayout>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrinter>

#include <algorithm>
#include <cmath>

#include "gui/widgets/matrix/matrix_view.hpp"
#include "paint/drawing_painter.hpp"

namespace planum::gui {

namespace {

constexpr double kOverlap = 12.0;         // [pt] of neighbouring pages
constexpr double kLeastScale = 5.0 / 9.0; // words of 9 pt are read down to 5
constexpr double kPoint = 72.0;           // an inch

} // namespace

PrintPages pages_for(double drawing_width, double drawing_height, double page_width, double page_height) {
    PrintPages pages;
    const double fits = std::min(page_width / drawing_width, page_height / drawing_height);
    pages.scale = std::clamp(fits, kLeastScale, 1.0);
    if (fits >= kLeastScale) return pages;
    const auto count = [&](double whole, double page) {
        return std::max(1, static_cast<int>(std::ceil((whole * pages.scale - kOverlap) / (page - kOverlap))));
    };
    pages.across = count(drawing_width, page_width);
    pages.down = count(drawing_height, page_height);
    return pages;
}

void print_drawing(const strat::MatrixDrawing& drawing, QPrinter& printer) {
    const double dot = kPoint / printer.resolution(); // [pt]
    const QRectF page = printer.pageLayout().paintRect(QPageLayout::Point);
    const PrintPages pages = pages_for(drawing.width, drawing.height, page.width(), page.height());
    QPainter painter(&printer);
    for (int row = 0; row < pages.down; ++row) {
        for (int column = 0; column < pages.across; ++column) {
            if (row + column > 0) printer.newPage();
            painter.save();
            painter.scale(1.0 / dot, 1.0 / dot);
            painter.setClipRect(QRectF(0.0, 0.0, page.width(), page.height()));
            painter.translate(-column * (page.width() - kOverlap), -row * (page.height() - kOverlap));
            painter.scale(pages.scale, pages.scale);
            paint::paint_drawing(painter, drawing);
            painter.restore();
        }
    }
}

void print_matrix(const MatrixView& view, QWidget* parent) {
    const auto drawing = view.drawing_for_paper();
    if (drawing == nullptr) return;
    auto* dialog = new QPrintPreviewDialog(parent);
    dialog->setObjectName(QStringLiteral("printPreview"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QCoreApplication::translate("print", "Print the matrix"));
    dialog->printer()->setPageOrientation(drawing->width > drawing->height ? QPageLayout::Landscape
                                                                           : QPageLayout::Portrait);
    QObject::connect(dialog, &QPrintPreviewDialog::paintRequested, dialog,
                     [drawing](QPrinter* printer) { print_drawing(*drawing, *printer); });
    dialog->resize(1000, 800);
    dialog->show();
}

} // namespace planum::gui
