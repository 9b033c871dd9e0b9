// SPDX-License-Identifier: MIT
#include "scans/surface/sight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "scans/surface/parallel.hpp"

namespace planum::scans {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// How many of the cells around each hold points: sums over the cells to the south-west of each corner.
std::vector<std::uint32_t> held_sums(const SurfaceGrid& grid) {
    const GridFrame& frame = grid.frame;
    const std::size_t width = static_cast<std::size_t>(frame.columns) + 1;
    std::vector<std::uint32_t> sums(width * (static_cast<std::size_t>(frame.rows) + 1), 0);
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        const std::size_t at = static_cast<std::size_t>(row) * width;
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t c = at + static_cast<std::size_t>(column);
            const std::uint32_t one = grid.state[frame.at(row, column)] == CellState::Unseen ? 0 : 1;
            sums[c + width + 1] = sums[c + width] + sums[c + 1] - sums[c] + one;
        }
    }
    return sums;
}

/// Cells that hold points at a height at which hardly any cells around have theirs.
std::vector<bool> stray_cells(const SurfaceGrid& grid, const SightRules& rules) {
    const GridFrame& frame = grid.frame;
    constexpr std::int32_t kNear = 3;
    constexpr double kNearCells = (2.0 * kNear + 1.0) * (2.0 * kNear + 1.0) - 1.0;
    const std::vector<std::uint32_t> sums = held_sums(grid);
    const std::size_t width = static_cast<std::size_t>(frame.columns) + 1;
    const auto reach = static_cast<std::int32_t>(std::lround(rules.around / frame.cell));
    const auto share_around = [&](std::int32_t row, std::int32_t column) {
        const auto south = static_cast<std::size_t>(std::max(0, row - reach));
        const auto north = static_cast<std::size_t>(std::min(frame.rows, row + reach + 1));
        const auto west = static_cast<std::size_t>(std::max(0, column - reach));
        const auto east = static_cast<std::size_t>(std::min(frame.columns, column + reach + 1));
        const std::uint32_t held = sums[north * width + east] - sums[south * width + east] -
                                   sums[north * width + west] + sums[south * width + west];
        return static_cast<double>(held) / static_cast<double>((north - south) * (east - west));
    };
    const auto alike = [&](std::int32_t row, std::int32_t column) {
        const float height = grid.height[frame.at(row, column)];
        int number = 0;
        for (std::int32_t r = std::max(0, row - kNear); r <= std::min(frame.rows - 1, row + kNear); ++r) {
            for (std::int32_t c = std::max(0, column - kNear); c <= std::min(frame.columns - 1, column + kNear); ++c) {
                const double most = rules.rough + rules.slope * frame.cell * std::hypot(r - row, c - column);
                if (std::abs(static_cast<double>(grid.height[frame.at(r, c)] - height)) <= most) ++number;
            }
        }
        return number - 1; // itself
    };
    std::vector<bool> stray(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (grid.state[cell] == CellState::Unseen) continue;
            const double least = std::max(rules.fewest, rules.share * kNearCells * share_around(row, column));
            stray[cell] = static_cast<double>(alike(row, column)) < least;
        }
    }
    return stray;
}

/// Cells within reach of a side.
std::vector<bool> near_sides(const SurfaceGrid& grid, const std::vector<bool>& stray, double reach) {
    const GridFrame& frame = grid.frame;
    const auto cells = static_cast<std::int32_t>(std::lround(reach / frame.cell));
    std::vector<bool> near(frame.cells());
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (grid.state[cell] != CellState::Face || stray[cell]) continue;
            for (std::int32_t r = std::max(0, row - cells); r <= std::min(frame.rows - 1, row + cells); ++r) {
                for (std::int32_t c = std::max(0, column - cells); c <= std::min(frame.columns - 1, column + cells);
                     ++c)
                    near[frame.at(r, c)] = true;
            }
        }
    }
    return near;
}

/// What one scan saw of each cell; stray cells show nothing that could be relied on.
struct Seen {
    std::vector<float> top;
    std::vector<float> bottom;
    double spacing = 0.0; // from one cell with points to the next, where the scan saw the ground [m]
    double widened = 0.0; // cells so near to such a cell count as seen, or sparse points would be seen through [m]
};

