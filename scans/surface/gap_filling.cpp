// SPDX-License-Identifier: MIT
#include "scans/surface/gap_filling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "scans/surface/cells_within.hpp"
#include "scans/surface/leaning_sides.hpp"
#include "scans/surface/overhangs.hpp"
#include "scans/surface/spot_floors.hpp"

namespace planum::scans {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr int kSweeps = 60;
constexpr float kOverRelax = 1.6F;
constexpr double kUprightStep = 0.03; // sides whose ends differ by less are no sides [m]

/// Share of the square of side 1 around the origin where x·a + y·b > d, for a² + b² = 1.
double share_beyond(double a, double b, double d) {
    // The square's projection is a trapezium: level as far as `level`, falling to `reach`.
    const double wide = std::max(std::abs(a), std::abs(b));
    const double narrow = std::min(std::abs(a), std::abs(b));
    const double reach = 0.5 * (wide + narrow);
    const double level = 0.5 * (wide - narrow);
    const double at = std::abs(d);
    double beyond = 0.0;
    if (at < level) {
        beyond = 0.5 - at / wide;
    } else if (at < reach) {
        beyond = 0.5 * (reach - at) * (reach - at) / (wide * narrow);
    }
    return d >= 0.0 ? beyond : 1.0 - beyond;
}

class Filler {
  public:
    Filler(const SurfaceGrid& grid, const GapOptions& options)
        : grid_(grid), frame_(grid.frame), options_(options), in_hollow_(frame_.cells()), planum_(frame_.cells()) {
        const std::size_t cells = frame_.cells();
        filled_.frame = frame_;
        filled_.height.assign(cells, kUnknown);
        filled_.sigma.assign(cells, 0.0F);
        filled_.shadow_sigma.assign(cells, 0.0F);
        filled_.distance.assign(cells, 0.0F);
        filled_.was_seen.assign(cells, false);
        filled_.source.assign(cells, 0);
        filled_.hollow.assign(cells, 0.0F);
        filled_.laid.assign(cells, false);
        for (std::size_t i = 0; i < cells; ++i) {
            filled_.source[i] = static_cast<std::uint32_t>(i);
            filled_.was_seen[i] = grid.state[i] == CellState::Surface || grid.state[i] == CellState::Disputed;
            if (filled_.was_seen[i]) filled_.height[i] = grid.height[i];
        }
    }

    FilledHeights fill(const KnownGround& known) {
        std::vector<SpotHeight> floors = known.spots;
        for (const Overhang& overhang : find_overhangs(grid_, known.spots)) cover(overhang, floors);
        raise_fences();
        lay_floors(filled_, grid_, fence_, floors, options_.doubt);
        for (const SpotHeight& spot : known.spots)
            for_cells_within(frame_, spot.hollow, [&](std::size_t cell) { in_hollow_[cell] = true; });
        for (std::size_t i = 0; i < known.plana.size(); ++i)
            for_cells_within(frame_, known.plana[i], [&](std::size_t cell) { planum_[cell] = i + 1; });
        spread(Fences::Closed);
        relax();
        lay_fences();
        spread(Fences::Open); // what lies between fences only
        hints_hold_ = false;
        spread(Fences::Open); // where there is no ground under the lines of sight, or none but the floor of a hollow
        continue_leaning_sides(filled_, grid_, fence_);
        doubt_shadows();
        return std::move(filled_);
    }

  private:
    enum class Fences { Closed, Open };

    struct Reached {
        double distance = 0.0; // [cells]
        std::size_t cell = 0;
        std::int32_t from_row = 0; // the seen cell that it takes its height from
        std::int32_t from_column = 0;

        bool operator>(const Reached& other) const {
            return std::tie(distance, cell) > std::tie(other.distance, other.cell);
        }
    };

    template<class Visit>
    void for_four(std::int32_t row, std::int32_t column, const Visit& visit) const {
        if (row > 0) visit(row - 1, column);
        if (column > 0) visit(row, column - 1);
        if (column + 1 < frame_.columns) visit(row, column + 1);
        if (row + 1 < frame_.rows) visit(row + 1, column);
    }

