// SPDX-License-Identifier: MIT
#include "app/surfaces/dug_earth.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/known_ground.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "core/model/surface_order.hpp"
#include "scans/surface/label_grid.hpp"
#include "scans/surface/surface_difference.hpp"

namespace planum::app {

namespace {

constexpr double kAroundOutlines = 0.1; // three σ of an outline [m]

// Every cell without a region within so many steps of one takes that of the nearest.
void grow(std::vector<std::int32_t>& region, const scans::GridFrame& frame, int steps) {
    std::vector<std::size_t> rim;
    for (std::size_t cell = 0; cell < region.size(); ++cell) {
        if (region[cell] != scans::kNoRegion) rim.push_back(cell);
    }
    for (int step = 0; step < steps; ++step) {
        std::vector<std::size_t> next;
        const auto columns = static_cast<std::size_t>(frame.columns);
        for (const std::size_t cell : rim) {
            const auto take = [&](std::size_t other) {
                if (region[other] != scans::kNoRegion) return;
                region[other] = region[cell];
                next.push_back(other);
            };
            if (cell % columns > 0) take(cell - 1);
            if (cell % columns + 1 < columns) take(cell + 1);
            if (cell >= columns) take(cell - columns);
            if (cell + columns < region.size()) take(cell + columns);
        }
        rim = std::move(next);
    }
}

Earth earth_of(const scans::DugVolume& volume) { return {volume.net, volume.bound(), volume.area}; }

void add(Earth& sum, const Earth& part) {
    sum.net += part.net;
    sum.bound = std::hypot(sum.bound, part.bound);
    sum.area += part.area;
}

struct NameLess {
    bool operator()(const EarthOfUnit& a, const EarthOfUnit& b) const {
        if (a.is_unit != b.is_unit) return a.is_unit; // units first
        return text::natural_order(a.unit, b.unit) < 0;
    }
};

class AreaEarth {
  public:
    AreaEarth(Project& project, model::AreaId area, double cell, Progress& progress)
        : project_(project), record_(project.record()), area_(area), cell_(cell), progress_(progress) {}

    void count(const std::vector<const model::Surface*>& surfaces, EarthReport& report) {
        std::optional<RecordedSurface> last;
        const model::Surface* last_surface = nullptr;
        for (const model::Surface* surface : surfaces) {
            if (!is_seen(record_, *surface)) {
                report.unseen.push_back({surface_name(record_, *surface), why_unseen(record_, *surface)});
                continue;
            }
            RecordedSurface here = recorded_surface(project_, *surface, cell_, progress_);
            if (last) report.steps.push_back(step(*last_surface, *last, *surface, here));
            last = std::move(here);
            last_surface = surface;
        }
    }

  private:
    EarthStep step(const model::Surface& surface, const RecordedSurface& before, const model::Surface& next,
                   const RecordedSurface& after) {
        const scans::GridFrame frame = scans::common_frame(before.grid.frame, after.grid.frame);
        if (dug_.empty()) dug_ = dug_cells(frame);
        std::vector<EarthOfUnit> units;
        const std::vector<std::int32_t> label = labels(frame, surface, units);
        scans::VolumeOptions options;
        options.outline_sigma = outline_sigma(surface);
        options.known_before = known_ground(record_, surface);
        options.known_after = known_ground(record_, next);
        const std::vector<scans::DugVolume> of_units =
            scans::dug_volumes(before.grid, after.grid, label, units.size(), options);
        EarthStep result;
        result.before = before.name;
        result.after = after.name;
        for (std::size_t i = 0; i < units.size(); ++i) {
            units[i].earth = earth_of(of_units[i]);
            if (units[i].earth.area > 0.0) result.units.push_back(units[i]);
        }
        scans::VolumeOptions in_all = options;
        in_all.outline_sigma = 0.0; // nothing is divided
        const scans::DugVolume total = scans::dug_volumes(before.grid, after.grid, dug_, 1, in_all)[0];
        result.total = earth_of(total);
        result.gone = total.gone;
        result.added = total.added;
        result.overhung = total.overhung;
        result.filled = total.filled_area;
        result.unseen = total.unseen_area;
        return result;
    }

    [[nodiscard]] std::vector<model::Region> regions_of(const model::Surface* surface) const {
        std::vector<model::Region> regions;
        for (const model::Region& region : record_.regions) {
            if (!region.section.is_nil()) continue;
            const auto on = std::find_if(record_.surfaces.begin(), record_.surfaces.end(),
                                         [&](const model::Surface& s) { return s.id == region.surface; });
            if (on == record_.surfaces.end() || on->area != area_) continue;
            if (surface == nullptr || on->id == surface->id) regions.push_back(region);
        }
        return regions;
    }

    [[nodiscard]] std::vector<std::int32_t> grown(const scans::GridFrame& frame,
                                                  const std::vector<model::Region>& regions) const {
        std::vector<std::int32_t> cells = scans::label_cells(frame, regions).region;
        grow(cells, frame, static_cast<int>(std::lround(kAroundOutlines / cell_)));
        return cells;
    }

