// SPDX-License-Identifier: MIT
#include "scans/surface/stray_points.hpp"

#include <algorithm>
#include <cmath>

#include "scans/surface/parallel.hpp"

namespace planum::scans {

namespace {

constexpr std::int32_t kNear = 3; // cells
constexpr std::int32_t kWide = 2 * kNear + 1;
constexpr double kNearCells = kWide * kWide - 1.0;

/// How many of the cells around each hold points: sums over the cells to the south-west of each corner.
class HeldCells {
  public:
    template<class Holds> // bool(cell)
    HeldCells(const GridFrame& frame, const SightRules& rules, const Holds& holds)
        : frame_(frame), rules_(rules), reach_(static_cast<std::int32_t>(std::lround(rules.around / frame.cell))),
          width_(static_cast<std::size_t>(frame.columns) + 1),
          sums_(width_ * (static_cast<std::size_t>(frame.rows) + 1), 0) {
        for (std::int32_t row = 0; row < frame.rows; ++row) {
            const std::size_t at = static_cast<std::size_t>(row) * width_;
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                const std::size_t c = at + static_cast<std::size_t>(column);
                const std::uint32_t one = holds(frame.at(row, column)) ? 1 : 0;
                sums_[c + width_ + 1] = sums_[c + width_] + sums_[c + 1] - sums_[c] + one;
            }
        }
    }

    /// So many cells nearby must lie as a cell does, or it is a stray.
    [[nodiscard]] double fewest(std::int32_t row, std::int32_t column) const {
        const auto south = static_cast<std::size_t>(std::max(0, row - reach_));
        const auto north = static_cast<std::size_t>(std::min(frame_.rows, row + reach_ + 1));
        const auto west = static_cast<std::size_t>(std::max(0, column - reach_));
        const auto east = static_cast<std::size_t>(std::min(frame_.columns, column + reach_ + 1));
        const std::uint32_t held = sums_[north * width_ + east] - sums_[south * width_ + east] -
                                   sums_[north * width_ + west] + sums_[south * width_ + west];
        const double share = static_cast<double>(held) / static_cast<double>((north - south) * (east - west));
        return std::max(rules_.fewest, rules_.share * kNearCells * share);
    }

  private:
    const GridFrame& frame_;
    const SightRules& rules_;
    std::int32_t reach_;
    std::size_t width_;
    std::vector<std::uint32_t> sums_;
};

/// Whether fewer than `fewest` cells nearby lie as one does; `lies(cell, most)` says whether something there is no
/// farther than `most` from its height [m].
class Neighbours {
  public:
    Neighbours(const GridFrame& frame, const SightRules& rules) : frame_(frame) {
        for (std::int32_t r = -kNear; r <= kNear; ++r) {
            for (std::int32_t c = -kNear; c <= kNear; ++c)
                most_.push_back(rules.rough + rules.slope * frame.cell * std::hypot(r, c));
        }
    }

    template<class Lies>
    [[nodiscard]] bool are_fewer(double fewest, std::int32_t row, std::int32_t column, const Lies& lies) const {
        int alike = -1; // itself
        for (std::int32_t r = std::max(0, row - kNear); r <= std::min(frame_.rows - 1, row + kNear); ++r) {
            for (std::int32_t c = std::max(0, column - kNear); c <= std::min(frame_.columns - 1, column + kNear); ++c) {
                const auto place = static_cast<std::size_t>((r - row + kNear) * kWide + c - column + kNear);
                if (lies(frame_.at(r, c), most_[place]) && ++alike >= fewest) return false;
            }
        }
        return alike < fewest;
    }

  private:
    const GridFrame& frame_;
    std::vector<double> most_; // by the place nearby
};

} // namespace

std::vector<bool> stray_cells(const SurfaceGrid& grid, const SightRules& rules) {
    const GridFrame& frame = grid.frame;
    const HeldCells held(frame, rules, [&](std::size_t cell) { return grid.state[cell] != CellState::Unseen; });
    const Neighbours nearby(frame, rules);
    std::vector<bool> stray(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (grid.state[cell] == CellState::Unseen) continue;
            const float height = grid.height[cell];
            stray[cell] = nearby.are_fewer(held.fewest(row, column), row, column, [&](std::size_t other, double most) {
                return std::abs(static_cast<double>(grid.height[other] - height)) <= most;
            });
        }
    }
    return stray;
}

std::vector<std::uint8_t> stray_layers(const LayerField& field, const SightRules& rules, int threads,
                                       Progress& progress) {
    const GridFrame& frame = field.frame;
    const HeldCells held(frame, rules, [&](std::size_t cell) { return !field.at(cell).empty(); });
    const Neighbours nearby(frame, rules);
    std::vector<std::uint8_t> stray(field.layers(), 0);
    for_each_part(static_cast<std::size_t>(frame.rows), threads, progress, [&](std::size_t part) {
        const auto row = static_cast<std::int32_t>(part);
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            const std::span<const HeightLayer> layers = field.at(cell);
            for (std::size_t k = 0; k < layers.size(); ++k) {
                if (layers[k].wide) continue;
                const float height = layers[k].height;
                const double fewest = held.fewest(row, column);
                const bool is_stray = nearby.are_fewer(fewest, row, column, [&](std::size_t other, double most) {
                    const std::span<const HeightLayer> there = field.at(other);
                    return std::any_of(there.begin(), there.end(), [&](const HeightLayer& layer) {
                        return std::abs(static_cast<double>(layer.height - height)) <= most;
                    });
                });
                stray[field.first(cell) + k] = is_stray ? 1 : 0;
            }
        }
    });
    return stray;
}

} // namespace planum::scans
