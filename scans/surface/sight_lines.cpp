// SPDX-License-Identifier: MIT
#include "scans/surface/sight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "scans/surface/parallel.hpp"
#include "scans/surface/shadows.hpp"
#include "scans/surface/stray_points.hpp"

namespace planum::scans {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Cells within reach of a side.
std::vector<bool> near_sides(const SurfaceGrid& grid, const std::vector<bool>& stray, double reach) {
    const GridFrame& frame = grid.frame;
    const auto cells = static_cast<std::int32_t>(std::lround(reach / frame.cell));
    std::vector<bool> near(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (grid.state[cell] != CellState::Face || stray[cell]) continue;
            for (std::int32_t r = std::max(0, row - cells); r <= std::min(frame.rows - 1, row + cells); ++r) {
                for (std::int32_t c = std::max(0, column - cells); c <= std::min(frame.columns - 1, column + cells);
                     ++c)
                    near[frame.at(r, c)] = true;
            }
        }
    }
    return near;
}

/// `is_stray(cell, k)`: what the k-th layer there shows cannot be relied on.
template<class IsStray>
ScanSight seen_by(const LayerField& field, std::span<const RemovedLayer> removed, std::uint32_t mask,
                  const IsStray& is_stray) {
    ScanSight seen{std::vector<float>(field.frame.cells(), kUnknown),
                   std::vector<float>(field.frame.cells(), kUnknown)};
    const auto add = [&](std::size_t cell, const HeightLayer& layer) {
        if ((layer.scans & mask) == 0) return;
        const float high = layer.wide ? layer.high : layer.height;
        const float low = layer.wide ? layer.low : layer.height;
        if (!(seen.top[cell] >= high)) seen.top[cell] = high;
        if (!(seen.bottom[cell] <= low)) seen.bottom[cell] = low;
    };
    for (std::size_t cell = 0; cell < field.frame.cells(); ++cell) {
        const std::span<const HeightLayer> layers = field.at(cell);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (!is_stray(cell, k)) add(cell, layers[k]);
        }
    }
    for (const RemovedLayer& gone : removed) add(gone.cell, gone.layer);
    widen(field.frame, seen);
    return seen;
}

/// Whether no more than so many of the nearest cells, itself among them, hold points.
bool is_alone(const SurfaceGrid& grid, std::int32_t row, std::int32_t column, int most) {
    const GridFrame& frame = grid.frame;
    constexpr std::int32_t kNear = 3;
    int held = 0;
    for (std::int32_t r = std::max(0, row - kNear); r <= std::min(frame.rows - 1, row + kNear); ++r) {
        for (std::int32_t c = std::max(0, column - kNear); c <= std::min(frame.columns - 1, column + kNear); ++c) {
            if (grid.state[frame.at(r, c)] != CellState::Unseen && ++held > most) return false;
        }
    }
    return true;
}

/// Whether ground that can be relied on lies lower than it can fall on the way there.
bool is_over_ground(const SurfaceGrid& grid, const std::vector<bool>& stray, std::int32_t row, std::int32_t column,
                    const SightRules& rules) {
    const GridFrame& frame = grid.frame;
    const float height = grid.height[frame.at(row, column)];
    const auto reach = static_cast<std::int32_t>(std::lround(rules.ground_near / frame.cell));
    for (std::int32_t r = std::max(0, row - reach); r <= std::min(frame.rows - 1, row + reach); ++r) {
        for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame.columns - 1, column + reach); ++c) {
            const std::size_t other = frame.at(r, c);
            if (stray[other] || grid.state[other] == CellState::Unseen || grid.state[other] == CellState::Face)
                continue;
            const double most = rules.hangs + rules.slope * frame.cell * std::hypot(r - row, c - column);
            if (static_cast<double>(height - grid.height[other]) > most) return true;
        }
    }
    return false;
}

} // namespace

