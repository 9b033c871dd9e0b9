// SPDX-License-Identifier: MIT
#include "paint/drawing_png.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "paint/drawing_painter.hpp"
#include "paint/paper.hpp"
#include "paint/qt_runtime.hpp"

namespace planum::paint {

std::string render_png(const strat::MatrixDrawing& drawing, const PngOptions& options) {
    constexpr double kPointsPerInch = 72.0;
    constexpr double kMaxSide = 32767.0; // of QImage's painter
    ensure_qt_runtime();
    const double scale = options.dpi / kPointsPerInch;
    const double width = std::ceil(drawing.width * scale);
    const double height = std::ceil(drawing.height * scale);
    const double pixels = width * height;
    if (!(width >= 1.0 && height >= 1.0)) throw Error(ErrorCode::BadInput, "the drawing has no size");
    if (pixels > static_cast<double>(options.max_pixels) || width > kMaxSide || height > kMaxSide) {
        const double shrink = std::min(
            {std::sqrt(static_cast<double>(options.max_pixels) / pixels), kMaxSide / width, kMaxSide / height});
        throw Error(
            ErrorCode::BadInput,
            fmt::format("a picture of {:.0f} × {:.0f} pixels is too large; use at most {:.0f} dpi, or SVG or PDF",
                        width, height, std::floor(options.dpi * shrink)));
    }
    return png_page(drawing.width, drawing.height, options.dpi,
                    [&](QPainter& painter) { paint_drawing(painter, drawing); });
}

} // namespace planum::paint
