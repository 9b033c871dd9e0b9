// SPDX-License-Identifier: MIT
#include "app/demo/dig_surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace planum::app::demo {

namespace {

using Shown = SurfaceCell::Shown;

constexpr float kTouch = 0.001F; ///< runs closer than this touch [m]

// Heights inside the run at which it may begin to go at another time, from the top down, ends included.
std::vector<double> breaks(const DigPlan& plan, const Run& run, double x, double y) {
    std::vector<double> heights = {static_cast<double>(run.high), static_cast<double>(run.low)};
    const auto add = [&](double z) {
        if (z < static_cast<double>(run.high) && z > static_cast<double>(run.low)) heights.push_back(z);
    };
    add(plan.side_height(x, y));
    for (const HeightTable& level : plan.levels) add(level.at(x, y));
    const OverdugPatch& patch = plan.overdug;
    if (patch.made) {
        const double u = (x - patch.centre.x) / patch.radii.x;
        const double v = (y - patch.centre.y) / patch.radii.y;
        if (u * u + v * v < 1.0) add(patch.centre.z - patch.radii.z * std::sqrt(1.0 - u * u - v * v));
    }
    std::sort(heights.rbegin(), heights.rend());
    return heights;
}

bool is_unit(Shown shown) {
    return shown == Shown::Top || shown == Shown::Level || shown == Shown::Cut || shown == Shown::Overdug;
}

SurfaceCell bare_cell(std::span<const DugRun> runs, const DigPlan& plan, double x, double y, SurfaceNo surface) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const DugRun& run = runs[i];
        if (run.gone <= surface) continue;
        SurfaceCell cell{run.high, run.unit, Shown::Top};
        if (run.gone == kSide) return {run.high, kAir, Shown::Nothing};
        if (run.due <= surface) return {run.high, kAir, Shown::Baulk};
        if (i == 0 || runs[i - 1].low - run.high > kTouch) return cell;
        const DugRun& above = runs[i - 1];
        if (above.unit == run.unit) {
            const Vec3 taken{x, y, static_cast<double>(run.high) + 0.002};
            cell.shown = plan.overdug.holds(taken) ? Shown::Overdug : Shown::Level;
        } else if (above.cut > run.unit) {
            cell = {run.high, above.cut, Shown::Cut};
        }
        return cell;
    }
    return {static_cast<float>(plan.site.trench.low.z), kAir, Shown::Nothing};
}

// The most frequent other unit around a feature; what a digger took it for.
std::int16_t surroundings(const SurfaceMap& map, const ColumnGrid& grid, const Bounds& bounds,
                          const std::vector<bool>& of_feature) {
    std::map<std::int16_t, std::size_t> count;
    for (std::size_t row = 0; row < grid.rows(); ++row) {
        for (std::size_t column = 0; column < grid.columns(); ++column) {
            const SurfaceCell& cell = map[row * grid.columns() + column];
            if (!bounds.holds(grid.x_of(column), grid.y_of(row)) || cell.shown != Shown::Level) continue;
            if (!of_feature[static_cast<std::size_t>(cell.unit)]) ++count[cell.unit];
        }
    }
    const auto most =
        std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == count.end() ? std::int16_t{kAir} : most->first;
}

void forget(SurfaceMap& map, const std::vector<bool>& of_feature, std::int16_t taken_for) {
    for (SurfaceCell& cell : map) {
        if (cell.unit == kAir || !of_feature[static_cast<std::size_t>(cell.unit)]) continue;
        cell.unit = taken_for;
        cell.shown = taken_for == kAir ? Shown::Nothing : Shown::Level;
    }
}

} // namespace

DugGrid::DugGrid(const ColumnGrid& grid, const Formation& formation, const DigPlan& plan) {
    first_.reserve(grid.size() + 1);
    first_.push_back(0);
    for (std::size_t index = 0; index < grid.size(); ++index) {
        const double x = grid.x_of(index % grid.columns());
        const double y = grid.y_of(index / grid.columns());
        for (const Run& run : grid.at(index)) {
            const std::vector<double> heights = breaks(plan, run, x, y);
            for (std::size_t i = 1; i < heights.size(); ++i) {
                const Vec3 middle{x, y, 0.5 * (heights[i - 1] + heights[i])};
                const SurfaceNo gone = plan.gone_on(formation, run.unit, middle);
                const SurfaceNo due = gone == kSide ? kSide : plan.gone_without_baulk(formation, run.unit, middle);
                const auto high = static_cast<float>(heights[i - 1]);
                const auto low = static_cast<float>(heights[i]);
                const bool continues = runs_.size() > first_.back() && runs_.back().unit == run.unit &&
                                       runs_.back().cut == run.cut && runs_.back().gone == gone &&
                                       runs_.back().due == due && runs_.back().low - high < kTouch;
                if (continues) {
                    runs_.back().low = low;
                } else {
                    runs_.push_back({low, high, run.unit, run.cut, static_cast<std::uint8_t>(gone),
                                     static_cast<std::uint8_t>(due)});
                }
            }
        }
        first_.push_back(runs_.size());
    }
}