std::vector<float> lines_of_sight(const LayerField& field, std::span<const RemovedLayer> removed,
                                  const SurfaceGrid& grid, std::span<const SurfaceScan> scans, const SightRules& rules,
                                  int threads, Progress& progress) {
    const GridFrame& frame = grid.frame;
    std::vector<float> lowest(frame.cells(), kUnknown);
    const std::vector<bool> stray = stray_cells(grid, rules);
    const std::vector<bool> beside = near_sides(grid, stray, rules.beside_side);
    for (std::size_t scan = 0; scan < std::min<std::size_t>(scans.size(), kLastMaskBit); ++scan) {
        const ScanSight seen = seen_by(field, removed, mask_of(static_cast<std::uint16_t>(scan)),
                                       [&](std::size_t cell, std::size_t) { return bool{stray[cell]}; });
        const Shadows shadows(frame, seen, beside, scans[scan].station, rules);
        if (!shadows.are_of_one_station()) continue;
        for_each_part(static_cast<std::size_t>(frame.rows), threads, progress, [&](std::size_t part) {
            const auto row = static_cast<std::int32_t>(part);
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                const std::size_t cell = frame.at(row, column);
                if (grid.state[cell] != CellState::Unseen && !stray[cell]) continue;
                if (!std::isnan(seen.top[cell])) continue;
                const auto line = shadows.over(row, column);
                if (line && !(static_cast<double>(lowest[cell]) <= line->height))
                    lowest[cell] = static_cast<float>(line->height);
            }
        });
    }
    return lowest;
}

std::size_t mark_hanging(const LayerField& field, std::span<const RemovedLayer> removed,
                         std::span<const SurfaceScan> scans, const SightRules& rules, int threads, Progress& progress,
                         std::vector<bool>& marked) {
    const GridFrame& frame = field.frame;
    const std::vector<std::uint8_t> stray = stray_layers(field, rules, threads, progress);
    const std::vector<bool> no_sides(frame.cells()); // a return that hangs does so before any side
    marked.assign(field.layers(), false);
    for (std::size_t scan = 0; scan < std::min<std::size_t>(scans.size(), kLastMaskBit); ++scan) {
        const std::uint32_t mask = mask_of(static_cast<std::uint16_t>(scan));
        const ScanSight seen = seen_by(
            field, removed, mask, [&](std::size_t cell, std::size_t k) { return stray[field.first(cell) + k] != 0; });
        const Shadows shadows(frame, seen, no_sides, scans[scan].station, rules);
        if (!shadows.are_of_one_station()) continue;
        const auto hangs = [&](const HeightLayer& layer, std::int32_t row, std::int32_t column) {
            const std::optional<SightLine> line = shadows.over(row, column);
            if (!line) return false;
            // Where the edge is, is known no better than its points lie apart.
            const double unsure = rules.grazing + std::max(1.0, line->fall) * (seen.spacing + frame.cell);
            const auto height = static_cast<double>(layer.height);
            return height > line->height - unsure && !shadows.goes_on_at(height, row, column);
        };
        for (std::int32_t row = 0; row < frame.rows; ++row) {
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                const std::size_t cell = frame.at(row, column);
                const std::span<const HeightLayer> layers = field.at(cell);
                for (std::size_t k = 0; k < layers.size(); ++k) {
                    const std::size_t number = field.first(cell) + k;
                    if (stray[number] != 0 && layers[k].scans == mask && hangs(layers[k], row, column))
                        marked[number] = true;
                }
            }
        }
    }
    return static_cast<std::size_t>(std::count(marked.begin(), marked.end(), true));
}

std::size_t drop_hanging(SurfaceGrid& grid, const SightRules& rules) {
    const GridFrame& frame = grid.frame;
    const std::vector<bool> stray = stray_cells(grid, rules);
    const double usual = usual_share(frame, grid.height);
    const int most_alone = std::min(rules.alone, static_cast<int>(rules.alone_share * 49.0 * usual));
    std::vector<std::size_t> hanging;
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (!stray[cell]) continue;
            const bool on_line = static_cast<double>(grid.ceiling[cell] - grid.height[cell]) < rules.grazing;
            const bool alone = is_alone(grid, row, column, most_alone);
            if (on_line || (alone && is_over_ground(grid, stray, row, column, rules))) hanging.push_back(cell);
        }
    }
    for (const std::size_t cell : hanging) {
        grid.state[cell] = CellState::Unseen;
        grid.height[cell] = kUnknown;
        grid.spread[cell] = 0.0F;
        grid.slope[cell] = kUnknown;
        grid.count[cell] = 0;
        if (!grid.side_east.empty()) grid.side_east[cell] = kUnknown;
        if (!grid.side_north.empty()) grid.side_north[cell] = kUnknown;
    }
    return hanging.size();
}

} // namespace planum::scans
