// SPDX-License-Identifier: MIT
#include "scans/surface/leaning_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace planum::scans {

namespace {

constexpr double kAround = 0.3;      // faces so far along and across say how a side leans [m]
constexpr double kReach = 0.3;       // a side is continued no farther [m]
constexpr double kToGround = 0.16;   // ground so near is that at the foot or the head of a side [m]
constexpr double kLeastAcross = 0.7; // [cells]
constexpr double kLeastSlope = 1.2;  // flatter is no side
constexpr double kExplained = 0.5;   // of the variance of heights
constexpr double kOffPlane = 2.0;    // faces farther off the plane are no part of it [root mean square]
constexpr double kOnPlane = 0.6;     // of the faces
constexpr int kTrims = 3;
constexpr std::size_t kLeastFaces = 20;

/// The plane of a side: z = height + gradient · (place − middle), places in cells.
struct Side {
    Eigen::Vector2d middle;
    Eigen::Vector2d gradient; // [m / cell]
    double height = 0.0;      // [m]
    double highest = 0.0;     // of its faces
    bool leans = false;

    [[nodiscard]] double at(const Eigen::Vector2d& place) const { return height + gradient.dot(place - middle); }
};

class Leaning {
  public:
    Leaning(FilledHeights& filled, const SurfaceGrid& grid, const std::vector<bool>& fence)
        : filled_(filled), grid_(grid), frame_(grid.frame), fence_(fence), stamp_(frame_.cells(), 0) {}

    void go_on() {
        const std::vector<std::uint32_t> nearest = nearest_faces();
        const std::vector<float> before = filled_.height;
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (nearest[cell] == kNone) continue;
            const std::optional<Side>& side = side_at(nearest[cell]);
            if (!side) continue;
            const auto height = static_cast<float>(side->at(middle_of(cell)));
            if (fence_[cell]) {
                filled_.height[cell] = between_grounds(before, cell, height);
            } else if (height > before[cell] && static_cast<double>(height) <= side->highest &&
                       !(height > ceiling(cell))) {
                filled_.height[cell] = height;
            }
        }
    }

  private:
    static constexpr std::uint32_t kNone = 0xffffffff;

