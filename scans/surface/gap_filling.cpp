// SPDX-License-Identifier: MIT
#include "scans/surface/gap_filling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace planum::scans {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr int kSweeps = 60;
constexpr float kOverRelax = 1.6F;
constexpr double kUprightStep = 0.03; // sides whose ends differ by less are no sides [m]

class Filler {
  public:
    Filler(const SurfaceGrid& grid, const GapOptions& options) : grid_(grid), frame_(grid.frame), options_(options) {
        const std::size_t cells = frame_.cells();
        filled_ = {frame_, std::vector<float>(cells, kUnknown), std::vector<float>(cells, 0.0F),
                   std::vector<float>(cells, 0.0F), std::vector<bool>(cells)};
        for (std::size_t i = 0; i < cells; ++i) {
            filled_.was_seen[i] = grid.state[i] == CellState::Surface || grid.state[i] == CellState::Disputed;
            if (filled_.was_seen[i]) filled_.height[i] = grid.height[i];
        }
    }

    FilledHeights fill() {
        raise_fences();
        spread(Fences::Closed);
        relax();
        lay_fences();
        spread(Fences::Open); // what lies between fences only
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

    // Faces, and the straight lines between near ones where no ground was seen: where points lie sparsely a wall shows
    // as a dotted line.
    void raise_fences() {
        fence_.assign(frame_.cells(), false);
        const auto reach = static_cast<std::int32_t>(std::lround(options_.fence_gap / frame_.cell));
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (grid_.state[cell] == CellState::Face) fence_[cell] = true;
        }
        for (std::size_t cell = 0; cell < frame_.cells(); ++cell) {
            if (grid_.state[cell] != CellState::Face) continue;
            const std::int32_t row = row_of(cell);
            const std::int32_t column = column_of(cell);
            for (std::int32_t r = row; r <= std::min(frame_.rows - 1, row + reach); ++r) {
                for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame_.columns - 1, column + reach);
                     ++c) {
                    if (r == row && c <= column) continue;
                    if (grid_.state[frame_.at(r, c)] == CellState::Face) connect(row, column, r, c);
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
        for (std::int32_t i = 1; i < steps; ++i) fence_[at(i)] = true;
    }

    // Every unknown cell takes the height of the ground that it is reached from first.
    void spread(Fences fences) {
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> waiting;
        const double most = options_.reach / frame_.cell;
        const auto offer = [&](std::int32_t row, std::int32_t column, const Reached& from) {
            const std::size_t cell = frame_.at(row, column);
            if (!std::isnan(filled_.height[cell]) || (fences == Fences::Closed && fence_[cell])) return;
            const double distance = std::hypot(row - from.from_row, column - from.from_column);
            const std::size_t source = frame_.at(from.from_row, from.from_column);
            const double before = static_cast<double>(filled_.distance[source]) / frame_.cell;
            if (before + distance <= most) waiting.push({distance, cell, from.from_row, from.from_column});
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
            filled_.distance[next.cell] = filled_.distance[from] + static_cast<float>(next.distance * frame_.cell);
            filled_.sigma[next.cell] =
                filled_.sigma[from] + static_cast<float>(next.distance * frame_.cell * options_.doubt);
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
                    const float height = filled_.height[frame_.at(r, c)];
                    if (std::isnan(height)) return;
                    sum += height;
                    number += 1.0F;
                });
                if (number > 0.0F) filled_.height[cell] += kOverRelax * (sum / number - filled_.height[cell]);
            }
        }
    }

    void lay_fences() {
        const std::vector<float> ground = filled_.height;
        for (std::int32_t row = 0; row < frame_.rows; ++row) {
            for (std::int32_t column = 0; column < frame_.columns; ++column) {
                if (fence_[frame_.at(row, column)]) lay_fence(ground, row, column);
            }
        }
    }

    void lay_fence(const std::vector<float>& ground, std::int32_t row, std::int32_t column) {
        float low = kUnknown;
        float high = kUnknown;
        for (std::int32_t r = std::max(0, row - 1); r <= std::min(frame_.rows - 1, row + 1); ++r) {
            for (std::int32_t c = std::max(0, column - 1); c <= std::min(frame_.columns - 1, column + 1); ++c) {
                const float height = ground[frame_.at(r, c)];
                if (std::isnan(height)) continue;
                if (!(low <= height)) low = height;
                if (!(high >= height)) high = height;
            }
        }
        const std::size_t cell = frame_.at(row, column);
        const bool both_ends = static_cast<double>(high - low) > kUprightStep;
        if (!both_ends && grid_.state[cell] == CellState::Face) {
            filled_.height[cell] = grid_.height[cell];
        } else if (!std::isnan(low)) {
            filled_.height[cell] = 0.5F * (low + high);
        }
        const double uncertain =
            both_ends ? static_cast<double>(high - low) : static_cast<double>(grid_.spread[cell]) * 2.0;
        filled_.sigma[cell] = static_cast<float>(uncertain / std::sqrt(12.0));
    }

    const SurfaceGrid& grid_;
    const GridFrame& frame_;
    const GapOptions& options_;
    FilledHeights filled_;
    std::vector<bool> fence_;
    std::vector<std::size_t> gaps_;
};

} // namespace

FilledHeights fill_gaps(const SurfaceGrid& grid, const GapOptions& options) { return Filler(grid, options).fill(); }

} // namespace planum::scans
