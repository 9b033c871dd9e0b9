// SPDX-License-Identifier: MIT
#include "paint/map_sheet_painter.hpp"

#include <QPainter>

#include <algorithm>
#include <array>
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
    constexpr double kStrip = 2.0 / 3.0;    // of the height of the paper
    ensure_qt_runtime();
    progress.step("writing the PDF");
    const MapPage fitted = lay_out_map(sheet, options.scale);
    const double over = std::max(fitted.width, fitted.height) / kMostPoints;
    if (over > 1.0) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("a page of {:.1f} × {:.1f} m is too large; 1:{:.0f} fits", fitted.width / 72.0 * 0.0254,
                                fitted.height / 72.0 * 0.0254, std::ceil(1.1 * options.scale * over)));
    }
    PaperChoice paper = choose_paper(fitted.width, fitted.height);
    if (sheet.is_section && fitted.height < kStrip * paper.height) paper = cut_paper(fitted.width, fitted.height);
    const MapPage page = lay_out_map(sheet, options.scale, paper.width, paper.height);
    return pdf_page(paper, sheet.title, [&](QPainter& painter) { paint_map(painter, sheet, page, options.scale); });
}

double section_scale(const MapSheet& sheet) {
    ensure_qt_runtime();
    constexpr std::array kScales = {5.0, 10.0, 20.0};
    for (const double scale : kScales) {
        const MapPage page = lay_out_map(sheet, scale);
        if (choose_paper(page.width, page.height).size.id() == QPageSize::A4) return scale;
    }
    return kScales.back();
}

} // namespace planum::paint
