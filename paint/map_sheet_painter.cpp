// SPDX-License-Identifier: MIT
#include "paint/map_sheet_painter.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "paint/map_page.hpp"
#include "paint/map_painter.hpp"
#include "paint/paper.hpp"
#include "paint/qt_runtime.hpp"

namespace planum::paint {

using geometry::MapSheet;

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
    return png_page(page.width, page.height, options.dpi,
                    [&](QPainter& painter) { paint_map(painter, sheet, page, options.scale); });
}

std::string render_map_pdf(const MapSheet& sheet, const MapSheetOptions& options, Progress& progress) {
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
    const PaperChoice paper = choose_paper(fitted.width, fitted.height);
    const MapPage page = lay_out_map(sheet, options.scale, paper.width, paper.height);
    return pdf_page(paper, sheet.title, [&](QPainter& painter) { paint_map(painter, sheet, page, options.scale); });
}

} // namespace planum::paint
