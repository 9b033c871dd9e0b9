// SPDX-License-Identifier: MIT
#include "scans/surface/surface_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/surface/disputes.hpp"
#include "scans/surface/layer_field.hpp"
#include "scans/surface/local_plane.hpp"
#include "scans/surface/parallel.hpp"

namespace planum::scans {

namespace {

constexpr double kMostCells = 400e6;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

LayerRules rules_of(std::span<const SurfaceScan> scans, const GridFrame& frame, const SurfaceOptions& options) {
    double noise = 0.0;
    for (const SurfaceScan& scan : scans) noise = std::max(noise, scan.noise);
    LayerRules rules;
    // A plane of that slope across the diagonal of a cell, of which 10 % to 90 % of the points show 0.8 at most.
    const double rise = options.steepest * frame.cell * std::sqrt(2.0);
    rules.extent = 0.8 * rise + 2.0 * 1.2816 * noise;
    rules.gap = 0.6 * rise + 6.0 * noise;
    return rules;
}

/// The layer that stands for the cell: of several the one with most points.
const HeightLayer& main_layer(std::span<const HeightLayer> layers) {
    return *std::max_element(layers.begin(), layers.end(),
                             [](const HeightLayer& a, const HeightLayer& b) { return a.count < b.count; });
}

std::vector<RemovedLayer> removed_layers(const LayerField& field, const std::vector<bool>& marked) {
    std::vector<RemovedLayer> removed;
    for (std::size_t cell = 0; cell < field.frame.cells(); ++cell) {
        const std::span<const HeightLayer> layers = field.at(cell);
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (marked[field.first(cell) + k]) removed.push_back({cell, layers[k]});
        }
    }
    return removed;
}

class Composer {
  public:
    Composer(const LayerField& field, std::span<const SurfaceScan> scans, const SurfaceOptions& options,
             const LayerRules& rules, SurfaceGrid& grid)
        : field_(field), field_rules_(rules), scans_(scans), options_(options), grid_(grid) {}

    void compose(Progress& progress) {
        const std::size_t cells = field_.frame.cells();
        grid_.frame = field_.frame;
        grid_.height.assign(cells, kUnknown);
        grid_.spread.assign(cells, 0.0F);
        grid_.pose_sigma.assign(cells, 0.0F);
        grid_.slope.assign(cells, kUnknown);
        grid_.count.assign(cells, 0);
        grid_.state.assign(cells, CellState::Unseen);
        const auto rows = static_cast<std::size_t>(field_.frame.rows);
        for_each_part(rows, options_.threads, progress, [&](std::size_t row) { take_heights(row); });
        for_each_part(rows, options_.threads, progress, [&](std::size_t row) { take_slopes(row); });
        grid_.side_east.assign(cells, kUnknown);
        grid_.side_north.assign(cells, kUnknown);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            if (grid_.state[cell] != CellState::Face) continue;
            grid_.side_east[cell] = field_.side[cell].east;
            grid_.side_north[cell] = field_.side[cell].north;
        }
    }

  private:
    void take_heights(std::size_t row) {
        for (std::int32_t column = 0; column < field_.frame.columns; ++column) {
            const std::size_t cell = field_.frame.at(static_cast<std::int32_t>(row), column);
            const std::span<const HeightLayer> layers = field_.at(cell);
            if (layers.empty()) continue;
            const HeightLayer& layer = main_layer(layers);
            grid_.height[cell] = layer.height;
            grid_.spread[cell] = layer.spread;
            grid_.count[cell] = layer.count;
            const bool one = layers.size() == 1 && !layer.wide;
            grid_.state[cell] = one ? CellState::Surface : CellState::Face;
            if (!one) { // of points spread evenly over a height 0.34 of it
                const float all = layers.back().high - layers.front().low;
                grid_.spread[cell] = std::max(layer.spread, 0.34F * all);
            }
        }
    }

