// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include <QPageLayout>
#include <QPageSize>

class QPainter;

namespace planum::paint {

struct PaperChoice {
    QPageSize size;
    QPageLayout::Orientation orientation = QPageLayout::Portrait;
    double width = 0.0; ///< [pt]
    double height = 0.0;
};

/// The smallest paper from A4 to A0 that holds a page of that size [pt], upright or across; else a page of that size.
[[nodiscard]] PaperChoice choose_paper(double width, double height);

/// A page of just that size [pt].
[[nodiscard]] PaperChoice cut_paper(double width, double height);

/// What `paint` draws, in points, as PNG of that size [pt]. Throws Io when there is no memory for it.
[[nodiscard]] std::string png_page(double width, double height, double dpi,
                                   const std::function<void(QPainter&)>& paint);

/// What `paint` draws, in points, as one page of PDF without date. Needs ensure_qt_runtime().
[[nodiscard]] std::string pdf_page(const PaperChoice& paper, const std::string& title,
                                   const std::function<void(QPainter&)>& paint);

} // namespace planum::paint