/// Share of the cells that hold points, around the middle one of all that do.
double usual_share(const GridFrame& frame, const std::vector<float>& top) {
    constexpr std::int32_t kReach = 5;
    std::vector<double> shares;
    const std::size_t step = std::max<std::size_t>(1, frame.cells() / 20000);
    for (std::size_t cell = 0; cell < frame.cells(); cell += step) {
        if (std::isnan(top[cell])) continue;
        const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame.columns));
        const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame.columns));
        if (row < kReach || column < kReach || row + kReach >= frame.rows || column + kReach >= frame.columns) continue;
        int seen = 0;
        for (std::int32_t r = row - kReach; r <= row + kReach; ++r) {
            for (std::int32_t c = column - kReach; c <= column + kReach; ++c)
                seen += std::isnan(top[frame.at(r, c)]) ? 0 : 1;
        }
        constexpr double kCells = (2.0 * kReach + 1.0) * (2.0 * kReach + 1.0);
        shares.push_back(seen / kCells);
    }
    if (shares.empty()) return 1.0;
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::nth_element(shares.begin(), middle, shares.end());
    return *middle;
}

void widen(const GridFrame& frame, Seen& seen) {
    seen.spacing = frame.cell / std::sqrt(usual_share(frame, seen.top));
    const auto reach = static_cast<std::int32_t>(std::lround(1.5 * (seen.spacing / frame.cell - 1.0)));
    seen.widened = reach * frame.cell;
    if (reach <= 0) return;
    constexpr std::int32_t kSparsest = 6;
    if (reach > kSparsest) { // between points so far apart nothing is an edge
        seen.top.assign(seen.top.size(), kUnknown);
        return;
    }
    const Seen points = seen;
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (!std::isnan(points.top[cell])) continue;
            double nearest = 1e30;
            for (std::int32_t r = std::max(0, row - reach); r <= std::min(frame.rows - 1, row + reach); ++r) {
                for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame.columns - 1, column + reach);
                     ++c) {
                    const std::size_t other = frame.at(r, c);
                    const double distance = std::hypot(r - row, c - column);
                    if (std::isnan(points.top[other]) || distance >= nearest || distance > reach) continue;
                    nearest = distance;
                    seen.top[cell] = points.top[other];
                    seen.bottom[cell] = points.bottom[other];
                }
            }
        }
    }
}

Seen seen_by(const LayerField& field, std::span<const RemovedLayer> removed, std::uint32_t mask,
             const std::vector<bool>& stray) {
    Seen seen{std::vector<float>(field.frame.cells(), kUnknown), std::vector<float>(field.frame.cells(), kUnknown)};
    const auto add = [&](std::size_t cell, const HeightLayer& layer) {
        if ((layer.scans & mask) == 0) return;
        const float high = layer.wide ? layer.high : layer.height;
        const float low = layer.wide ? layer.low : layer.height;
        if (!(seen.top[cell] >= high)) seen.top[cell] = high;
        if (!(seen.bottom[cell] <= low)) seen.bottom[cell] = low;
    };
    for (std::size_t cell = 0; cell < field.frame.cells(); ++cell) {
        if (stray[cell]) continue;
        for (const HeightLayer& layer : field.at(cell)) add(cell, layer);
    }
    for (const RemovedLayer& gone : removed) add(gone.cell, gone.layer);
    widen(field.frame, seen);
    return seen;
}

class Shadows {
  public:
    Shadows(const GridFrame& frame, const Seen& seen, const std::vector<bool>& near_sides,
            const Eigen::Vector3d& station, const SightRules& rules)
        : frame_(frame), seen_(seen), near_sides_(near_sides), station_(station), rules_(rules) {}