    // 0 inside the outlines of all surfaces, -1 outside.
    [[nodiscard]] std::vector<std::int32_t> dug_cells(const scans::GridFrame& frame) const {
        const std::vector<model::Region> all = regions_of(nullptr);
        if (all.empty()) return std::vector<std::int32_t>(frame.cells(), 0);
        std::vector<std::int32_t> cells = grown(frame, all);
        for (std::int32_t& cell : cells) cell = std::min(cell, 0);
        return cells;
    }

    // The unit of each cell on a surface, as a place in `units`.
    [[nodiscard]] std::vector<std::int32_t> labels(const scans::GridFrame& frame, const model::Surface& surface,
                                                   std::vector<EarthOfUnit>& units) const {
        const std::vector<model::Region> regions = regions_of(&surface);
        std::vector<EarthOfUnit> of_region;
        for (const model::Region& region : regions)
            of_region.push_back({region_label(record_, project_.index(), region), !region.unit.is_nil(), {}});
        units = of_region;
        units.emplace_back();
        std::sort(units.begin(), units.end(), NameLess());
        units.erase(
            std::unique(units.begin(), units.end(),
                        [](const auto& a, const auto& b) { return a.unit == b.unit && a.is_unit == b.is_unit; }),
            units.end());
        const auto place = [&](const EarthOfUnit& unit) {
            return static_cast<std::int32_t>(std::lower_bound(units.begin(), units.end(), unit, NameLess()) -
                                             units.begin());
        };
        std::vector<std::int32_t> of_cell = grown(frame, regions);
        for (std::size_t cell = 0; cell < of_cell.size(); ++cell) {
            const std::int32_t region = of_cell[cell];
            if (region != scans::kNoRegion) {
                of_cell[cell] = place(of_region[static_cast<std::size_t>(region)]);
            } else if (dug_[cell] == 0) {
                of_cell[cell] = place({});
            }
        }
        return of_cell;
    }

    // Root mean square over the regions [m].
    [[nodiscard]] double outline_sigma(const model::Surface& surface) const {
        double sum = 0.0;
        double number = 0.0;
        for (const model::Region& region : record_.regions) {
            if (region.surface != surface.id || !region.section.is_nil()) continue;
            sum += region.sigma * region.sigma;
            number += 1.0;
        }
        return number > 0.0 ? std::sqrt(sum / number) : 0.0;
    }

    Project& project_;
    const model::Record& record_;
    const model::AreaId area_;
    const double cell_;
    Progress& progress_;
    std::vector<std::int32_t> dug_;
};

void sum_up(EarthReport& report) {
    std::map<EarthOfUnit, Earth, NameLess> units;
    for (const EarthStep& step : report.steps) {
        add(report.total, step.total);
        for (const EarthOfUnit& unit : step.units) add(units[{unit.unit, unit.is_unit, {}}], unit.earth);
    }
    for (const auto& [unit, earth] : units) report.units.push_back({unit.unit, unit.is_unit, earth});
}

std::vector<model::AreaId> areas_of(const model::Record& record, const std::string& wanted) {
    std::vector<model::AreaId> areas;
    if (wanted.empty()) areas.emplace_back(); // surfaces of no area
    for (const model::Area& area : record.areas) {
        if (wanted.empty() || area.name == wanted) areas.push_back(area.id);
    }
    if (areas.empty()) throw Error(ErrorCode::NotFound, fmt::format("no area {}; planum area list names all", wanted));
    return areas;
}

// Surfaces whose place in time is sure; the others are named in the report.
std::vector<const model::Surface*> in_order(const model::Record& record, model::AreaId area, EarthReport& report) {
    const std::vector<model::OrderClash> clashes = model::clashes_of_order(record);
    std::vector<const model::Surface*> surfaces = surfaces_in_time(record, area);
    std::erase_if(surfaces, [&](const model::Surface* surface) {
        if (!model::is_in_clash(clashes, surface->id)) return false;
        report.out_of_order.push_back(surface_name(record, *surface));
        return true;
    });
    return surfaces;
}

} // namespace

EarthReport dug_earth(Project& project, const EarthQuery& query, Progress& progress) {
    const model::Record& record = project.record();
    EarthReport report;
    if (!query.before.empty() || !query.after.empty()) {
        const model::Surface& before = known_surface(record, query.before);
        const model::Surface& after = known_surface(record, query.after);
        if (before.area != after.area) {
            throw Error(ErrorCode::Usage,
                        fmt::format("surfaces {} and {} belong to two areas; a volume needs two of one", query.before,
                                    query.after));
        }
        AreaEarth(project, before.area, query.cell, progress).count({&before, &after}, report);
        if (!report.unseen.empty()) {
            throw Error(ErrorCode::Conflict,
                        fmt::format("surface {}: {}", report.unseen.front().name, report.unseen.front().why));
        }
    } else {
        for (const model::AreaId area : areas_of(record, query.area))
            AreaEarth(project, area, query.cell, progress).count(in_order(record, area, report), report);
    }
    sum_up(report);
    return report;
}

} // namespace planum::app
