// SPDX-License-Identifier: MIT
#include "scans/surface/surface_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.hpp"

namespace planum::scans {

namespace {

constexpr double kSeenOnce = 1e9;      // no change is known that an error could be a share of [m]
constexpr double kTwoSided = 1.959964; // 95 % of a normal distribution

bool is_ground(CellState state) { return state == CellState::Surface || state == CellState::Disputed; }

double noise_variance(const SurfaceGrid& grid, std::size_t cell) {
    const auto spread = static_cast<double>(grid.spread[cell]);
    return spread * spread / std::max(1.0, static_cast<double>(grid.count[cell]));
}

/// Sums of one label while its cells are counted.
struct Sums {
    double free = 0.0;   // variance of what differs from cell to cell [m²]
    double filled = 0.0; // of what is alike over a while
    double outline = 0.0;
    double overhung_before = 0.0; // under overhangs of the earlier surface [m]
    double overhung_after = 0.0;
    double pose_before = 0.0; // sum of σ [m]
    double pose_after = 0.0;
};

class Counter {
  public:
    Counter(const SurfaceGrid& before, const SurfaceGrid& after, std::span<const std::int32_t> label_of,
            const VolumeOptions& options)
        : before_(before), after_(after), label_of_(label_of), options_(options),
          frame_(common_frame(before.frame, after.frame)),
          filled_before_(fill_gaps(before, options.gaps, options.known_before)),
          filled_after_(fill_gaps(after, options.gaps, options.known_after)) {
        if (!label_of.empty() && label_of.size() != frame_.cells())
            throw Error(ErrorCode::Usage, "labels that are not those of the cells two surfaces share");
        if (options.undug) undug_ = undug_ground({before_, filled_before_}, {after_, filled_after_}, *options.undug);
    }

    std::vector<DugVolume> count(std::size_t labels) {
        volumes_.resize(labels);
        sums_.resize(labels);
        for (std::int32_t row = 0; row < frame_.rows; ++row) {
            for (std::int32_t column = 0; column < frame_.columns; ++column) {
                const std::int32_t label = label_at(row, column);
                if (label >= 0 && static_cast<std::size_t>(label) < labels)
                    add(row, column, static_cast<std::size_t>(label));
            }
        }
        for (std::size_t label = 0; label < labels; ++label) finish(volumes_[label], sums_[label]);
        return std::move(volumes_);
    }

  private:
    [[nodiscard]] std::int32_t label_at(std::int32_t row, std::int32_t column) const {
        return label_of_.empty() ? 0 : label_of_[frame_.at(row, column)];
    }

    [[nodiscard]] double depth_at(std::int32_t row, std::int32_t column) const {
        return static_cast<double>(filled_before_.height[cell_in(before_.frame, frame_, row, column)]) -
               static_cast<double>(filled_after_.height[cell_in(after_.frame, frame_, row, column)]) +
               overhung_at(row, column);
    }

    [[nodiscard]] double overhung_at(std::int32_t row, std::int32_t column) const {
        return static_cast<double>(filled_after_.hollow[cell_in(after_.frame, frame_, row, column)]) -
               static_cast<double>(filled_before_.hollow[cell_in(before_.frame, frame_, row, column)]);
    }

    void add(std::int32_t row, std::int32_t column, std::size_t label) {
        const double area = frame_.cell * frame_.cell;
        const double depth = depth_at(row, column);
        DugVolume& volume = volumes_[label];
        if (std::isnan(depth)) {
            volume.unseen_area += area;
            return;
        }
        volume.area += area;
        if (!undug_.empty() && undug_[frame_.at(row, column)]) {
            volume.undug_area += area;
            return;
        }
        volume.net += depth * area;
        volume.overhung += overhung_at(row, column) * area;
        (depth > 0.0 ? volume.gone : volume.added) += std::abs(depth) * area;
        Sums& sums = sums_[label];
        bool filled = false;
        const bool hidden = !filled_before_.was_seen[cell_in(before_.frame, frame_, row, column)] &&
                            !filled_after_.was_seen[cell_in(after_.frame, frame_, row, column)];
        const auto add_surface = [&](const SurfaceGrid& grid, const FilledHeights& heights, double& pose,
                                     double& overhung) {
            const std::size_t cell = cell_in(grid.frame, frame_, row, column);
            pose += static_cast<double>(grid.pose_sigma[cell]);
            overhung += static_cast<double>(heights.hollow[cell]);
            if (heights.was_seen[cell]) {
                sums.free += noise_variance(grid, cell);
            } else {
                // Within a gap all is continued from the same ground, so errors are alike over its width.
                const double alike =
                    std::max({options_.alike, 2.0 * static_cast<double>(heights.distance[cell]), frame_.cell});
                const double sigma =
                    gap_sigma(heights, cell, hidden ? std::abs(depth) : kSeenOnce) * alike / frame_.cell;
                sums.filled += sigma * sigma;
                filled = true;
            }
        };
        add_surface(before_, filled_before_, sums.pose_before, sums.overhung_before);
        add_surface(after_, filled_after_, sums.pose_after, sums.overhung_after);
        if (filled) volume.filled_area += area;
        if (options_.outline_sigma > 0.0) add_outline(row, column, sums);
    }