    /// Whether what the scan saw could be seen from the station: few of its cells lie in the shadow of others.
    [[nodiscard]] bool are_of_one_station() const {
        constexpr std::size_t kSamples = 5000;
        const std::size_t step = std::max<std::size_t>(1, frame_.cells() / kSamples / 4);
        std::size_t judged = 0;
        std::size_t hidden = 0;
        for (std::size_t cell = 0; cell < frame_.cells(); cell += step) {
            if (std::isnan(seen_.top[cell])) continue;
            const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(frame_.columns));
            const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(frame_.columns));
            const auto line = highest_line(row, column);
            if (!line) continue;
            ++judged;
            if (static_cast<double>(seen_.top[cell]) < *line - rules_.least_drop) ++hidden;
        }
        return static_cast<double>(hidden) <= rules_.hidden * static_cast<double>(judged);
    }

    /// Height of the line of sight over a cell, where it lies in a shadow.
    [[nodiscard]] std::optional<double> over(std::int32_t row, std::int32_t column) const {
        const Way way = way_to(row, column);
        if (!(way.distance >= 2.0 * frame_.cell)) return std::nullopt;
        const auto behind = first_seen(row, column, {rules_.farthest, way.east, way.north}, Sides::Stop);
        if (!behind) return std::nullopt;
        const double most = std::min(rules_.farthest, way.distance - frame_.cell);
        const auto before = first_seen(row, column, {most, -way.east, -way.north}, Sides::Pass);
        if (!before) return std::nullopt;
        const auto edge = static_cast<double>(seen_.top[before->cell]);
        if (static_cast<double>(seen_.bottom[behind->cell]) > edge - rules_.least_drop) return std::nullopt;
        // On average the edge lies half the way between points beyond the last of them.
        const double from_edge = before->distance + seen_.widened - 0.5 * (seen_.spacing - frame_.cell);
        if (from_edge <= 0.0) return std::nullopt; // may belong to the edge
        const double tangent = (edge - station_.z()) / (way.distance - from_edge);
        return station_.z() + tangent * way.distance;
    }

  private:
    struct Way {
        double distance = 0.0; // of a cell from the station, in plan [m]
        double east = 0.0;     // unit vector away from the station
        double north = 0.0;
    };

    [[nodiscard]] Way way_to(std::int32_t row, std::int32_t column) const {
        const double east = frame_.x(column) - station_.x();
        const double north = frame_.y(row) - station_.y();
        const double distance = std::hypot(east, north);
        return {distance, east / distance, north / distance};
    }

    /// The highest line of sight over a cell of those past all that was seen nearer.
    [[nodiscard]] std::optional<double> highest_line(std::int32_t row, std::int32_t column) const {
        const Way way = way_to(row, column);
        std::optional<double> tangent;
        for (double back = 2.0 * frame_.cell; back < std::min(rules_.farthest, way.distance - frame_.cell);
             back += frame_.cell) {
            const auto cell = cell_at(row, column, -back * way.east, -back * way.north);
            if (!cell) break;
            if (std::isnan(seen_.bottom[*cell])) continue;
            const double rise = (static_cast<double>(seen_.bottom[*cell]) - station_.z()) / (way.distance - back);
            if (!tangent || rise > *tangent) tangent = rise;
        }
        if (!tangent) return std::nullopt;
        return station_.z() + *tangent * way.distance;
    }

    [[nodiscard]] std::optional<std::size_t> cell_at(std::int32_t row, std::int32_t column, double east,
                                                     double north) const {
        const auto c = column + static_cast<std::int32_t>(std::lround(east / frame_.cell));
        const auto r = row + static_cast<std::int32_t>(std::lround(north / frame_.cell));
        if (r < 0 || c < 0 || r >= frame_.rows || c >= frame_.columns) return std::nullopt;
        return frame_.at(r, c);
    }

    struct Met {
        std::size_t cell = 0;
        double distance = 0.0; // in plan [m]
    };

    enum class Sides { Pass, Stop };

    [[nodiscard]] std::optional<Met> first_seen(std::int32_t row, std::int32_t column, const Way& way,
                                                Sides sides) const {
        for (double gone = frame_.cell; gone < way.distance; gone += frame_.cell) {
            const auto cell = cell_at(row, column, gone * way.east, gone * way.north);
            if (!cell) return std::nullopt;
            if (!std::isnan(seen_.top[*cell])) return Met{*cell, gone};
            if (sides == Sides::Stop && near_sides_[*cell]) return std::nullopt;
        }
        return std::nullopt;
    }

    const GridFrame& frame_;
    const Seen& seen_;
    const std::vector<bool>& near_sides_;
    const Eigen::Vector3d& station_;
    const SightRules& rules_;
};