    [[nodiscard]] std::int32_t row_of(std::size_t cell) const {
        return static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame_.columns));
    }

    [[nodiscard]] std::int32_t column_of(std::size_t cell) const {
        return static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame_.columns));
    }

    // Points of a side under an overhang are no side of the ground above it.
    void cover(const Overhang& overhang, std::vector<SpotHeight>& floors) {
        for (std::size_t i = 0; i < overhang.roof.size(); ++i) filled_.height[overhang.roof[i]] = overhang.ground[i];
        const double mouth = static_cast<double>(overhang.mouth.size()) * frame_.cell * frame_.cell;
        for (const std::size_t cell : overhang.mouth)
            filled_.hollow[cell] += static_cast<float>(overhang.volume / mouth);
        for (SpotHeight& floor : floors) {
            if (floor.hollow == overhang.outline) floor.is_under_overhang = true;
        }
    }

    [[nodiscard]] bool is_face(std::size_t cell) const {
        return grid_.state[cell] == CellState::Face && std::isnan(filled_.height[cell]);
    }

    // Faces, and the straight lines between near ones where no ground was seen: where points lie sparsely a wall shows
    // as a dotted line.
    void raise_fences() {
        fence_.assign(frame_.cells(), false);
        const auto reach = static_cast<std::int32_t>(std::lround(options_.fence_gap / frame_.cell));
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (is_face(cell)) fence_[cell] = true;
        }
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (!is_face(cell)) continue;
            const std::int32_t row = row_of(cell);
            const std::int32_t column = column_of(cell);
            for (std::int32_t r = row; r <= std::min(frame_.rows - 1, row + reach); ++r) {
                for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame_.columns - 1, column + reach);
                     ++c) {
                    if (r == row && c <= column) continue;
                    if (is_face(frame_.at(r, c))) connect(row, column, r, c);
                }
            }
        }
    }

    void connect(std::int32_t row, std::int32_t column, std::int32_t to_row, std::int32_t to_column) {
        const std::int32_t steps = std::max(std::abs(to_row - row), std::abs(to_column - column));
        const auto at = [&](std::int32_t i) {
            const double share = static_cast<double>(i) / steps;
            return frame_.at(row + static_cast<std::int32_t>(std::lround(share * (to_row - row))),
                             column + static_cast<std::int32_t>(std::lround(share * (to_column - column))));
        };
        for (std::int32_t i = 1; i < steps; ++i) {
            if (filled_.was_seen[at(i)]) return;
        }
        for (std::int32_t i = 1; i < steps; ++i) fence_[at(i)] = fence_[at(i)] || std::isnan(filled_.height[at(i)]);
    }

    [[nodiscard]] float side_east(std::size_t cell) const {
        return grid_.side_east.empty() ? kUnknown : grid_.side_east[cell];
    }

    [[nodiscard]] float side_north(std::size_t cell) const {
        return grid_.side_north.empty() ? kUnknown : grid_.side_north[cell];
    }

    [[nodiscard]] float ceiling(std::size_t cell) const {
        return grid_.ceiling.empty() || filled_.was_seen[cell] ? kUnknown : grid_.ceiling[cell];
    }

    /// Whether ground of that height can be continued into a cell without rising above the lines of sight over it.
    [[nodiscard]] bool admits(std::size_t cell, float height) const { return !(height > ceiling(cell) + kOnSightLine); }

    /// Whether nobody saw a cell outside the hollows, and `from` took its height from the floor of one: that floor ends
    /// at the outline, wherever the gap does.
    [[nodiscard]] bool lies_beside_hollow(std::size_t cell, std::size_t from) const {
        return !in_hollow_[cell] && !filled_.was_seen[cell] && filled_.laid[filled_.source[from]];
    }

    [[nodiscard]] bool is_level_with(std::size_t cell, std::size_t source) const {
        return planum_[cell] != 0 && planum_[cell] == planum_[source];
    }

    [[nodiscard]] float most_doubt(std::size_t cell, float sigma) const {
        return is_level_with(cell, filled_.source[cell]) ? std::min(sigma, options_.planum_doubt) : sigma;
    }

    // What lies in a shadow is somewhere between the line of sight over it and the ground it was continued from.
    void doubt_shadows() {
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            const float most = ceiling(cell);
            if (std::isnan(most) || std::isnan(filled_.height[cell])) continue;
            filled_.height[cell] = std::min(filled_.height[cell], most + kOnSightLine);
            filled_.shadow_sigma[cell] =
                most_doubt(cell, std::max(0.0F, most - filled_.height[cell]) * options_.shadow_doubt);
        }
    }

    // Every unknown cell takes the height of the ground that it is reached from first.
    void spread(Fences fences) {
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> waiting;
        const double most = options_.reach / frame_.cell;
        const auto offer = [&](std::int32_t row, std::int32_t column, const Reached& from) {
            const std::size_t cell = frame_.at(row, column);
            if (!std::isnan(filled_.height[cell]) || (fences == Fences::Closed && fence_[cell])) return;
            const std::size_t source = frame_.at(from.from_row, from.from_column);
            if (hints_hold_ && (!admits(cell, filled_.height[source]) || lies_beside_hollow(cell, source))) return;
            const double distance = std::hypot(row - from.from_row, column - from.from_column);
            const double before = static_cast<double>(filled_.distance[source]) / frame_.cell;
            if (before + distance <= most || is_level_with(cell, filled_.source[source]))
                waiting.push({distance, cell, from.from_row, from.from_column});
        };
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (std::isnan(filled_.height[cell])) continue;
            const Reached start{0.0, cell, row_of(cell), column_of(cell)};
            for_four(start.from_row, start.from_column, [&](std::int32_t r, std::int32_t c) { offer(r, c, start); });
        }
        while (!waiting.empty()) {
            const Reached next = waiting.top();
            waiting.pop();
            if (!std::isnan(filled_.height[next.cell])) continue;
            const std::size_t from = frame_.at(next.from_row, next.from_column);
            filled_.height[next.cell] = filled_.height[from];
            filled_.source[next.cell] = filled_.source[from];
            filled_.distance[next.cell] = filled_.distance[from] + static_cast<float>(next.distance * frame_.cell);
            filled_.sigma[next.cell] = most_doubt(
                next.cell, filled_.sigma[from] + static_cast<float>(next.distance * frame_.cell * options_.doubt));
            gaps_.push_back(next.cell);
            for_four(row_of(next.cell), column_of(next.cell),
                     [&](std::int32_t r, std::int32_t c) { offer(r, c, next); });
        }
    }

    void relax() {
        std::sort(gaps_.begin(), gaps_.end());
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            for (const std::size_t cell : gaps_) {
                float sum = 0.0F;
                float number = 0.0F;
                for_four(row_of(cell), column_of(cell), [&](std::int32_t r, std::int32_t c) {
                    const std::size_t other = frame_.at(r, c);
                    const float height = filled_.height[other];
                    if (std::isnan(height) || !admits(cell, height)) return;
                    if (lies_beside_hollow(cell, other) || lies_beside_hollow(other, cell)) return;
                    sum += height;
                    number += 1.0F;
                });
                if (number > 0.0F) filled_.height[cell] += kOverRelax * (sum / number - filled_.height[cell]);
            }
        }
    }

    struct Ends {
        float low = kUnknown;
        float high = kUnknown;
        double rise_east = 0.0; // direction in which the ground rises across the side
        double rise_north = 0.0;

        [[nodiscard]] bool are_two() const { return static_cast<double>(high - low) > kUprightStep; }
    };

    // The ground on both sides of a fence, as near as there is any: a wall's points may fall into two cells beside each
    // other.
    [[nodiscard]] Ends ends_of(const std::vector<float>& ground, std::int32_t row, std::int32_t column) const {
        Ends ends{};
        for (std::int32_t ring = 1; ring <= 2; ++ring) {
            ends = {};
            double sum = 0.0;
            double number = 0.0;
            double sum_east = 0.0;
            double sum_north = 0.0;
            for (std::int32_t r = std::max(0, row - ring); r <= std::min(frame_.rows - 1, row + ring); ++r) {
                for (std::int32_t c = std::max(0, column - ring); c <= std::min(frame_.columns - 1, column + ring);
                     ++c) {
                    const float height = ground[frame_.at(r, c)];
                    if (std::isnan(height)) continue;
                    if (!(ends.low <= height)) ends.low = height;
                    if (!(ends.high >= height)) ends.high = height;
                    const auto z = static_cast<double>(height);
                    sum += z;
                    number += 1.0;
                    sum_east += c - column;
                    sum_north += r - row;
                    ends.rise_east += z * (c - column);
                    ends.rise_north += z * (r - row);
                }
            }
            if (number == 0.0) continue;
            ends.rise_east -= sum / number * sum_east;
            ends.rise_north -= sum / number * sum_north;
            if (ends.are_two()) break;
        }
        return ends;
    }

    void lay_fences() {
        const std::vector<float> ground = filled_.height;
        std::vector<std::pair<std::size_t, Ends>> fences;
        shows_side_.assign(frame_.cells(), false);
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (!fence_[cell]) continue;
            const Ends ends = ends_of(ground, row_of(cell), column_of(cell));
            fences.emplace_back(cell, ends);
            shows_side_[cell] = grid_.state[cell] == CellState::Face && ends.are_two() &&
                                !std::isnan(side_east(cell)) && lies(cell, ends) == Lies::Between;
        }
        for (const auto& [cell, ends] : fences) lay_fence(ends, cell);
    }

    enum class Lies { Low, Between, High };

    /// Where the points of a face lie between the ground on both sides of it.
    [[nodiscard]] Lies lies(std::size_t cell, const Ends& ends) const {
        const float near = 0.15F * (ends.high - ends.low);
        const float spread = grid_.spread[cell];
        if (grid_.height[cell] + spread < ends.low + near) return Lies::Low;
        if (grid_.height[cell] - spread > ends.high - near) return Lies::High;
        return Lies::Between;
    }

    void lay_fence(const Ends& ends, std::size_t cell) {
        const bool is_face = grid_.state[cell] == CellState::Face;
        if (!ends.are_two() && is_face) {
            filled_.height[cell] = grid_.height[cell];
        } else if (!std::isnan(ends.low)) {
            filled_.height[cell] =
                ends.low + static_cast<float>(high_share(ends, cell, is_face)) * (ends.high - ends.low);
        }
        const double uncertain =
            ends.are_two() ? static_cast<double>(ends.high - ends.low) : static_cast<double>(grid_.spread[cell]) * 2.0;
        filled_.sigma[cell] = static_cast<float>(uncertain / std::sqrt(12.0));
    }

    /// Share of a cell on the upper side of the side that runs through it or past it.
    [[nodiscard]] double high_share(const Ends& ends, std::size_t cell, bool is_face) const {
        const double length = std::hypot(ends.rise_east, ends.rise_north);
        if (length > 1e-9) {
            const double a = ends.rise_east / length;
            const double b = ends.rise_north / length;
            if (const auto ahead = side_ahead(cell, a, b)) return share_beyond(a, b, *ahead);
        }
        if (!is_face) return 0.5;
        const Lies where = lies(cell, ends);
        return where == Lies::Low ? 0.0 : where == Lies::High ? 1.0 : 0.5;
    }

    /// How far the side runs from the middle of a cell in the direction (a, b) [cells]: the mean of the faces along it
    /// that show it, near ones counting more.
    [[nodiscard]] std::optional<double> side_ahead(std::size_t cell, double a, double b) const {
        const auto reach = static_cast<std::int32_t>(std::lround(options_.fence_gap / frame_.cell));
        constexpr double kAside = 2.5; // what lies farther across is another side [cells]
        const std::int32_t row = row_of(cell);
        const std::int32_t column = column_of(cell);
        double sum = 0.0;
        double weights = 0.0;
        for (std::int32_t r = std::max(0, row - reach); r <= std::min(frame_.rows - 1, row + reach); ++r) {
            for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame_.columns - 1, column + reach); ++c) {
                const std::size_t other = frame_.at(r, c);
                if (!shows_side_[other]) continue;
                const double east = c - column + static_cast<double>(side_east(other));
                const double north = r - row + static_cast<double>(side_north(other));
                const double ahead = east * a + north * b;
                if (std::abs(ahead) > kAside) continue;
                const double weight = 1.0 / (1.0 + east * east + north * north);
                sum += weight * ahead;
                weights += weight;
            }
        }
        if (weights == 0.0) return std::nullopt;
        return sum / weights;
    }

    const SurfaceGrid& grid_;
    const GridFrame& frame_;
    const GapOptions& options_;
    FilledHeights filled_;
    std::vector<bool> fence_;
    std::vector<bool> shows_side_; // faces with points between the ground on both sides
    std::vector<std::size_t> gaps_;
    std::vector<bool> in_hollow_;     // inside the outlines that come with spot heights
    std::vector<std::size_t> planum_; // position of its outline among those of plana, from 1; 0: on none
    bool hints_hold_ = true;          // what lines of sight and outlines of hollows say
};

} // namespace

FilledHeights fill_gaps(const SurfaceGrid& grid, const GapOptions& options, const KnownGround& known) {
    if (grid.ceiling.empty()) return Filler(grid, options).fill(known);
    SurfaceGrid clean = grid;
    drop_hanging(clean, options.sight);
    return Filler(clean, options).fill(known);
}

} // namespace planum::scans