    [[nodiscard]] std::int32_t row_of(std::size_t cell) const {
        return static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame_.columns));
    }

    [[nodiscard]] std::int32_t column_of(std::size_t cell) const {
        return static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame_.columns));
    }

    [[nodiscard]] Eigen::Vector2d middle_of(std::size_t cell) const { return {column_of(cell), row_of(cell)}; }

    [[nodiscard]] bool shows_side(std::size_t cell) const {
        return fence_[cell] && grid_.state[cell] == CellState::Face && !std::isnan(grid_.side_east[cell]);
    }

    [[nodiscard]] bool is_gap(std::size_t cell) const {
        return !filled_.was_seen[cell] && !filled_.laid[cell] && !std::isnan(filled_.height[cell]);
    }

    [[nodiscard]] float ceiling(std::size_t cell) const {
        return grid_.ceiling.empty() ? std::numeric_limits<float>::quiet_NaN() : grid_.ceiling[cell];
    }

    // No higher and no lower than the ground on both sides; without ground nearby as it was.
    [[nodiscard]] float between_grounds(const std::vector<float>& heights, std::size_t cell, float height) const {
        float low = std::numeric_limits<float>::infinity();
        float high = -low;
        for_around(cell, static_cast<std::int32_t>(std::lround(kToGround / frame_.cell)), [&](std::size_t other) {
            if (fence_[other] || std::isnan(heights[other])) return;
            low = std::min(low, heights[other]);
            high = std::max(high, heights[other]);
        });
        return low <= high ? std::clamp(height, low, high) : heights[cell];
    }

    template<class Visit>
    void for_around(std::size_t cell, std::int32_t reach, const Visit& visit) const {
        const std::int32_t row = row_of(cell);
        const std::int32_t column = column_of(cell);
        for (std::int32_t r = std::max(0, row - reach); r <= std::min(frame_.rows - 1, row + reach); ++r) {
            for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame_.columns - 1, column + reach); ++c)
                visit(frame_.at(r, c));
        }
    }

    // Through gaps only, so that no side goes on beyond ground that was seen.
    [[nodiscard]] std::vector<std::uint32_t> nearest_faces() const {
        std::vector<std::uint32_t> nearest(frame_.cells(), kNone);
        std::vector<std::size_t> rim;
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (!shows_side(cell)) continue;
            nearest[cell] = static_cast<std::uint32_t>(cell);
            rim.push_back(cell);
        }
        const auto steps = static_cast<int>(std::lround(kReach / frame_.cell));
        for (int step = 0; step < steps && !rim.empty(); ++step) {
            std::vector<std::size_t> next;
            for (const std::size_t cell : rim) {
                for_around(cell, 1, [&](std::size_t other) {
                    if (nearest[other] != kNone || !is_gap(other)) return;
                    nearest[other] = nearest[cell];
                    next.push_back(other);
                });
            }
            rim = std::move(next);
        }
        return nearest;
    }

    // One plane for each few cells: it changes slowly along a side.
    const std::optional<Side>& side_at(std::size_t face) {
        constexpr std::int32_t kBlock = 4; // [cells]
        const std::size_t block = frame_.at(row_of(face) / kBlock * kBlock, column_of(face) / kBlock * kBlock);
        const auto [at, is_new] = sides_.try_emplace(block);
        if (is_new) at->second = fit(faces_with(face));
        return at->second;
    }

    // Faces that hang together with this one, one empty cell between them at most.
    [[nodiscard]] std::vector<std::size_t> faces_with(std::size_t face) {
        std::vector<std::size_t> faces{face};
        stamp_[face] = ++now_;
        const double most = kAround / frame_.cell;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for_around(faces[i], 2, [&](std::size_t other) {
                if (stamp_[other] == now_ || !shows_side(other)) return;
                if ((middle_of(other) - middle_of(face)).norm() > most) return;
                stamp_[other] = now_;
                faces.push_back(other);
            });
        }
        return faces;
    }

    [[nodiscard]] Eigen::Vector2d place_of(std::size_t face) const {
        return middle_of(face) + Eigen::Vector2d(grid_.side_east[face], grid_.side_north[face]);
    }

    // Faces of the ground at the foot of a side and of its head are no part of its plane.
    [[nodiscard]] std::optional<Side> fit(std::vector<std::size_t> faces) const {
        const std::size_t all = faces.size();
        std::optional<Side> side;
        for (int trim = 0; trim <= kTrims; ++trim) {
            if (faces.size() < kLeastFaces || static_cast<double>(faces.size()) < kOnPlane * static_cast<double>(all))
                return std::nullopt;
            side = plane_of(faces);
            if (trim == kTrims) break;
            const auto off = [&](std::size_t face) {
                return std::abs(side->at(place_of(face)) - static_cast<double>(grid_.height[face]));
            };
            double squares = 0.0;
            for (const std::size_t face : faces) squares += off(face) * off(face);
            const double most = kOffPlane * std::sqrt(squares / static_cast<double>(faces.size()));
            std::erase_if(faces, [&](std::size_t face) { return off(face) > most; });
        }
        return side->leans ? side : std::nullopt;
    }

    [[nodiscard]] Side plane_of(const std::vector<std::size_t>& faces) const {
        Side side;
        side.middle.setZero();
        side.highest = static_cast<double>(grid_.height[faces.front()]);
        for (const std::size_t face : faces) {
            side.middle += place_of(face) / static_cast<double>(faces.size());
            side.height += static_cast<double>(grid_.height[face]) / static_cast<double>(faces.size());
            side.highest = std::max(side.highest, static_cast<double>(grid_.height[face]));
        }
        Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
        Eigen::Vector2d with_height = Eigen::Vector2d::Zero();
        double heights = 0.0; // of points, within cells too
        for (const std::size_t face : faces) {
            const Eigen::Vector2d off = place_of(face) - side.middle;
            const double up = static_cast<double>(grid_.height[face]) - side.height;
            const auto within = static_cast<double>(grid_.spread[face]);
            spread += off * off.transpose();
            with_height += up * off;
            heights += up * up + within * within;
        }
        // Across is where the faces are narrow. What their heights have to do with the way along, as where the shadow
        // on an upright wall runs aslant, is no lean.
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
        const Eigen::Vector2d narrow = axes.eigenvectors().col(0);
        const Eigen::Vector2d wide = axes.eigenvectors().col(1);
        const double along = wide.dot(with_height) / std::max(axes.eigenvalues()(1), 1e-9);
        const double across = narrow.dot(with_height) / std::max(axes.eigenvalues()(0), 1e-9);
        side.gradient = along * wide + across * narrow;
        double nearest = 0.0;
        double farthest = 0.0;
        for (const std::size_t face : faces) {
            const double off = narrow.dot(place_of(face) - side.middle);
            nearest = std::min(nearest, off);
            farthest = std::max(farthest, off);
        }
        const double left = heights - along * along * axes.eigenvalues()(1);
        side.leans = across * across * axes.eigenvalues()(0) >= kExplained * left &&
                     std::abs(across) >= kLeastSlope * frame_.cell && std::abs(across) >= std::abs(along) &&
                     farthest - nearest >= kLeastAcross;
        return side;
    }

    FilledHeights& filled_;
    const SurfaceGrid& grid_;
    const GridFrame& frame_;
    const std::vector<bool>& fence_;
    std::vector<std::uint32_t> stamp_; // when a face was met last
    std::uint32_t now_ = 0;
    std::unordered_map<std::size_t, std::optional<Side>> sides_; // by the first cell of a block
};

} // namespace

void continue_leaning_sides(FilledHeights& filled, const SurfaceGrid& grid, const std::vector<bool>& fence) {
    if (!grid.side_east.empty()) Leaning(filled, grid, fence).go_on();
}

} // namespace planum::scans