/// Whether hardly any cell around holds points, and ground that can be relied on lies well below.
bool hangs_alone(const SurfaceGrid& grid, const std::vector<bool>& stray, std::int32_t row, std::int32_t column,
                 int alone, const SightRules& rules) {
    const GridFrame& frame = grid.frame;
    const float height = grid.height[frame.at(row, column)];
    const auto reach = static_cast<std::int32_t>(std::lround(rules.ground_near / frame.cell));
    constexpr std::int32_t kNear = 3;
    int held = 0;
    bool over_ground = false;
    for (std::int32_t r = std::max(0, row - reach); r <= std::min(frame.rows - 1, row + reach); ++r) {
        for (std::int32_t c = std::max(0, column - reach); c <= std::min(frame.columns - 1, column + reach); ++c) {
            const std::size_t other = frame.at(r, c);
            if (grid.state[other] == CellState::Unseen) continue;
            if (std::abs(r - row) <= kNear && std::abs(c - column) <= kNear && ++held > alone) return false;
            if (stray[other] || grid.state[other] == CellState::Face) continue;
            const double most = rules.hangs + rules.slope * frame.cell * std::hypot(r - row, c - column);
            over_ground = over_ground || static_cast<double>(height - grid.height[other]) > most;
        }
    }
    return over_ground;
}

} // namespace

std::vector<float> lines_of_sight(const LayerField& field, std::span<const RemovedLayer> removed,
                                  const SurfaceGrid& grid, std::span<const SurfaceScan> scans, const SightRules& rules,
                                  int threads, Progress& progress) {
    const GridFrame& frame = grid.frame;
    std::vector<float> lowest(frame.cells(), kUnknown);
    const std::vector<bool> stray = stray_cells(grid, rules);
    const std::vector<bool> beside = near_sides(grid, stray, rules.beside_side);
    for (std::size_t scan = 0; scan < std::min<std::size_t>(scans.size(), kLastMaskBit); ++scan) {
        const Seen seen = seen_by(field, removed, mask_of(static_cast<std::uint16_t>(scan)), stray);
        const Shadows shadows(frame, seen, beside, scans[scan].station, rules);
        if (!shadows.are_of_one_station()) continue;
        for_each_part(static_cast<std::size_t>(frame.rows), threads, progress, [&](std::size_t part) {
            const auto row = static_cast<std::int32_t>(part);
            for (std::int32_t column = 0; column < frame.columns; ++column) {
                const std::size_t cell = frame.at(row, column);
                if (grid.state[cell] != CellState::Unseen && !stray[cell]) continue;
                if (!std::isnan(seen.top[cell])) continue;
                const auto line = shadows.over(row, column);
                if (line && !(static_cast<double>(lowest[cell]) <= *line)) lowest[cell] = static_cast<float>(*line);
            }
        });
    }
    return lowest;
}

std::size_t drop_hanging(SurfaceGrid& grid, const SightRules& rules) {
    const GridFrame& frame = grid.frame;
    const std::vector<bool> stray = stray_cells(grid, rules);
    const double usual = usual_share(frame, grid.height);
    const int alone = std::min(rules.alone, static_cast<int>(rules.alone_share * 49.0 * usual));
    std::vector<std::size_t> hanging;
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t cell = frame.at(row, column);
            if (!stray[cell]) continue;
            const bool on_line = static_cast<double>(grid.ceiling[cell] - grid.height[cell]) < rules.grazing;
            if (on_line || hangs_alone(grid, stray, row, column, alone, rules)) hanging.push_back(cell);
        }
    }
    for (const std::size_t cell : hanging) {
        grid.state[cell] = CellState::Unseen;
        grid.height[cell] = kUnknown;
        grid.spread[cell] = 0.0F;
        grid.slope[cell] = kUnknown;
        grid.count[cell] = 0;
        if (!grid.side_east.empty()) grid.side_east[cell] = kUnknown;
        if (!grid.side_north.empty()) grid.side_north[cell] = kUnknown;
    }
    return hanging.size();
}

} // namespace planum::scans
