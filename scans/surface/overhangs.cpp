// SPDX-License-Identifier: MIT
#include "scans/surface/overhangs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/geometry/polygons.hpp"

namespace planum::scans {

namespace {

constexpr double kReach = 0.35;     // faces are looked for so far outside an outline [m]
constexpr double kInside = 0.03;    // and so far inside: a hand errs by that [m]
constexpr double kAround = 0.15;    // ground so near says how high the rim is [m]
constexpr double kLeastDeep = 0.12; // higher faces may belong to the rim [m]
constexpr double kRim = 0.15;       // the ground around a hollow, for its depth [m]
constexpr double kRimShare = 0.25;  // of its cells that lie lower: a wall or a field may stand beside it
constexpr double kPiece = 0.05;     // of an outline that is looked at at once [m]
constexpr double kBordering = 0.06; // hands draw a line that two outlines share twice [m]
constexpr double kWidens = 0.15;
constexpr double kCollapses = 0.5;  // no earth stays up over more
constexpr double kSurely = 0.02;    // it widens by so much though the outline lay kInside farther out
constexpr double kLeastSide = 0.24; // so many faces, one beside the other [m]
constexpr double kLargest = 3.0;    // what is wider is no pit [m]

double quantile(std::vector<double>& values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

class Hollow {
  public:
    Hollow(const SurfaceGrid& grid, const geometry::MultiPolygon& outline, double floor,
           std::span<const geometry::MultiPolygon* const> others)
        : grid_(grid), frame_(grid.frame), outline_(outline), floor_(floor), others_(others) {
        const geometry::Extent extent = geometry::extent(outline);
        const auto clamped = [](double value, std::int32_t most) {
            return static_cast<std::int32_t>(std::clamp(std::floor(value), 0.0, static_cast<double>(most)));
        };
        const double west = static_cast<double>(frame_.west) * frame_.cell;
        const double south = static_cast<double>(frame_.south) * frame_.cell;
        const double wide = kReach + kAround;
        first_column_ = clamped((extent.low[0] - wide - west) / frame_.cell, frame_.columns);
        last_column_ = clamped((extent.high[0] + wide - west) / frame_.cell, frame_.columns - 1);
        first_row_ = clamped((extent.low[1] - wide - south) / frame_.cell, frame_.rows);
        last_row_ = clamped((extent.high[1] + wide - south) / frame_.cell, frame_.rows - 1);
    }

    [[nodiscard]] std::optional<Overhang> overhang() {
        const geometry::Extent extent = geometry::extent(outline_);
        if (extent.high[0] - extent.low[0] > kLargest || extent.high[1] - extent.low[1] > kLargest) return std::nullopt;
        Overhang found;
        found.outline = outline_;
        measure(found);
        std::vector<double> rates;
        std::vector<double> sure_rates;
        for (std::int32_t row = first_row_; row <= last_row_; ++row) {
            for (std::int32_t column = first_column_; column <= last_column_; ++column) {
                const std::size_t cell = frame_.at(row, column);
                if (grid_.state[cell] != CellState::Face) continue;
                const double outside = outside_at(row, column);
                if (outside < -kInside || outside > kReach || is_of_another(frame_.x(column), frame_.y(row))) continue;
                const std::optional<double> ground = ground_at(row, column);
                if (!ground) continue;
                const double deep = *ground - static_cast<double>(grid_.height[cell]);
                if (deep < -kLeastDeep || static_cast<double>(grid_.height[cell]) < floor_ - kLeastDeep) continue;
                if (deep >= kLeastDeep) {
                    rates.push_back(outside / deep);
                    sure_rates.push_back((outside - kInside) / deep);
                }
                if (outside <= 0.0) continue;
                found.roof.push_back(cell); // those too of which the ground above shows more points
                found.ground.push_back(static_cast<float>(*ground));
            }
        }
        if (static_cast<double>(rates.size()) * frame_.cell < kLeastSide || found.mouth.empty() || rim_.empty())
            return std::nullopt;
        found.widening = quantile(rates, 0.5);
        found.depth = quantile(rim_, kRimShare) - floor_;
        const double out = found.widening * found.depth;
        const Length around = length();
        const double corners = std::numbers::pi / 3.0 * out * out * around.free / around.all;
        found.volume = found.depth * (0.5 * around.free * out + corners);
        const double radius = around.all / (2.0 * std::numbers::pi);
        if (found.widening < kWidens || found.widening > kCollapses || quantile(sure_rates, 0.5) < kSurely ||
            found.depth < kLeastDeep || out > radius)
            return std::nullopt;
        return found;
    }

  private:
    struct Length {
        double all = 0.0;  // of the outline [m]
        double free = 0.0; // with no other hollow beyond it: the line of a section through a pit has no overhang
    };

    [[nodiscard]] Length length() const {
        Length length;
        for (const geometry::Rings& rings : outline_) {
            if (rings.empty()) continue;
            const geometry::Line3& ring = rings.front();
            const double turn = geometry::signed_area(ring) > 0.0 ? 1.0 : -1.0;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const geometry::Point3& a = ring[i];
                const geometry::Point3& b = ring[(i + 1) % ring.size()];
                const double east = b[0] - a[0];
                const double north = b[1] - a[1];
                const double side = std::hypot(east, north);
                if (side == 0.0) continue;
                const double pieces = std::max(1.0, std::ceil(side / kPiece));
                const double out = turn * kBordering / side;
                for (double piece = 0.5; piece < pieces; piece += 1.0) {
                    const double share = piece / pieces;
                    const double x = a[0] + share * east + out * north;
                    const double y = a[1] + share * north - out * east;
                    length.all += side / pieces;
                    if (!is_in_another(x, y)) length.free += side / pieces;
                }
            }
        }
        return length;
    }

    // How far outside the outline a cell lies, negative inside [m].
    [[nodiscard]] double outside_at(std::int32_t row, std::int32_t column) const {
        return outside_[static_cast<std::size_t>(row - first_row_) *
                            static_cast<std::size_t>(last_column_ - first_column_ + 1) +
                        static_cast<std::size_t>(column - first_column_)];
    }

    void measure(Overhang& found) {
        for (std::int32_t row = first_row_; row <= last_row_; ++row) {
            for (std::int32_t column = first_column_; column <= last_column_; ++column) {
                const double x = frame_.x(column);
                const double y = frame_.y(row);
                const double distance = geometry::distance_to_outline(outline_, x, y);
                const bool inside = geometry::contains(outline_, x, y);
                outside_.push_back(inside ? -distance : distance);
                const std::size_t cell = frame_.at(row, column);
                if (inside) found.mouth.push_back(cell);
                if (!inside && distance > kInside && distance < kRim && is_ground(cell))
                    rim_.push_back(static_cast<double>(grid_.height[cell]));
            }
        }
    }

    [[nodiscard]] bool is_in_another(double x, double y) const {
        return std::any_of(others_.begin(), others_.end(), [&](const geometry::MultiPolygon* other) {
            return other != &outline_ && geometry::contains(*other, x, y);
        });
    }

    // A side of another hollow, wherever the hand drew it.
    [[nodiscard]] bool is_of_another(double x, double y) const {
        return std::any_of(others_.begin(), others_.end(), [&](const geometry::MultiPolygon* other) {
            return other != &outline_ &&
                   (geometry::contains(*other, x, y) || geometry::distance_to_outline(*other, x, y) < kInside) &&
                   !is_near_outline(x, y);
        });
    }

    [[nodiscard]] bool is_near_outline(double x, double y) const {
        return geometry::distance_to_outline(outline_, x, y) < kInside;
    }

    [[nodiscard]] bool is_ground(std::size_t cell) const {
        return grid_.state[cell] == CellState::Surface || grid_.state[cell] == CellState::Disputed;
    }

    // The height of the ground beside the hollow near a cell.
    [[nodiscard]] std::optional<double> ground_at(std::int32_t row, std::int32_t column) const {
        const auto near = static_cast<std::int32_t>(std::lround(kAround / frame_.cell));
        std::vector<double> heights;
        for (std::int32_t r = std::max(first_row_, row - near); r <= std::min(last_row_, row + near); ++r) {
            for (std::int32_t c = std::max(first_column_, column - near); c <= std::min(last_column_, column + near);
                 ++c) {
                if (is_ground(frame_.at(r, c)) && outside_at(r, c) > kInside)
                    heights.push_back(static_cast<double>(grid_.height[frame_.at(r, c)]));
            }
        }
        if (heights.empty()) return std::nullopt;
        return quantile(heights, kRimShare);
    }

    const SurfaceGrid& grid_;
    const GridFrame& frame_;
    const geometry::MultiPolygon& outline_;
    const double floor_;
    std::span<const geometry::MultiPolygon* const> others_;
    std::int32_t first_row_ = 0;
    std::int32_t last_row_ = 0;
    std::int32_t first_column_ = 0;
    std::int32_t last_column_ = 0;
    std::vector<double> outside_;
    std::vector<double> rim_;
};

} // namespace

std::vector<Overhang> find_overhangs(const SurfaceGrid& grid, std::span<const SpotHeight> spots) {
    if (grid.frame.cells() == 0) return {};
    std::vector<const geometry::MultiPolygon*> hollows;
    std::vector<double> floors;
    for (const SpotHeight& spot : spots) {
        const auto same = std::find_if(hollows.begin(), hollows.end(),
                                       [&](const geometry::MultiPolygon* other) { return *other == spot.hollow; });
        if (same == hollows.end()) {
            hollows.push_back(&spot.hollow);
            floors.push_back(spot.z);
        } else {
            double& floor = floors[static_cast<std::size_t>(same - hollows.begin())];
            floor = std::min(floor, spot.z);
        }
    }
    std::vector<Overhang> found;
    for (std::size_t i = 0; i < hollows.size(); ++i) {
        if (auto overhang = Hollow(grid, *hollows[i], floors[i], hollows).overhang())
            found.push_back(*std::move(overhang));
    }
    return found;
}

} // namespace planum::scans
