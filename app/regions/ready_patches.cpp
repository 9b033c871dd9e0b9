// SPDX-License-Identifier: MIT
#include "app/regions/ready_patches.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scans/surface/changed_patches.hpp"

namespace planum::app {

using nlohmann::ordered_json;

namespace {

std::vector<model::Region> regions_on(const model::Record& record, model::SurfaceId surface) {
    std::vector<model::Region> regions;
    std::copy_if(record.regions.begin(), record.regions.end(), std::back_inserter(regions),
                 [&](const model::Region& region) { return region.surface == surface; });
    return regions;
}

/// Names units for the patches of one area from what is outlined and recorded.
class Proposer {
  public:
    Proposer(const model::Record& record, const model::RecordIndex& index) : record_(record), index_(index) {
        for (const model::PhysicalRelation& relation : record.relations) {
            const bool touches = relation.kind == model::RelationKind::Covers ||
                                 relation.kind == model::RelationKind::Cuts ||
                                 relation.kind == model::RelationKind::Fills;
            if (touches) below_[index.find(relation.subject)].push_back(index.find(relation.object));
        }
    }

    /// `was` and `beside` are labels of `earlier` and `here`.
    void propose(ReadyPatch& patch, const scans::ChangedPatch& found, const std::vector<model::Region>& earlier,
                 const std::vector<model::Region>& here) const {
        if (patch.change > 0.0) {
            patch.because = fmt::format(
                "the ground came up by {:.2f} m: spoil, backfill, a slump or something put down", patch.change);
            return;
        }
        const Along along = goes_on_along(found, here);
        if (goes_on(patch, along)) return;
        const model::Region* was = was_unit(found, earlier);
        if (was == nullptr) {
            patch.because = "no unit was outlined here before, so the record says nothing of what lies below";
            return;
        }
        std::set<model::UnitId> outlined;
        for (const auto* regions : {&earlier, &here}) {
            for (const model::Region& region : *regions) outlined.insert(region.unit);
        }
        from_record(patch, *was, along, outlined);
    }

  private:
    static constexpr double kMostly = 0.5; // of the edge of a patch
    static constexpr double kPartly = 0.2;

    using Along = std::map<model::UnitId, double>; // share of the edge along which a unit goes on

    static Along goes_on_along(const scans::ChangedPatch& found, const std::vector<model::Region>& here) {
        Along along;
        for (const scans::LabelShare& share : found.beside) {
            const model::UnitId unit = here[static_cast<std::size_t>(share.label)].unit;
            if (!unit.is_nil()) along[unit] += share.amount / found.edge;
        }
        return along;
    }

    bool goes_on(ReadyPatch& patch, const Along& along) const {
        for (const auto& [unit, share] : along) {
            if (share < kMostly) continue;
            take(patch, unit,
                 fmt::format("{} is outlined beside it and goes on without a step along {:.0f} % of its edge",
                             index_.name(unit), 100.0 * share));
            return true;
        }
        return false;
    }

    static const model::Region* was_unit(const scans::ChangedPatch& found, const std::vector<model::Region>& earlier) {
        for (const scans::LabelShare& share : found.was) {
            if (share.label == scans::kNoRegion) continue;
            const model::Region& region = earlier[static_cast<std::size_t>(share.label)];
            if (!region.unit.is_nil()) return &region;
        }
        return nullptr;
    }

    void from_record(ReadyPatch& patch, const model::Region& was, const Along& along,
                     const std::set<model::UnitId>& outlined) const {
        const auto below = below_.find(index_.find(was.unit));
        const std::vector<model::UnitIndex> none;
        const std::vector<model::UnitIndex>& candidates = below == below_.end() ? none : below->second;
        std::vector<model::UnitIndex> beside;
        std::vector<model::UnitIndex> fresh;
        for (const model::UnitIndex unit : candidates) {
            const auto share = along.find(record_.units[unit].id);
            if (share != along.end() && share->second >= kPartly) beside.push_back(unit);
            // What lay bare before was not hidden below what was dug away since.
            if (!outlined.contains(record_.units[unit].id)) fresh.push_back(unit);
        }
        const std::string name = index_.name(was.unit);
        const auto propose_only = [&](const std::vector<model::UnitIndex>& units, std::string_view what) {
            if (units.size() != 1 || !patch.unit.is_nil()) return;
            take(patch, record_.units[units.front()].id,
                 fmt::format("{} was dug away here, and {} is the only unit recorded below it{}", name,
                             index_.name(units.front()), what));
        };
        propose_only(beside, " that goes on beside it without a step");
        propose_only(fresh, " that was not outlined yet");
        propose_only(candidates, "");
        if (!patch.unit.is_nil()) return;
        std::vector<std::string> names;
        for (const model::UnitIndex unit : fresh.empty() ? candidates : fresh) names.push_back(index_.name(unit));
        patch.because = names.empty() ? fmt::format("{} was dug away here; the record has no unit below it", name)
                                      : fmt::format("{} was dug away here; recorded below it are {}", name,
                                                    text::join(names, ", "));
    }

