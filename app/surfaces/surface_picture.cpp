// SPDX-License-Identifier: MIT
#include "app/surfaces/surface_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "scans/surface/gap_filling.hpp"

namespace planum::app {

namespace {

constexpr double kNearGround = 0.05; // [m]
constexpr double kSmallHole = 0.05;  // from its rim [m]

geometry::SheetPicture clear_picture(const scans::GridFrame& frame) {
    geometry::SheetPicture picture;
    picture.left = static_cast<double>(frame.west) * frame.cell;
    picture.top = static_cast<double>(frame.south + frame.rows) * frame.cell;
    picture.pixel = frame.cell;
    picture.width = frame.columns;
    picture.height = frame.rows;
    picture.rgba.assign(frame.cells() * 4, 0);
    return picture;
}

// Row 0 of a grid is the southernmost, of a picture the uppermost.
std::uint8_t* pixel_of(geometry::SheetPicture& picture, std::size_t cell) {
    const auto columns = static_cast<std::size_t>(picture.width);
    const std::size_t row = static_cast<std::size_t>(picture.height) - 1 - cell / columns;
    return picture.rgba.data() + 4 * (row * columns + cell % columns);
}

void set_pixel(geometry::SheetPicture& picture, std::size_t cell, const std::array<double, 3>& colour) {
    std::uint8_t* pixel = pixel_of(picture, cell);
    for (std::size_t k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>(std::clamp(std::lround(colour[k]), 0L, 255L));
    pixel[3] = 255;
}

// Sums of what points show of each cell.
struct Seen {
    std::vector<std::array<float, 3>> colour;
    std::vector<std::uint32_t> coloured;
    std::vector<float> intensity;
    std::vector<std::uint32_t> measured;
};

class Watcher {
  public:
    Watcher(const scans::SurfaceGrid& grid, Seen& seen) : grid_(grid), frame_(grid.frame), seen_(seen) {}

    void take(const scans::PointBlock& block) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (block.validity[i] != scans::Validity::Valid) continue;
            const auto column = static_cast<std::int64_t>(std::floor(block.x[i] / frame_.cell)) - frame_.west;
            const auto row = static_cast<std::int64_t>(std::floor(block.y[i] / frame_.cell)) - frame_.south;
            if (column < 0 || row < 0 || column >= frame_.columns || row >= frame_.rows) continue;
            const std::size_t cell = frame_.at(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column));
            if (!(std::abs(block.z[i] - static_cast<double>(grid_.height[cell])) <= kNearGround)) continue;
            if (!block.colour.empty()) {
                const scans::Rgb& c = block.colour[i];
                seen_.colour[cell][0] += c.red;
                seen_.colour[cell][1] += c.green;
                seen_.colour[cell][2] += c.blue;
                ++seen_.coloured[cell];
            }
            if (!block.intensity.empty()) {
                seen_.intensity[cell] += block.intensity[i];
                ++seen_.measured[cell];
            }
        }
    }

  private:
    const scans::SurfaceGrid& grid_;
    const scans::GridFrame& frame_;
    Seen& seen_;
};

// Grey from 2 % to 98 % of the reflectances.
void paint_reflectance(const Seen& seen, geometry::SheetPicture& picture) {
    std::vector<float> means;
    for (std::size_t cell = 0; cell < seen.measured.size(); ++cell) {
        if (seen.measured[cell] > 0) means.push_back(seen.intensity[cell] / static_cast<float>(seen.measured[cell]));
    }
    if (means.empty()) return;
    std::sort(means.begin(), means.end());
    const double low = static_cast<double>(means[means.size() / 50]);
    const double high = static_cast<double>(means[means.size() - 1 - means.size() / 50]);
    for (std::size_t cell = 0; cell < seen.measured.size(); ++cell) {
        if (seen.measured[cell] == 0) continue;
        const double mean = static_cast<double>(seen.intensity[cell]) / seen.measured[cell];
        const double grey = high > low ? 40.0 + 205.0 * (mean - low) / (high - low) : 150.0;
        set_pixel(picture, cell, {grey, grey, grey});
    }
}

// Calls `visit` with where each pixel begins in `rgba`, and where its neighbours, up to eight, do.
template<class Visit>
void for_each_pixel(const geometry::SheetPicture& picture, Visit visit) {
    const auto columns = static_cast<std::size_t>(picture.width);
    const auto rows = static_cast<std::size_t>(picture.height);
    std::vector<std::size_t> around;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            around.clear();
            for (std::size_t r = row > 0 ? row - 1 : 0; r <= std::min(rows - 1, row + 1); ++r) {
                for (std::size_t c = column > 0 ? column - 1 : 0; c <= std::min(columns - 1, column + 1); ++c) {
                    if (r != row || c != column) around.push_back(4 * (r * columns + c));
                }
            }
            visit(4 * (row * columns + column), around);
        }
    }
}

