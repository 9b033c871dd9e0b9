// SPDX-License-Identifier: MIT
#include "gui/widgets/space/ground_tints.hpp"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace planum::gui {

std::shared_ptr<const TintGrid> tints_of(const std::vector<RegionShape>& shapes, const model::RecordIndex& index) {
    constexpr double kMostCells = 3000.0; // along either side
    const QRectF bounds = bounds_of(shapes);
    if (bounds.isEmpty()) return nullptr;
    auto grid = std::make_shared<TintGrid>();
    grid->low_x = bounds.left();
    grid->low_y = bounds.top();
    grid->cell = std::max(0.02, std::max(bounds.width(), bounds.height()) / kMostCells);
    grid->width = static_cast<int>(std::ceil(bounds.width() / grid->cell));
    grid->height = static_cast<int>(std::ceil(bounds.height() / grid->cell));
    QImage image(grid->width, grid->height, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.scale(1.0 / grid->cell, 1.0 / grid->cell);
    painter.translate(-grid->low_x, -grid->low_y);
    painter.setPen(Qt::NoPen);
    for (const RegionShape& shape : shapes) { // largest first: what lies inside it is painted over it
        const model::UnitIndex unit = index.find(shape.unit);
        if (unit == model::kNoUnit) continue;
        // Neighbouring numbers get hues far apart (multiples of the golden section).
        const double hue = std::fmod(0.12 + 0.618034 * static_cast<double>(unit), 1.0);
        painter.setBrush(QColor::fromHsvF(static_cast<float>(hue), 0.55F, 0.95F));
        QPainterPath path;
        for (const PointList& ring : shape.rings) path.addPolygon(QPolygonF(ring));
        painter.drawPath(path);
    }
    painter.end();
    grid->rgb.reserve(static_cast<std::size_t>(grid->width) * static_cast<std::size_t>(grid->height));
    for (int y = 0; y < grid->height; ++y) {
        for (int x = 0; x < grid->width; ++x) grid->rgb.push_back(image.pixel(x, y) & 0xffffffU);
    }
    return grid;
}

std::shared_ptr<const TintGrid> tints_of(const GroundColours& ground) {
    return std::make_shared<const TintGrid>(
        TintGrid{ground.low_x, ground.low_y, ground.cell, ground.columns, ground.rows, ground.rgb});
}

} // namespace planum::gui