    void take(ReadyPatch& patch, model::UnitId unit, std::string because) const {
        patch.unit = unit;
        patch.proposed = index_.name(unit);
        patch.because = std::move(because);
    }

    const model::Record& record_;
    const model::RecordIndex& index_;
    std::map<model::UnitIndex, std::vector<model::UnitIndex>> below_;
};

/// Outlines, and which of them lies on each cell.
struct Outlined {
    std::vector<model::Region> regions;
    std::vector<std::int32_t> labels;
};

Outlined outlined_before(const model::Record& record, const std::vector<const model::Surface*>& earlier,
                         const scans::GridFrame& frame) {
    Outlined before;
    before.labels.assign(frame.cells(), scans::kNoRegion);
    for (auto surface = earlier.rbegin(); surface != earlier.rend(); ++surface) {
        const std::vector<model::Region> regions = regions_on(record, (*surface)->id);
        const scans::LabelGrid labels = scans::label_cells(frame, regions);
        const auto first = static_cast<std::int32_t>(before.regions.size());
        for (std::size_t cell = 0; cell < before.labels.size(); ++cell) {
            if (before.labels[cell] == scans::kNoRegion && labels.region[cell] != scans::kNoRegion) {
                before.labels[cell] = first + labels.region[cell];
            }
        }
        before.regions.insert(before.regions.end(), regions.begin(), regions.end());
    }
    return before;
}

// Points a cell on the ground that was outlined before; none was: everywhere.
double density(const scans::SurfaceGrid& grid, const Outlined& outlined, const scans::GridFrame& frame) {
    double points = 0.0;
    double cells = 0.0;
    for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
            const bool counts = outlined.regions.empty() || outlined.labels[frame.at(row, column)] != scans::kNoRegion;
            if (!counts) continue;
            points += grid.count[scans::cell_in(grid.frame, frame, row, column)];
            cells += 1.0;
        }
    }
    return cells > 0.0 ? points / cells : 0.0;
}

/// Two surfaces on cells of one size.
struct Compared {
    RecordedSurface after;
    scans::SurfaceDifference difference;
    Outlined outlined;
};

Compared compare(Project& project, const std::vector<const model::Surface*>& earlier, const model::Surface& last,
                 const model::Surface& surface, double cell, Progress& progress) {
    const RecordedSurface before = recorded_surface(project, last, cell, progress);
    Compared compared;
    compared.after = recorded_surface(project, surface, cell, progress);
    compared.difference =
        scans::surface_difference(before.grid, compared.after.grid, project.record().settings.tolerance);
    compared.outlined = outlined_before(project.record(), earlier, compared.difference.frame);
    return compared;
}

// On the smallest cells that the scans fill.
Compared compare_densely(Project& project, const std::vector<const model::Surface*>& earlier,
                         const model::Surface& last, const model::Surface& surface, Progress& progress) {
    Compared compared;
    for (const double cell : kComparedCells) {
        compared = compare(project, earlier, last, surface, cell, progress);
        if (density(compared.after.grid, compared.outlined, compared.difference.frame) >= kDensePoints) break;
    }
    return compared;
}

// What is outlined on a surface, and what was outlined before on ground that has not changed since.
Outlined outlined_here(const model::Record& record, const model::Surface& surface, const Compared& compared) {
    Outlined here;
    here.regions = regions_on(record, surface.id);
    here.labels = scans::label_cells(compared.difference.frame, here.regions).region;
    const auto carried = static_cast<std::int32_t>(here.regions.size());
    for (std::size_t cell = 0; cell < here.labels.size(); ++cell) {
        // Not a number where either surface saw no ground: nothing is known to have stayed.
        const bool stayed = std::abs(compared.difference.change[cell]) <= compared.difference.detectable[cell];
        if (here.labels[cell] != scans::kNoRegion || !stayed) continue;
        const std::int32_t before = compared.outlined.labels[cell];
        if (before != scans::kNoRegion) here.labels[cell] = carried + before;
    }
    here.regions.insert(here.regions.end(), compared.outlined.regions.begin(), compared.outlined.regions.end());
    return here;
}

bool lies_outside(const scans::ChangedPatch& patch) {
    for (const scans::LabelShare& share : patch.was) {
        if (share.label == scans::kNoRegion) return 2.0 * share.amount > patch.area;
    }
    return false;
}