SurfaceMap map_surface(const ColumnGrid& grid, const DugGrid& dug, const DigPlan& plan, SurfaceNo surface) {
    SurfaceMap map(grid.size());
    for (std::size_t index = 0; index < grid.size(); ++index) {
        const double x = grid.x_of(index % grid.columns());
        const double y = grid.y_of(index / grid.columns());
        SurfaceCell& cell = map[index];
        cell = bare_cell(dug.at(index), plan, x, y, surface);
        if (surface != plan.slump.surface || cell.shown == Shown::Nothing) continue;
        if (!plan.slump.holds({x, y, static_cast<double>(cell.z) + 0.01})) continue;
        const double u = (x - plan.slump.x) / plan.slump.half_x;
        const double v = (y - plan.slump.y) / plan.slump.half_y;
        cell = {static_cast<float>(plan.slump.floor + plan.slump.height * (1.0 - u * u - v * v)), kAir, Shown::Slump};
    }
    return map;
}

void forget_late_features(std::vector<SurfaceMap>& maps, const ColumnGrid& grid, const Formation& formation,
                          const DigPlan& plan) {
    for (const UnitNo cut : plan.late) {
        std::vector<bool> of_feature(formation.units().size(), false);
        Bounds bounds;
        for (std::size_t u = 0; u < formation.units().size(); ++u) {
            of_feature[u] = static_cast<UnitNo>(u) == cut || (formation.units()[u].cut == cut);
        }
        for (const FormationEvent& event : formation.events()) {
            if (event.unit == cut) bounds = event.bounds;
        }
        for (SurfaceMap& map : maps) {
            const bool shows = std::any_of(map.begin(), map.end(), [&](const SurfaceCell& cell) {
                return cell.unit != kAir && of_feature[static_cast<std::size_t>(cell.unit)];
            });
            if (!shows) continue;
            forget(map, of_feature, surroundings(map, grid, bounds, of_feature));
            break;
        }
    }
}

void settle_slump(DigPlan& plan, const ColumnGrid& grid, const DugGrid& dug) {
    if (!plan.slump.fell) return;
    // The lowest ground under it, so that it lies on the ground everywhere.
    double floor = plan.site.trench.high.z;
    for (std::size_t index = 0; index < grid.size(); ++index) {
        const double x = grid.x_of(index % grid.columns());
        const double y = grid.y_of(index / grid.columns());
        if (std::hypot((x - plan.slump.x) / plan.slump.half_x, (y - plan.slump.y) / plan.slump.half_y) > 0.8) continue;
        const SurfaceCell cell = bare_cell(dug.at(index), plan, x, y, plan.slump.surface);
        if (cell.shown == Shown::Top || cell.shown == Shown::Level)
            floor = std::min(floor, static_cast<double>(cell.z));
    }
    plan.slump.floor = floor;
}

DugVolumes dug_volumes(const ColumnGrid& grid, const DugGrid& dug, const DigPlan& plan) {
    DugVolumes volumes;
    const double area = grid.cell() * grid.cell();
    for (std::size_t index = 0; index < grid.size(); ++index) {
        for (const DugRun& run : dug.at(index)) {
            if (run.gone >= plan.surfaces) continue;
            volumes[{run.unit, run.gone}] += area * static_cast<double>(run.high - run.low);
        }
    }
    return volumes;
}

SeenContacts seen_contacts(const std::vector<SurfaceMap>& maps, const ColumnGrid& grid) {
    constexpr float kLower = 0.02F; // as much lower as the project's own tolerance [m]
    SeenContacts seen;
    const double area = grid.cell() * grid.cell();
    for (std::size_t index = 0; index < grid.size(); ++index) {
        const SurfaceCell* last = nullptr;
        SurfaceNo last_surface = 0;
        for (std::size_t s = 0; s < maps.size(); ++s) {
            const SurfaceCell& cell = maps[s][index];
            if (!is_unit(cell.shown)) {
                last = nullptr; // every surface between must be labelled and seen
                continue;
            }
            if (last != nullptr && last->unit != cell.unit && cell.z < last->z - kLower) {
                SeenContact& contact = seen[{last->unit, cell.unit}];
                if (contact.area == 0.0)
                    contact = {0.0, last_surface, static_cast<SurfaceNo>(s), contact.shared_outline};
                contact.area += area;
            }
            last = &cell;
            last_surface = static_cast<SurfaceNo>(s);
        }
    }
    for (const SurfaceMap& map : maps) {
        std::map<std::pair<UnitNo, UnitNo>, double> outline;
        for (std::size_t row = 0; row + 1 < grid.rows(); ++row) {
            for (std::size_t column = 0; column + 1 < grid.columns(); ++column) {
                const std::size_t at = row * grid.columns() + column;
                for (const std::size_t other : {at + 1, at + grid.columns()}) {
                    const SurfaceCell& a = map[at];
                    const SurfaceCell& b = map[other];
                    if (a.unit == b.unit || !is_unit(a.shown) || !is_unit(b.shown)) continue;
                    outline[{std::max(a.unit, b.unit), std::min(a.unit, b.unit)}] += grid.cell();
                }
            }
        }
        for (const auto& [pair, length] : outline) {
            SeenContact& contact = seen[pair];
            contact.shared_outline = std::max(contact.shared_outline, length);
        }
    }
    return seen;
}

} // namespace planum::app::demo
