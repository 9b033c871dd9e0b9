// SPDX-License-Identifier: MIT
#include "scans/surface/local_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planum::scans {

namespace {

constexpr double kLeastCells = 6.0;
constexpr double kPreferWhole = 1.5; // the whole window wins unless a half fits better by more than this
constexpr double kFits = 0.003;      // or the whole fits as well as points are measured [m]

struct Window {
    std::int32_t south;
    std::int32_t north;
    std::int32_t west;
    std::int32_t east;
};

constexpr std::array<Window, 5> kWindows = {
    {{-2, 2, -2, 2}, {-2, 2, 0, 2}, {-2, 2, -2, 0}, {0, 2, -2, 2}, {-2, 0, -2, 2}}};

struct Fit {
    bool found = false;
    LocalPlane plane;
};

/// Least squares of z = a + bx + cy; places in cells, heights from that of the cell.
Fit fit(const std::array<double, 25>& z, const Window& window, double cell) {
    double n = 0;
    double sx = 0;
    double sy = 0;
    double sz = 0;
    double sxx = 0;
    double sxy = 0;
    double syy = 0;
    double sxz = 0;
    double syz = 0;
    double szz = 0;
    for (std::int32_t r = window.south; r <= window.north; ++r) {
        for (std::int32_t c = window.west; c <= window.east; ++c) {
            const double value = z[static_cast<std::size_t>((r + 2) * 5 + c + 2)];
            if (std::isnan(value)) continue;
            n += 1.0;
            sx += c;
            sy += r;
            sz += value;
            sxx += c * c;
            sxy += c * r;
            syy += r * r;
            sxz += c * value;
            syz += r * value;
            szz += value * value;
        }
    }
    if (n < kLeastCells) return {};
    const double xx = sxx - sx * sx / n;
    const double xy = sxy - sx * sy / n;
    const double yy = syy - sy * sy / n;
    const double xz = sxz - sx * sz / n;
    const double yz = syz - sy * sz / n;
    const double zz = szz - sz * sz / n;
    const double det = xx * yy - xy * xy;
    if (det < 1.0) return {}; // all in one line, or nearly
    const double b = (xz * yy - yz * xy) / det;
    const double c = (yz * xx - xz * xy) / det;
    const double rest = std::max(0.0, zz - b * xz - c * yz);
    return {true, {b / cell, c / cell, std::sqrt(rest / (n - 3.0))}};
}

} // namespace

std::optional<LocalPlane> local_plane(const GridFrame& frame, const std::vector<float>& height, std::int32_t row,
                                      std::int32_t column) {
    std::array<double, 25> z{};
    z.fill(std::nan(""));
    const auto here = static_cast<double>(height[frame.at(row, column)]);
    for (std::int32_t r = std::max(0, row - 2); r <= std::min(frame.rows - 1, row + 2); ++r) {
        for (std::int32_t c = std::max(0, column - 2); c <= std::min(frame.columns - 1, column + 2); ++c) {
            z[static_cast<std::size_t>((r - row + 2) * 5 + c - column + 2)] =
                static_cast<double>(height[frame.at(r, c)]) - here;
        }
    }
    const Fit whole = fit(z, kWindows[0], frame.cell);
    if (whole.found && whole.plane.rms <= kFits) return whole.plane;
    Fit best = whole;
    for (std::size_t i = 1; i < kWindows.size(); ++i) {
        const Fit half = fit(z, kWindows[i], frame.cell);
        const double factor = best.found && i > 0 && best.plane.rms == whole.plane.rms ? kPreferWhole : 1.0;
        if (half.found && (!best.found || half.plane.rms * factor < best.plane.rms)) best = half;
    }
    if (!best.found) return std::nullopt;
    return best.plane;
}

} // namespace planum::scans