void find_on(Project& project, const std::vector<const model::Surface*>& in_time, std::size_t at,
             const PatchQuery& query, const Proposer& proposer, ReadyPatches& result, Progress& progress) {
    const model::Record& record = project.record();
    const model::Surface& surface = *in_time[at];
    std::vector<const model::Surface*> earlier(in_time.begin(), in_time.begin() + static_cast<std::ptrdiff_t>(at));
    const auto last = std::find_if(earlier.rbegin(), earlier.rend(),
                                   [&](const model::Surface* before) { return is_seen(record, *before); });
    const std::string name = surface_name(record, surface);
    if (last == earlier.rend()) {
        result.notes.push_back(fmt::format("{}: no registered surface before it", name));
        return;
    }
    progress.step("comparing " + name);
    const Compared compared = query.cell > 0.0 ? compare(project, earlier, **last, surface, query.cell, progress)
                                               : compare_densely(project, earlier, **last, surface, progress);
    const scans::SurfaceDifference& difference = compared.difference;
    const Outlined& outlined = compared.outlined;
    const Outlined here = outlined_here(record, surface, compared);
    scans::PatchOptions options;
    options.least_area = query.least_area;
    options.simplify = 0.4 * difference.frame.cell;
    options.least_hole = query.least_area / 2.0;
    for (const scans::ChangedPatch& found :
         scans::changed_patches(difference, compared.after.grid, outlined.labels, here.labels, options)) {
        if (!outlined.regions.empty() && lies_outside(found)) {
            ++result.outside;
            continue;
        }
        ReadyPatch patch;
        patch.surface = name;
        patch.on_surface = surface.id;
        patch.shape = found.shape;
        patch.area = found.area;
        patch.change = found.change;
        if (!found.was.empty() && found.was.front().label != scans::kNoRegion) {
            const auto label = static_cast<std::size_t>(found.was.front().label);
            patch.was = region_label(record, project.index(), outlined.regions[label]);
        }
        proposer.propose(patch, found, outlined.regions, here.regions);
        result.patches.push_back(std::move(patch));
    }
}

} // namespace

ReadyPatches ready_patches(Project& project, const PatchQuery& query, Progress& progress) {
    const model::Record& record = project.record();
    const model::Surface* wanted = query.surface.empty() ? nullptr : &known_surface(record, query.surface);
    std::vector<model::AreaId> areas;
    for (const model::Surface& surface : record.surfaces) {
        if (std::find(areas.begin(), areas.end(), surface.area) == areas.end()) areas.push_back(surface.area);
    }
    const Proposer proposer(record, project.index());
    ReadyPatches result;
    for (const model::AreaId area : areas) {
        const std::vector<const model::Surface*> in_time = surfaces_in_time(record, area);
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < in_time.size(); ++i) {
            const bool asked = wanted != nullptr ? in_time[i] == wanted : is_seen(record, *in_time[i]);
            if (asked) places.push_back(i);
        }
        if (wanted == nullptr && !query.all && places.size() > 1) places.erase(places.begin(), places.end() - 1);
        for (const std::size_t place : places) {
            // The first surface has nothing before it; said only when it was asked for.
            if (place == 0 && query.all) continue;
            find_on(project, in_time, place, query, proposer, result, progress);
        }
    }
    return result;
}

std::string patches_geojson(const model::Record& record, const ReadyPatches& patches) {
    ordered_json features = ordered_json::array();
    for (const ReadyPatch& patch : patches.patches) {
        ordered_json coordinates = ordered_json::array();
        for (const geometry::Rings& rings : patch.shape) {
            ordered_json polygon = ordered_json::array();
            for (const geometry::Line3& ring : rings) {
                ordered_json points = ordered_json::array();
                for (std::size_t i = 0; i <= ring.size(); ++i) {
                    const geometry::Point3& p = ring[i % ring.size()];
                    points.push_back(
                        {std::round(p[0] * 1e3) / 1e3, std::round(p[1] * 1e3) / 1e3, std::round(p[2] * 1e3) / 1e3});
                }
                polygon.push_back(std::move(points));
            }
            coordinates.push_back(std::move(polygon));
        }
        ordered_json properties;
        if (!patch.proposed.empty()) properties["unit"] = patch.proposed;
        properties["surface"] = patch.surface;
        properties["category"] = patch.change > 0.0 ? "spoil" : "unit";
        properties["sigma"] = 0.05;
        properties["notes"] = patch.because;
        features.push_back({{"type", "Feature"},
                            {"properties", std::move(properties)},
                            {"geometry", {{"type", "MultiPolygon"}, {"coordinates", std::move(coordinates)}}}});
    }
    ordered_json all = {{"type", "FeatureCollection"},
                        {"name", record.settings.name + ", patches to be named"},
                        {"features", std::move(features)}};
    return all.dump(1) + "\n";
}

} // namespace planum::app