// Clear pixels beside a known one become the mean of the known among their neighbours.
void grow(geometry::SheetPicture& picture) {
    const std::vector<std::uint8_t> before = picture.rgba;
    for_each_pixel(picture, [&](std::size_t here, const std::vector<std::size_t>& around) {
        if (before[here + 3] != 0) return;
        std::array<unsigned, 3> sum{};
        unsigned known = 0;
        for (const std::size_t there : around) {
            if (before[there + 3] == 0) continue;
            ++known;
            for (std::size_t k = 0; k < 3; ++k) sum[k] += before[there + k];
        }
        if (known == 0) return;
        for (std::size_t k = 0; k < 3; ++k) picture.rgba[here + k] = static_cast<std::uint8_t>(sum[k] / known);
        picture.rgba[here + 3] = 255;
    });
}

// Pixels beside a clear one become clear again, but for those that were `seen`.
void shrink(geometry::SheetPicture& picture, const std::vector<std::uint8_t>& seen) {
    const std::vector<std::uint8_t> before = picture.rgba;
    for_each_pixel(picture, [&](std::size_t here, const std::vector<std::size_t>& around) {
        if (seen[here + 3] != 0 || before[here + 3] == 0) return;
        const bool at_rim =
            around.size() < 8 || // nothing is known beyond the picture
            std::any_of(around.begin(), around.end(), [&](std::size_t there) { return before[there + 3] == 0; });
        if (at_rim) std::fill_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(here), 4, std::uint8_t{0});
    });
}

int hole_passes(const scans::GridFrame& frame) { return static_cast<int>(std::lround(kSmallHole / frame.cell)); }

} // namespace

void close_holes(geometry::SheetPicture& picture, int passes) {
    const std::vector<std::uint8_t> seen = picture.rgba;
    for (int pass = 0; pass < passes; ++pass) grow(picture);
    for (int pass = 0; pass < passes; ++pass) shrink(picture, seen);
}

geometry::SheetPicture shaded_relief(const scans::SurfaceGrid& grid) {
    scans::GapOptions gaps;
    gaps.reach = kSmallHole;
    const scans::FilledHeights filled = scans::fill_gaps(grid, gaps);
    const scans::GridFrame& frame = grid.frame;
    geometry::SheetPicture picture = clear_picture(frame);
    const auto height = [&](std::int32_t row, std::int32_t column) {
        if (row < 0 || column < 0 || row >= frame.rows || column >= frame.columns) return std::nan("");
        return static_cast<double>(filled.height[frame.at(row, column)]);
    };
    // Along one axis from the neighbours that are known.
    const auto gradient = [&](double before, double here, double after) {
        if (!std::isnan(before) && !std::isnan(after)) return (after - before) / (2.0 * frame.cell);
        if (!std::isnan(after)) return (after - here) / frame.cell;
        return std::isnan(before) ? 0.0 : (here - before) / frame.cell;
    };
    const double light = 1.0 / std::sqrt(3.0);
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const double here = height(row, column);
            if (std::isnan(here)) continue;
            const double dx = gradient(height(row, column - 1), here, height(row, column + 1));
            const double dy = gradient(height(row - 1, column), here, height(row + 1, column));
            const double upright = 1.0 / std::sqrt(1.0 + dx * dx + dy * dy); // cosine of the slope
            const double lit = std::max(0.0, (dx * light - dy * light + light) * upright);
            const double grey = (90.0 + 250.0 * lit) * (0.55 + 0.45 * upright);
            set_pixel(picture, frame.at(row, column), {grey, 0.985 * grey, 0.95 * grey});
        }
    }
    return picture;
}

Orthophoto orthophoto(const scans::SurfaceGrid& grid, std::span<const scans::SurfaceScan> scans, Progress& progress) {
    const scans::GridFrame& frame = grid.frame;
    Seen seen;
    seen.colour.resize(frame.cells());
    seen.coloured.resize(frame.cells());
    seen.intensity.resize(frame.cells());
    seen.measured.resize(frame.cells());
    progress.step("reading colours");
    for (const scans::SurfaceScan& scan : scans) {
        progress.check();
        Watcher watcher(grid, seen);
        scan.points->over(
            {frame.x(0) - frame.cell, frame.y(0) - frame.cell, frame.x(frame.columns), frame.y(frame.rows)},
            [&](const scans::PointBlock& block) { watcher.take(block); });
    }
    geometry::SheetPicture picture = clear_picture(frame);
    const bool coloured = std::any_of(seen.coloured.begin(), seen.coloured.end(), [](auto n) { return n > 0; });
    if (!coloured) paint_reflectance(seen, picture);
    for (std::size_t cell = 0; cell < frame.cells(); ++cell) {
        if (seen.coloured[cell] == 0) continue;
        std::array<double, 3> mean{};
        for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<double>(seen.colour[cell][k]) / seen.coloured[cell];
        set_pixel(picture, cell, mean);
    }
    close_holes(picture, hole_passes(frame));
    return {std::move(picture), coloured};
}

} // namespace planum::app
