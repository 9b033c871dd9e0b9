// SPDX-License-Identifier: MIT
#include "scans/surface/spot_floors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "core/geometry/polygons.hpp"
#include "scans/surface/window_sums.hpp"

namespace planum::scans {

namespace {

constexpr double kBeside = 0.1;    // [m] from a spot to the cell that it counts for
constexpr double kAround = 0.1;    // ground is looked for so far around a cell [m]
constexpr double kSeenShare = 0.2; // of the cells around; less is hardly any
constexpr double kReach = 1.5;     // no floor is level farther from where it was measured [m]
constexpr double kMostDoubt = 0.1; // [m]
constexpr float kEdge = 0.05F;     // ground of a hollow that has none higher around by so much is its edge [m]
constexpr float kSide = 0.9F;      // ground in a hollow that is steeper is its side; its rim is not

struct Place {
    std::int32_t row = 0;
    std::int32_t column = 0;
};

class Floors {
  public:
    Floors(FilledHeights& filled, const SurfaceGrid& grid, std::vector<bool>& fence, double doubt)
        : filled_(filled), grid_(grid), frame_(grid.frame), fence_(fence), doubt_(doubt),
          seen_(grid.frame, [&](std::size_t cell) { return filled.was_seen[cell] ? 1 : 0; }) {}

    void lay(const SpotHeight& spot) {
        const std::optional<Place> start = cell_for(spot);
        if (!start) return;
        const std::vector<Place> floor = unseen_around(*start, spot);
        most_distance_ = 0.5 * std::sqrt(static_cast<double>(floor.size())) * frame_.cell;
        if (!spot.is_under_overhang) continue_sides(floor, spot);
        for (const Place& place : floor) {
            const std::size_t cell = frame_.at(place.row, place.column);
            if (!std::isnan(filled_.height[cell])) continue;
            const double distance = std::hypot(place.row - start->row, place.column - start->column) * frame_.cell;
            set(cell, static_cast<float>(spot.z), distance, spot.sigma);
        }
    }

  private:
    /// The height of a side at its edge to the shadow, on its way down.
    struct Falling {
        float height = 0.0F;
        std::size_t cell = 0;
        Place from;

        bool operator<(const Falling& other) const {
            return std::tie(height, other.cell) < std::tie(other.height, cell);
        }
    };

    [[nodiscard]] bool is_hardly_seen(const Place& place) const {
        const auto near = static_cast<std::int32_t>(std::lround(kAround / frame_.cell));
        const std::int32_t all = seen_.cells_around(place.row, place.column, near);
        return seen_.around(place.row, place.column, near) < kSeenShare * all;
    }

    [[nodiscard]] bool is_open(const Place& place) const {
        const std::size_t cell = frame_.at(place.row, place.column);
        return grid_.state[cell] != CellState::Face && std::isnan(filled_.height[cell]) && is_hardly_seen(place);
    }

    [[nodiscard]] bool admits(const Place& place, float height) const {
        if (!is_open(place)) return false;
        if (grid_.ceiling.empty()) return true;
        return !(height > grid_.ceiling[frame_.at(place.row, place.column)] + kOnSightLine);
    }

    [[nodiscard]] bool is_in(const geometry::MultiPolygon& hollow, const Place& place) const {
        return geometry::contains(hollow, frame_.x(place.column), frame_.y(place.row));
    }

    [[nodiscard]] bool is_side(const Place& place, const geometry::MultiPolygon& hollow) const {
        const std::size_t cell = frame_.at(place.row, place.column);
        return filled_.was_seen[cell] && grid_.slope[cell] > kSide && !is_hardly_seen(place) && is_in(hollow, place) &&
               has_ground_above(place);
    }

    // The edge of an overhang seems steep, for points under it lie beside it; a side has some of itself above it.
    [[nodiscard]] bool has_ground_above(const Place& place) const {
        const float height = grid_.height[frame_.at(place.row, place.column)] + kEdge;
        const auto near = static_cast<std::int32_t>(std::lround(kAround / frame_.cell));
        for (std::int32_t r = std::max(0, place.row - near); r <= std::min(frame_.rows - 1, place.row + near); ++r) {
            for (std::int32_t c = std::max(0, place.column - near);
                 c <= std::min(frame_.columns - 1, place.column + near); ++c) {
                if (filled_.was_seen[frame_.at(r, c)] && grid_.height[frame_.at(r, c)] > height) return true;
            }
        }
        return false;
    }

    template<class Visit>
    void for_four(const Place& place, const Visit& visit) const {
        constexpr std::array<std::array<std::int32_t, 2>, 4> kSteps{{{-1, 0}, {0, -1}, {0, 1}, {1, 0}}};
        for (const auto& [up, right] : kSteps) {
            const Place other{place.row + up, place.column + right};
            if (other.row >= 0 && other.column >= 0 && other.row < frame_.rows && other.column < frame_.columns)
                visit(other, frame_.at(other.row, other.column));
        }
    }

