// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_index.hpp"

#include <algorithm>
#include <cmath>

namespace planum::strat {

namespace {

constexpr double kCell = 96.0; // [pt], a few boxes

double distance(const DrawPoint& p, const DrawPoint& a, const DrawPoint& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double along = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

DrawRect around(const DrawPoint& a, const DrawPoint& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

} // namespace

DrawingIndex::DrawingIndex(const MatrixDrawing& drawing) : below_(drawing.boxes.size()), above_(drawing.boxes.size()) {
    for (std::size_t b = 0; b < drawing.boxes.size(); ++b) {
        rects_.push_back(drawing.boxes[b].rect);
        for_cells(rects_.back(), [&](std::int64_t cell) { box_cells_[cell].push_back(static_cast<std::uint32_t>(b)); });
        for (const model::UnitId unit : drawing.boxes[b].units) box_of_unit_.emplace(unit, b);
    }
    for (std::size_t l = 0; l < drawing.lines.size(); ++l) {
        const DrawnLine& line = drawing.lines[l];
        below_.at(line.later).push_back(l);
        above_.at(line.earlier).push_back(l);
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const auto segment = static_cast<std::uint32_t>(segments_.size());
            segments_.push_back({line.points[i - 1], line.points[i], l});
            for_cells(around(line.points[i - 1], line.points[i]),
                      [&](std::int64_t cell) { segment_cells_[cell].push_back(segment); });
        }
    }
}

std::int64_t DrawingIndex::cell_of(double x, double y) const noexcept {
    const auto column = static_cast<std::int64_t>(std::floor(x / kCell));
    const auto row = static_cast<std::int64_t>(std::floor(y / kCell));
    constexpr std::int64_t kMostRows = std::int64_t{1} << 31;
    return column * kMostRows + row;
}

template<class Each>
void DrawingIndex::for_cells(const DrawRect& rect, Each each) const {
    for (double x = std::floor(rect.x / kCell) * kCell; x <= rect.right(); x += kCell) {
        for (double y = std::floor(rect.y / kCell) * kCell; y <= rect.bottom(); y += kCell) each(cell_of(x, y));
    }
}

std::optional<std::size_t> DrawingIndex::box_at(DrawPoint at) const {
    const auto cell = box_cells_.find(cell_of(at.x, at.y));
    if (cell == box_cells_.end()) return std::nullopt;
    for (const std::uint32_t b : cell->second) {
        const DrawRect& r = rects_[b];
        if (at.x >= r.x && at.x <= r.right() && at.y >= r.y && at.y <= r.bottom()) return b;
    }
    return std::nullopt;
}

std::vector<std::size_t> DrawingIndex::lines_at(DrawPoint at, double reach) const {
    std::vector<std::pair<double, std::size_t>> found;
    for_cells({at.x - reach, at.y - reach, 2.0 * reach, 2.0 * reach}, [&](std::int64_t cell) {
        const auto segments = segment_cells_.find(cell);
        if (segments == segment_cells_.end()) return;
        for (const std::uint32_t s : segments->second) {
            const double away = distance(at, segments_[s].from, segments_[s].to);
            if (away <= reach) found.emplace_back(away, segments_[s].line);
        }
    });
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> lines;
    for (const auto& [away, line] : found) {
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
    return lines;
}

std::optional<std::size_t> DrawingIndex::box_of(model::UnitId unit) const {
    const auto it = box_of_unit_.find(unit);
    return it == box_of_unit_.end() ? std::nullopt : std::optional(it->second);
}

} // namespace planum::strat
