// SPDX-License-Identifier: MIT
#include "app/regions/surface_heights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "app/surfaces/surface_cache.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"
#include "scans/surface/surface_builder.hpp"

namespace planum::app {

namespace {

using geometry::Line3;
using geometry::Point3;

constexpr double kCell = 0.04;   // [m]: an outline's place is not known better (σ 3 cm)
constexpr double kReach = 0.5;   // [m] to the nearest ground that scans show
constexpr double kStep = 0.1;    // [m] along a line
constexpr double kLeaves = 0.03; // [m] of the ground from a straight line

class Ground {
  public:
    explicit Ground(scans::SurfaceGrid grid) : grid_(std::move(grid)) {}

    [[nodiscard]] double at(double x, double y) const {
        const auto column = static_cast<std::int64_t>(std::floor(x / kCell)) - grid_.frame.west;
        const auto row = static_cast<std::int64_t>(std::floor(y / kCell)) - grid_.frame.south;
        if (const double z = cell(row, column); !std::isnan(z)) return z;
        constexpr auto kCells = static_cast<std::int64_t>(kReach / kCell);
        double nearest = kReach * kReach;
        double found = std::numeric_limits<double>::quiet_NaN();
        for (std::int64_t r = row - kCells; r <= row + kCells; ++r) {
            for (std::int64_t c = column - kCells; c <= column + kCells; ++c) {
                const double z = cell(r, c);
                if (std::isnan(z)) continue;
                const double dx = grid_.frame.x(static_cast<std::int32_t>(c)) - x;
                const double dy = grid_.frame.y(static_cast<std::int32_t>(r)) - y;
                if (dx * dx + dy * dy >= nearest) continue;
                nearest = dx * dx + dy * dy;
                found = z;
            }
        }
        return found;
    }

  private:
    [[nodiscard]] double cell(std::int64_t row, std::int64_t column) const {
        if (row < 0 || column < 0 || row >= grid_.frame.rows || column >= grid_.frame.columns)
            return std::numeric_limits<double>::quiet_NaN();
        return static_cast<double>(
            grid_.height[grid_.frame.at(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column))]);
    }

    scans::SurfaceGrid grid_;
};

// What lies between both ends of a line, where the ground is not straight.
Line3 between(const Point3& a, const Point3& b, const Ground& ground) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const int steps = static_cast<int>(std::ceil(length / kStep));
    Line3 profile = {{0.0, a[2], 0.0}}; // (along, height, share of the way)
    for (int i = 1; i < steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double z = ground.at(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]));
        if (!std::isnan(z)) profile.push_back({share * length, z, share});
    }
    profile.push_back({length, b[2], 1.0});
    Line3 points;
    for (const Point3& p : geometry::simplified(profile, kLeaves)) {
        if (p[2] > 0.0 && p[2] < 1.0)
            points.push_back({a[0] + p[2] * (b[0] - a[0]), a[1] + p[2] * (b[1] - a[1]), p[1]});
    }
    return points;
}

Line3 laid_on(const Line3& ring, const Ground& ground) {
    Line3 corners = ring;
    for (Point3& p : corners) {
        if (std::isnan(p[2])) p[2] = ground.at(p[0], p[1]);
    }
    Line3 laid;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = (i + 1) % ring.size();
        laid.push_back(corners[i]);
        const bool fresh = std::isnan(ring[i][2]) || std::isnan(ring[next][2]);
        if (!fresh || std::isnan(corners[i][2]) || std::isnan(corners[next][2])) continue;
        const Line3 more = between(corners[i], corners[next], ground);
        laid.insert(laid.end(), more.begin(), more.end());
    }
    return laid;
}

std::optional<Ground> ground_around(Project& project, const model::Surface& surface, const geometry::Extent& extent,
                                    Progress& progress) {
    try {
        const auto scans = surface_scans(project, surface.id, progress);
        if (scans.empty()) return std::nullopt;
        const scans::PlanBox box{extent.low[0] - kReach, extent.low[1] - kReach, extent.high[0] + kReach,
                                 extent.high[1] + kReach};
        scans::SurfaceOptions options;
        options.tolerance = project.record().settings.tolerance;
        return Ground(scans::build_surface(scans, scans::frame_around(box, kCell), options, progress).grid);
    } catch (const Error& e) {
        if (e.code() == ErrorCode::Cancelled) throw;
        return std::nullopt;
    }
}

} // namespace

void take_surface_heights(Project& project, const model::Surface& surface, geometry::MultiPolygon& shape,
                          Progress& progress) {
    geometry::Extent extent;
    for (const geometry::Rings& rings : shape) {
        for (const Line3& ring : rings) {
            const bool lacks = std::any_of(ring.begin(), ring.end(), [](const Point3& p) { return std::isnan(p[2]); });
            if (!lacks) continue;
            for (const Point3& p : ring) extent.add(p[0], p[1]);
        }
    }
    if (extent.is_empty()) return;
    const std::optional<Ground> ground = ground_around(project, surface, extent, progress);
    if (!ground) return;
    for (geometry::Rings& rings : shape) {
        for (Line3& ring : rings) ring = laid_on(ring, *ground);
    }
}

} // namespace planum::app