    // What a shadow hides on both days is the same but for what was dug there.
    [[nodiscard]] double gap_sigma(const FilledHeights& heights, std::size_t cell, double depth) const {
        const auto gap = static_cast<double>(heights.sigma[cell]);
        const auto shadow = static_cast<double>(heights.shadow_sigma[cell]);
        const double most = options_.hidden_doubt * depth;
        return std::max(heights.laid[cell] ? std::min(gap, most) : gap, std::min(shadow, most));
    }

    // A line that lies elsewhere by δ moves earth of its depth from one label to the other.
    void add_outline(std::int32_t row, std::int32_t column, Sums& sums) const {
        const double depth = depth_at(row, column);
        const auto edge = [&](std::int32_t r, std::int32_t c) {
            if (r < 0 || c < 0 || r >= frame_.rows || c >= frame_.columns) return;
            if (label_at(r, c) == label_at(row, column)) return;
            const double other = depth_at(r, c);
            const double mean = std::isnan(other) ? depth : 0.5 * (depth + other);
            sums.outline += mean * mean;
        };
        edge(row - 1, column);
        edge(row + 1, column);
        edge(row, column - 1);
        edge(row, column + 1);
    }

    void finish(DugVolume& volume, const Sums& sums) const {
        const double area = frame_.cell * frame_.cell;
        const double along = std::max(1.0, options_.outline_alike / frame_.cell);
        const double edge = options_.outline_sigma * frame_.cell;
        const double overhung = options_.overhang_doubt * area * std::hypot(sums.overhung_before, sums.overhung_after);
        volume.sigma = std::sqrt(
            overhung * overhung +
            area * area *
                (sums.free + sums.filled + sums.pose_before * sums.pose_before + sums.pose_after * sums.pose_after) +
            edge * edge * along * sums.outline);
    }

    const SurfaceGrid& before_;
    const SurfaceGrid& after_;
    std::span<const std::int32_t> label_of_;
    const VolumeOptions& options_;
    GridFrame frame_;
    FilledHeights filled_before_;
    FilledHeights filled_after_;
    std::vector<bool> undug_; // empty: all counts
    std::vector<DugVolume> volumes_;
    std::vector<Sums> sums_;
};

} // namespace

GridFrame common_frame(const GridFrame& a, const GridFrame& b) {
    if (a.cell != b.cell) throw Error(ErrorCode::Usage, "surfaces with cells of different size cannot be compared");
    const std::int64_t west = std::max(a.west, b.west);
    const std::int64_t south = std::max(a.south, b.south);
    const std::int64_t east = std::min(a.west + a.columns, b.west + b.columns);
    const std::int64_t north = std::min(a.south + a.rows, b.south + b.rows);
    if (west >= east || south >= north) return {west, south, 0, 0, a.cell};
    return {west, south, static_cast<std::int32_t>(east - west), static_cast<std::int32_t>(north - south), a.cell};
}

SurfaceDifference surface_difference(const SurfaceGrid& before, const SurfaceGrid& after, double tolerance) {
    SurfaceDifference difference;
    difference.frame = common_frame(before.frame, after.frame);
    const GridFrame& frame = difference.frame;
    constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
    difference.change.assign(frame.cells(), kUnknown);
    difference.detectable.assign(frame.cells(), kUnknown);
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const std::size_t a = cell_in(before.frame, frame, row, column);
            const std::size_t b = cell_in(after.frame, frame, row, column);
            if (!is_ground(before.state[a]) || !is_ground(after.state[b])) continue;
            const std::size_t cell = frame.at(row, column);
            difference.change[cell] = after.height[b] - before.height[a];
            double variance = noise_variance(before, a) + noise_variance(after, b);
            for (const double pose :
                 {static_cast<double>(before.pose_sigma[a]), static_cast<double>(after.pose_sigma[b])})
                variance += pose * pose;
            difference.detectable[cell] =
                static_cast<float>(std::sqrt(tolerance * tolerance + kTwoSided * kTwoSided * variance));
        }
    }
    return difference;
}

std::vector<DugVolume> dug_volumes(const SurfaceGrid& before, const SurfaceGrid& after,
                                   std::span<const std::int32_t> label_of, std::size_t labels,
                                   const VolumeOptions& options) {
    return Counter(before, after, label_of, options).count(labels);
}

} // namespace planum::scans
