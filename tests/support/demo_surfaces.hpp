// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/simulator.hpp"
#include "app/demo/simulator_random.hpp"
#include "core/model/place.hpp"
#include "scans/surface/surface_grid.hpp"
#include "scans/surface/surface_step.hpp"

namespace planum::test {

/// What scans would have given: the true ground with noise, one error of height common to all of a day.
struct GroundNoise {
    double spread = 0.003;      ///< of the heights in a cell [m]
    double pose_sigma = 0.003;  ///< [m]
    double outline_shift = 0.0; ///< a further systematic displacement of all outlines of a day [m]
    double misplaced_by = 0.0; ///< one scan, which alone saw half of a surface, stands that far off; its σ says so [m]
};

/// The surface with the misplaced scan: one in the middle, so that it is compared both ways.
inline app::demo::SurfaceNo misplaced_surface(const app::demo::DemoDig& dig) { return dig.plan.surfaces / 2; }

inline model::UnitId demo_unit_id(app::demo::UnitNo unit) { return {Uuid{1, static_cast<std::uint64_t>(unit) + 1}}; }

inline model::SurfaceId demo_surface_id(app::demo::SurfaceNo surface) {
    return {Uuid{2, static_cast<std::uint64_t>(surface) + 1}};
}

/// Units of the dig in the order of formation, so that a unit's number is its UnitNo.
inline std::vector<scans::KnownUnit> known_units(const app::demo::DemoDig& dig) {
    std::vector<scans::KnownUnit> units;
    for (std::size_t u = 0; u < dig.formation.units().size(); ++u) {
        const app::demo::FormedUnit& formed = dig.formation.units()[u];
        units.push_back({demo_unit_id(static_cast<int>(u)), formed.kind, formed.form});
    }
    return units;
}

inline scans::SurfaceGrid surface_of(const app::demo::DemoDig& dig, app::demo::SurfaceNo surface,
                                     const GroundNoise& noise) {
    using app::demo::SurfaceCell;
    const app::demo::ColumnGrid& columns = *dig.grid;
    const app::demo::SurfaceMap& map = dig.maps[static_cast<std::size_t>(surface)];
    scans::SurfaceGrid grid;
    grid.frame.cell = columns.cell();
    grid.frame.west = std::llround(columns.x0() / columns.cell());
    grid.frame.south = std::llround(columns.y0() / columns.cell());
    grid.frame.columns = static_cast<std::int32_t>(columns.columns());
    grid.frame.rows = static_cast<std::int32_t>(columns.rows());
    const std::size_t n = grid.frame.cells();
    grid.height.assign(n, 0.0F);
    grid.spread.assign(n, static_cast<float>(noise.spread));
    grid.pose_sigma.assign(n, static_cast<float>(noise.pose_sigma));
    grid.slope.assign(n, 0.0F);
    grid.count.assign(n, 4);
    grid.state.assign(n, scans::CellState::Surface);
    app::demo::Draw draw(dig.options.seed, 90000 + static_cast<std::uint64_t>(surface));
    const double lift = noise.pose_sigma * draw.normal();
    for (std::size_t i = 0; i < n; ++i) {
        const double error = lift + 0.5 * noise.spread * draw.normal();
        grid.height[i] = map[i].z + static_cast<float>(error);
        if (map[i].shown == SurfaceCell::Shown::Nothing) grid.state[i] = scans::CellState::Unseen;
    }
    if (noise.misplaced_by > 0.0 && surface == misplaced_surface(dig)) {
        // Level and plumb, as a scanner with its compensator stands: a shift to one side and one of height.
        const double direction = draw.between(0.0, 6.283185307179586);
        const double climb = draw.between(-1.0, 1.0);
        const double aside = noise.misplaced_by * std::sqrt(1.0 - climb * climb) / grid.frame.cell;
        const auto across = static_cast<std::int32_t>(std::lround(aside * std::cos(direction)));
        const auto along = static_cast<std::int32_t>(std::lround(aside * std::sin(direction)));
        const scans::SurfaceGrid true_place = grid;
        for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
            for (std::int32_t column = grid.frame.columns / 2; column < grid.frame.columns; ++column) {
                const std::size_t i = grid.frame.at(row, column);
                const std::size_t from = grid.frame.at(std::clamp(row - along, 0, grid.frame.rows - 1),
                                                       std::clamp(column - across, 0, grid.frame.columns - 1));
                grid.height[i] = true_place.height[from] + static_cast<float>(climb * noise.misplaced_by);
                grid.state[i] = true_place.state[from];
                grid.pose_sigma[i] = static_cast<float>(noise.misplaced_by);
            }
        }
    }
    const auto steepest = [&](std::int32_t row, std::int32_t column) {
        double most = 0.0;
        const double here = static_cast<double>(map[grid.frame.at(row, column)].z);
        for (const auto& [r, c] :
             {std::pair{row, column - 1}, {row, column + 1}, {row - 1, column}, {row + 1, column}}) {
            if (r < 0 || c < 0 || r >= grid.frame.rows || c >= grid.frame.columns) continue;
            most = std::max(most, std::abs(static_cast<double>(map[grid.frame.at(r, c)].z) - here));
        }
        return most / grid.frame.cell;
    };
    for (std::int32_t row = 0; row < grid.frame.rows; ++row) {
        for (std::int32_t column = 0; column < grid.frame.columns; ++column) {
            const std::size_t i = grid.frame.at(row, column);
            grid.slope[i] = static_cast<float>(steepest(row, column));
            const bool steep = grid.slope[i] > 1.7320508F; // 60°
            if (steep && grid.state[i] == scans::CellState::Surface) grid.state[i] = scans::CellState::Face;
        }
    }
    return grid;
}

inline std::vector<model::Region> regions_of(const app::demo::DemoDig& dig, app::demo::SurfaceNo surface,
                                             const GroundNoise& noise = {}) {
    std::vector<model::Region> regions;
    app::demo::Draw draw(dig.options.seed, 91000 + static_cast<std::uint64_t>(surface));
    const double direction = draw.between(0.0, 6.283185307179586);
    const auto moved = [&](model::Ring& ring) {
        for (auto& p : ring) {
            p[0] += noise.outline_shift * std::cos(direction);
            p[1] += noise.outline_shift * std::sin(direction);
        }
    };
    for (const app::demo::DrawnRegion& drawn : dig.regions) {
        if (drawn.surface != surface) continue;
        model::Region region;
        region.id = {Uuid{3, static_cast<std::uint64_t>(&drawn - dig.regions.data()) + 1}};
        region.surface = demo_surface_id(surface);
        if (drawn.unit != app::demo::kAir) region.unit = demo_unit_id(drawn.unit);
        region.category = drawn.category;
        region.shows = drawn.shows;
        region.outline = {drawn.outline};
        moved(region.outline.front().outer);
        for (model::Ring& hole : region.outline.front().holes) moved(hole);
        regions.push_back(std::move(region));
    }
    return regions;
}

} // namespace planum::test
