// SPDX-License-Identifier: MIT
#include "scans/surface/local_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planum::scans {

namespace {

constexpr double kLeastCells = 6.0;
constexpr double kPreferWhole = 1.5; // the whole window wins unless a half fits better by more than this
constexpr double kFits = 0.003;      // or the whole fits as well as points are measured [m]

struct Fit {
    bool found = false;
    LocalPlane plane;
};

/// Heights around a cell, from that of the cell.
class Neighbourhood {
  public:
    Neighbourhood(const GridFrame& frame, const std::vector<float>& height, std::int32_t row, std::int32_t column,
                  std::int32_t radius)
        : frame_(frame), height_(height), row_(row), column_(column), radius_(radius),
          here_(static_cast<double>(height[frame.at(row, column)])) {}

    [[nodiscard]] std::optional<LocalPlane> best() const {
        const Fit whole = fit(-radius_, radius_, -radius_, radius_);
        if (whole.found && whole.plane.rms <= kFits) return whole.plane;
        Fit best = whole;
        double least = whole.found ? whole.plane.rms / kPreferWhole : std::numeric_limits<double>::infinity();
        double off = whole.found ? whole.plane.off : std::numeric_limits<double>::infinity();
        for (const Fit& half : {fit(-radius_, radius_, 0, radius_), fit(-radius_, radius_, -radius_, 0),
                                fit(0, radius_, -radius_, radius_), fit(-radius_, 0, -radius_, radius_)}) {
            if (!half.found) continue;
            off = std::min(off, half.plane.off);
            if (half.plane.rms >= least) continue;
            best = half;
            least = half.plane.rms;
        }
        if (!best.found) return std::nullopt;
        best.plane.off = off;
        return best.plane;
    }

  private:
    /// Least squares of z = a + bx + cy over a window; places in cells.
    [[nodiscard]] Fit fit(std::int32_t south, std::int32_t north, std::int32_t west, std::int32_t east) const {
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
        for (std::int32_t r = std::max(south, -row_); r <= std::min(north, frame_.rows - 1 - row_); ++r) {
            for (std::int32_t c = std::max(west, -column_); c <= std::min(east, frame_.columns - 1 - column_); ++c) {
                const double z = static_cast<double>(height_[frame_.at(row_ + r, column_ + c)]) - here_;
                if (std::isnan(z)) continue;
                n += 1.0;
                sx += c;
                sy += r;
                sz += z;
                sxx += c * c;
                sxy += c * r;
                syy += r * r;
                sxz += c * z;
                syz += r * z;
                szz += z * z;
            }
        }
        if (n < kLeastCells) return {};
        const double xx = sxx - sx * sx / n;
        const double xy = sxy - sx * sy / n;
        const double yy = syy - sy * sy / n;
        const double xz = sxz - sx * sz / n;
        const double yz = syz - sy * sz / n;
        const double det = xx * yy - xy * xy;
        if (det < 1.0) return {}; // all in one line, or nearly
        const double b = (xz * yy - yz * xy) / det;
        const double c = (yz * xx - xz * xy) / det;
        const double rest = std::max(0.0, szz - sz * sz / n - b * xz - c * yz);
        // What the cell would be off a plane without it, from its residual and its leverage.
        const double x = sx / n;
        const double y = sy / n;
        const double leverage = 1.0 / n + (x * x * yy - 2.0 * x * y * xy + y * y * xx) / det;
        const double residual = sz / n - b * x - c * y;
        const double off = leverage < 0.999 ? std::abs(residual) / (1.0 - leverage) : 0.0;
        return {true, {b / frame_.cell, c / frame_.cell, std::sqrt(rest / (n - 3.0)), off}};
    }

    const GridFrame& frame_;
    const std::vector<float>& height_;
    const std::int32_t row_;
    const std::int32_t column_;
    const std::int32_t radius_;
    const double here_;
};

} // namespace

std::optional<LocalPlane> local_plane(const GridFrame& frame, const std::vector<float>& height, std::int32_t row,
                                      std::int32_t column) {
    const std::optional<LocalPlane> near = Neighbourhood(frame, height, row, column, 2).best();
    return near ? near : Neighbourhood(frame, height, row, column, 5).best();
}

} // namespace planum::scans
