// SPDX-License-Identifier: MIT
#include "scans/surface/altered_ground.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "scans/surface/cell_patches.hpp"
#include "scans/surface/label_grid.hpp"

namespace planum::scans {

namespace {

constexpr double kTwoSided = 1.959964; // 95 % of a normal distribution

// Of a height; few points do not lie about the middle of the cell, which on a slope is a difference in height.
double variance(const SurfaceGrid& grid, std::size_t cell, const RiseRules& rules) {
    const double spread = std::max(static_cast<double>(grid.spread[cell]), rules.sensor_sigma);
    const double slope = std::isnan(grid.slope[cell]) ? 0.0 : static_cast<double>(grid.slope[cell]);
    const double beside = slope * grid.frame.cell / std::sqrt(12.0);
    const double points = std::max(1.0, static_cast<double>(grid.count[cell]));
    const auto pose = static_cast<double>(grid.pose_sigma[cell]);
    return (spread * spread + beside * beside) / points + pose * pose;
}

double detectable_rise(const SurfaceGrid& before, const SurfaceGrid& after, std::size_t cell, const RiseRules& rules) {
    const double noise = kTwoSided * std::sqrt(variance(before, cell, rules) + variance(after, cell, rules));
    return std::max(2.0 * rules.tolerance, std::hypot(rules.tolerance, noise));
}

double rise(const SurfaceGrid& before, const SurfaceGrid& after, std::size_t cell) {
    return static_cast<double>(after.height[cell]) - static_cast<double>(before.height[cell]);
}

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::int32_t row_of(const GridFrame& frame, std::size_t cell) {
    return static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame.columns));
}

std::int32_t column_of(const GridFrame& frame, std::size_t cell) {
    return static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame.columns));
}

// Of the cells, so that it lies in them also where they go round something.
std::size_t nearest_to_middle(const GridFrame& frame, const std::vector<std::size_t>& cells) {
    double row = 0.0;
    double column = 0.0;
    for (const std::size_t cell : cells) {
        row += row_of(frame, cell);
        column += column_of(frame, cell);
    }
    row /= static_cast<double>(cells.size());
    column /= static_cast<double>(cells.size());
    const auto away = [&](std::size_t cell) {
        return std::hypot(row_of(frame, cell) - row, column_of(frame, cell) - column);
    };
    return *std::min_element(cells.begin(), cells.end(),
                             [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
}

} // namespace

AlteredPatch patch_inside(const SurfaceGrid& grid, std::span<const std::size_t> cells,
                          std::span<const std::int32_t> region) {
    const GridFrame& frame = grid.frame;
    const double square = frame.cell * frame.cell;
    AlteredPatch patch;
    std::vector<std::size_t> inside;
    for (const std::size_t cell : cells) {
        if (region[cell] == kNoRegion) continue;
        const auto height = static_cast<double>(grid.height[cell]);
        patch.low = inside.empty() ? height : std::min(patch.low, height);
        patch.high = inside.empty() ? height : std::max(patch.high, height);
        patch.regions[region[cell]] += square;
        inside.push_back(cell);
    }
    if (inside.empty()) return patch;
    patch.area = static_cast<double>(inside.size()) * square;
    const std::size_t middle = nearest_to_middle(frame, inside);
    patch.x = frame.x(column_of(frame, middle));
    patch.y = frame.y(row_of(frame, middle));
    return patch;
}

std::vector<AlteredPatch> risen_ground(const SurfaceGrid& before, const SurfaceGrid& after,
                                       std::span<const std::int32_t> region, const RiseRules& rules) {
    if (!(before.frame == after.frame))
        throw Error(ErrorCode::BadInput, "surfaces lie on different cells; grid them on one frame first");
    const GridFrame& frame = after.frame;
    CellSet risen(frame.cells());
    for (std::size_t cell = 0; cell < frame.cells(); ++cell) {
        if (region[cell] == kNoRegion || before.state[cell] != CellState::Surface ||
            after.state[cell] != CellState::Surface)
            continue;
        const double up = rise(before, after, cell);
        risen[cell] = up > 2.0 * rules.tolerance && up > detectable_rise(before, after, cell, rules) ? 1 : 0;
    }
    risen = opened(frame, risen);
    std::vector<AlteredPatch> patches;
    for (std::size_t start = 0; start < risen.size(); ++start) {
        if (risen[start] == 0) continue;
        const std::vector<std::size_t> cells = take_patch(frame, risen, start);
        AlteredPatch patch = patch_inside(after, cells, region);
        if (patch.area < rules.least_area) continue;
        std::vector<double> rises;
        std::vector<double> bounds;
        for (const std::size_t cell : cells) {
            rises.push_back(rise(before, after, cell));
            bounds.push_back(detectable_rise(before, after, cell, rules));
        }
        patch.change = median(rises);
        patch.detectable = median(bounds);
        patches.push_back(std::move(patch));
    }
    std::stable_sort(patches.begin(), patches.end(),
                     [](const AlteredPatch& a, const AlteredPatch& b) { return a.area > b.area; });
    return patches;
}

} // namespace planum::scans