    void take_slopes(std::size_t row) {
        for (std::int32_t column = 0; column < field_.frame.columns; ++column) {
            const std::size_t cell = field_.frame.at(static_cast<std::int32_t>(row), column);
            if (grid_.state[cell] == CellState::Unseen) continue;
            const auto plane = local_plane(field_.frame, grid_.height, static_cast<std::int32_t>(row), column);
            if (plane) {
                const double tangent = std::hypot(plane->dz_dx, plane->dz_dy);
                grid_.slope[cell] = static_cast<float>(tangent);
                const double offside = field_rules_.extent + 2.0 * plane->rms;
                if (tangent > options_.steepest || plane->off > offside) grid_.state[cell] = CellState::Face;
            }
            const Eigen::Vector3d x(field_.frame.x(column), field_.frame.y(static_cast<std::int32_t>(row)),
                                    static_cast<double>(grid_.height[cell]));
            const std::array<double, 2> gradient =
                plane ? std::array{plane->dz_dx, plane->dz_dy} : std::array{0.0, 0.0};
            grid_.pose_sigma[cell] = static_cast<float>(
                mean_lift(scans_, main_layer(field_.at(cell)).scans, x, gradient, options_.steepest));
        }
    }

    const LayerField& field_;
    const LayerRules& field_rules_;
    std::span<const SurfaceScan> scans_;
    const SurfaceOptions& options_;
    SurfaceGrid& grid_;
};

} // namespace

GridFrame frame_around(const PlanBox& box, double cell) {
    if (!(box.west < box.east && box.south < box.north && cell > 0.0))
        throw Error(ErrorCode::BadInput, "the rectangle of a surface is empty");
    const double west = std::floor(box.west / cell + 1e-6);
    const double south = std::floor(box.south / cell + 1e-6);
    const double columns = std::ceil(box.east / cell - 1e-6) - west;
    const double rows = std::ceil(box.north / cell - 1e-6) - south;
    if (!(columns * rows <= kMostCells && std::abs(west) < 1e15 && std::abs(south) < 1e15)) {
        throw Error(
            ErrorCode::BadInput,
            fmt::format("a surface of {:.0f} × {:.0f} m with cells of {:g} m has more than {:.0f} million cells; "
                        "use a smaller part or larger cells",
                        box.east - box.west, box.north - box.south, cell, kMostCells / 1e6));
    }
    return {static_cast<std::int64_t>(west), static_cast<std::int64_t>(south), static_cast<std::int32_t>(columns),
            static_cast<std::int32_t>(rows), cell};
}

BuiltSurface build_surface(std::span<const SurfaceScan> scans, const GridFrame& frame, const SurfaceOptions& options,
                           Progress& progress) {
    BuiltSurface built;
    progress.step("reading points into cells");
    const LayerRules rules = rules_of(scans, frame, options);
    LayerField field = collect_layers(scans, frame, rules, options.memory_bytes, options.threads, progress);
    built.points = field.points;
    progress.step("making the surface");
    std::vector<RemovedLayer> removed;
    std::vector<bool> passing;
    if (options.remove_passing) {
        built.passing = mark_passing(field, options.passing, passing);
        removed = removed_layers(field, passing);
        field.remove(passing);
    }
    Composer(field, scans, options, rules, built.grid).compose(progress);
    built.disputed = settle_disputes(field, scans, options, built.grid);
    if (!options.remove_passing) {
        built.grid.ceiling.assign(frame.cells(), kUnknown);
        return built;
    }
    std::vector<bool> hanging;
    built.hanging = mark_hanging(field, removed, scans, options.sight, options.threads, progress, hanging);
    if (built.hanging > 0) {
        const SurfaceGrid seen = std::move(built.grid);
        built.grid = {};
        field.remove(hanging);
        Composer(field, scans, options, rules, built.grid).compose(progress);
        (void)settle_disputes(field, scans, options, built.grid); // they were reported as seen
        built.as_seen = cells_as_seen(seen, built.grid);
    }
    built.grid.ceiling = lines_of_sight(field, removed, built.grid, scans, options.sight, options.threads, progress);
    return built;
}

} // namespace planum::scans