    [[nodiscard]] std::optional<Place> cell_for(const SpotHeight& spot) const {
        const double east = std::floor(spot.x / frame_.cell) - static_cast<double>(frame_.west);
        const double north = std::floor(spot.y / frame_.cell) - static_cast<double>(frame_.south);
        if (!(east >= 0.0 && north >= 0.0 && east < frame_.columns && north < frame_.rows)) return std::nullopt;
        const auto column = static_cast<std::int32_t>(east);
        const auto row = static_cast<std::int32_t>(north);
        const auto near = static_cast<std::int32_t>(std::lround(kBeside / frame_.cell));
        std::optional<Place> nearest;
        double least = kBeside / frame_.cell;
        for (std::int32_t r = std::max(0, row - near); r <= std::min(frame_.rows - 1, row + near); ++r) {
            for (std::int32_t c = std::max(0, column - near); c <= std::min(frame_.columns - 1, column + near); ++c) {
                const double distance = std::hypot(r - row, c - column);
                if (distance > least || (nearest && distance == least)) continue;
                if (!is_in(spot.hollow, {r, c}) || !admits({r, c}, static_cast<float>(spot.z))) continue;
                nearest = Place{r, c};
                least = distance;
            }
        }
        return nearest;
    }

    [[nodiscard]] std::vector<Place> unseen_around(const Place& start, const SpotHeight& spot) const {
        std::vector<bool> reached(frame_.cells());
        std::vector<Place> places{start};
        reached[frame_.at(start.row, start.column)] = true;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Place here = places[i]; // the vector grows
            for_four(here, [&](const Place& other, std::size_t cell) {
                if (reached[cell] || !admits(other, static_cast<float>(spot.z))) return;
                if (std::hypot(other.row - start.row, other.column - start.column) * frame_.cell > kReach) return;
                if (!is_in(spot.hollow, other)) return;
                reached[cell] = true;
                places.push_back(other);
            });
        }
        return places;
    }

    // Each cell takes the highest that a side around it still has there: sides fall away from what was seen of them.
    void continue_sides(const std::vector<Place>& floor, const SpotHeight& spot) {
        std::vector<bool> is_of_floor(frame_.cells());
        for (const Place& place : floor) is_of_floor[frame_.at(place.row, place.column)] = true;
        std::priority_queue<Falling> waiting;
        const auto offer = [&](const Place& to, std::size_t cell, const Place& from) {
            const std::size_t source = frame_.at(from.row, from.column);
            const double distance = std::hypot(to.row - from.row, to.column - from.column) * frame_.cell;
            const float height = grid_.height[source] - grid_.slope[source] * static_cast<float>(distance);
            if (height > static_cast<float>(spot.z) && is_of_floor[cell] && admits(to, height))
                waiting.push({height, cell, from});
        };
        // Between the floor and what was seen of a side lie cells that have some ground around them.
        const auto near = static_cast<std::int32_t>(std::lround(kAround / frame_.cell)) + 1;
        for (const Place& place : floor) {
            for (std::int32_t r = std::max(0, place.row - near); r <= std::min(frame_.rows - 1, place.row + near);
                 ++r) {
                for (std::int32_t c = std::max(0, place.column - near);
                     c <= std::min(frame_.columns - 1, place.column + near); ++c) {
                    if (is_side({r, c}, spot.hollow)) offer(place, frame_.at(place.row, place.column), {r, c});
                }
            }
        }
        while (!waiting.empty()) {
            const Falling next = waiting.top();
            waiting.pop();
            if (!std::isnan(filled_.height[next.cell])) continue;
            const Place here{static_cast<std::int32_t>(next.cell / static_cast<std::size_t>(frame_.columns)),
                             static_cast<std::int32_t>(next.cell % static_cast<std::size_t>(frame_.columns))};
            const double distance = std::hypot(here.row - next.from.row, here.column - next.from.column) * frame_.cell;
            set(next.cell, next.height, distance, 0.0);
            for_four(here, [&](const Place& other, std::size_t cell) { offer(other, cell, next.from); });
        }
    }

    void set(std::size_t cell, float height, double distance, double sigma) {
        filled_.height[cell] = height;
        filled_.laid[cell] = true;
        fence_[cell] = false;
        filled_.distance[cell] = static_cast<float>(std::min(distance, most_distance_));
        filled_.sigma[cell] = static_cast<float>(std::hypot(sigma, std::min(distance * doubt_, kMostDoubt)));
    }

    FilledHeights& filled_;
    const SurfaceGrid& grid_;
    const GridFrame& frame_;
    std::vector<bool>& fence_;
    const double doubt_;
    const WindowSums<std::int32_t> seen_; // cells with ground
    double most_distance_ = 0.0;          // errors are alike over a hollow, not beyond it [m]
};

} // namespace

void lay_floors(FilledHeights& filled, const SurfaceGrid& grid, std::vector<bool>& fence,
                std::span<const SpotHeight> spots, double doubt) {
    if (spots.empty()) return;
    std::vector<SpotHeight> from_below(spots.begin(), spots.end());
    std::sort(from_below.begin(), from_below.end(), [](const SpotHeight& a, const SpotHeight& b) {
        return std::tie(a.z, a.x, a.y) < std::tie(b.z, b.x, b.y);
    });
    Floors floors(filled, grid, fence, doubt);
    for (const SpotHeight& spot : from_below) floors.lay(spot);
}

} // namespace planum::scans
