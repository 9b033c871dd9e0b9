// SPDX-License-Identifier: MIT
#include "app/evidence/evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "app/evidence/outline_key.hpp"
#include "app/evidence/step_cache.hpp"
#include "app/regions/region_layout.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "app/scans/surface_scans.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/geometry/polygons.hpp"
#include "core/model/astray.hpp"
#include "core/model/surface_order.hpp"
#include "scans/surface/cells_within.hpp"
#include "scans/surface/label_grid.hpp"
#include "scans/surface/surface_step.hpp"

namespace planum::app {

namespace {

constexpr double kSpare = 0.1; // around all outlines [m]
constexpr std::string_view kVersion = "planum evidence 3\n";

// All that belongs to the surfaces of one area, in the order of time.
class AreaWork {
  public:
    AreaWork(Project& project, model::AreaId area, Progress& progress)
        : project_(project), record_(project.record()), progress_(progress),
          clashes_(model::clashes_of_order(record_)) {
        evidence_.area = area;
        surfaces_ = surfaces_in_time(record_, area);
        for (const model::Surface* surface : surfaces_) evidence_.surfaces.push_back(surface->id);
        for (const model::Region& region : record_.regions) {
            if (region.section.is_nil()) regions_[region.surface].push_back(region);
        }
        number_units();
        cache_.emplace(scans_folder(project.path()) / "evidence", evidence_.units);
    }

    [[nodiscard]] bool is_worth_it() const { return !evidence_.units.empty() && surfaces_.size() >= 2; }

    AreaEvidence gather() {
        const geometry::Extent extent = extent_of_outlines();
        if (extent.is_empty()) return std::move(evidence_);
        for (const double cell : kComparedCells) {
            // On whole metres, so that an outline redrawn a little wider leaves all heights as they are.
            frame_ = scans::frame_around({std::floor(extent.low[0] - kSpare), std::floor(extent.low[1] - kSpare),
                                          std::ceil(extent.high[0] + kSpare), std::ceil(extent.high[1] + kSpare)},
                                         cell);
            labelled_.clear();
            make_keys();
            if (cell == kComparedCells.back() || usual_density() >= kDensePoints) break;
        }
        evidence_.frame = frame_;
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            if (is_out_of_order(i)) {
                evidence_.unseen.push_back({surfaces_[i]->id, "its days and its place in the order of surfaces "
                                                              "disagree; planum check says with which"});
            } else if (keys_[i].heights.empty() && !regions_[surfaces_[i]->id].empty()) {
                evidence_.unseen.push_back({surfaces_[i]->id, why_unseen(record_, *surfaces_[i])});
            }
            progress_.check();
            progress_.fraction(static_cast<double>(i) / static_cast<double>(surfaces_.size()));
            evidence_.history.methods.push_back(surfaces_[i]->method);
            evidence_.history.summaries.push_back(summary(i));
            if (i > 0) add_step(i - 1);
        }
        evidence_.conclusions = scans::conclude(evidence_.history, evidence_.units);
        return std::move(evidence_);
    }

  private:
    [[nodiscard]] scans::HeightTolerance tolerance() const {
        scans::HeightTolerance t;
        t.project = record_.settings.tolerance;
        return t;
    }

    // Only units that are outlined here get a number.
    void number_units() {
        std::set<model::UnitId> outlined;
        for (const model::Surface* surface : surfaces_) {
            for (const model::Region& region : regions_[surface->id]) {
                if (region.category == model::RegionCategory::Unit && !region.unit.is_nil())
                    outlined.insert(region.unit);
            }
        }
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (!outlined.contains(unit.id)) continue;
            numbers_.emplace(unit.id, static_cast<scans::UnitNumber>(evidence_.units.size()));
            evidence_.units.push_back({unit.id, unit.kind, unit.form});
        }
        constexpr std::size_t kMost = 32000; // a cell keeps two bytes for its unit
        if (evidence_.units.size() > kMost) {
            throw Error(ErrorCode::BadInput, fmt::format("{} outlined units in one area; {} can be compared",
                                                         evidence_.units.size(), kMost));
        }
    }

    // Outlines that lie astray would make a plan of kilometres; they are left out.
    [[nodiscard]] geometry::Extent extent_of_outlines() {
        const model::ScannedBox scanned(record_);
        geometry::Extent all;
        for (const model::Surface* surface : surfaces_) {
            std::size_t astray = 0;
            for (const model::Region& region : regions_[surface->id]) {
                if (scanned.is_astray(region)) {
                    ++astray;
                } else {
                    all.add(geometry::extent(scans::shape_of(region)));
                }
            }
            if (astray > 0) {
                evidence_.unseen.push_back(
                    {surface->id, fmt::format("{} left out, more than {:.0f} m from all scans; planum check says where",
                                              astray == 1 ? "an outline is" : fmt::format("{} outlines are", astray),
                                              model::kFarthestOutline)});
            }
        }
        return all;
    }

    // Points a cell inside the outlines, median of the surfaces that were scanned; infinite where none was.
    [[nodiscard]] double usual_density() {
        std::vector<double> densities;
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            if (!keys_[i].heights.empty()) densities.push_back(density(i));
        }
        std::erase_if(densities, [](double density) { return std::isnan(density); });
        if (densities.empty()) return std::numeric_limits<double>::infinity();
        const auto middle = densities.begin() + static_cast<std::ptrdiff_t>(densities.size() / 2);
        std::nth_element(densities.begin(), middle, densities.end());
        return *middle;
    }

    // NaN where nothing is outlined, or the points are missing.
    [[nodiscard]] double density(std::size_t i) {
        if (const auto cached = cache_->density(keys_[i].labels)) return *cached;
        const scans::SurfaceGrid grid = heights(i);
        if (is_broken(i)) return std::nan("");
        const scans::LabelGrid labels = scans::label_cells(frame_, regions_[surfaces_[i]->id]);
        double points = 0.0;
        double cells = 0.0;
        for (std::size_t cell = 0; cell < labels.region.size(); ++cell) {
            if (labels.region[cell] == scans::kNoRegion) continue;
            points += grid.count[cell];
            cells += 1.0;
        }
        if (cells == 0.0) return std::nan("");
        cache_->keep_density(keys_[i].labels, points / cells);
        return points / cells;
    }

    void make_keys() {
        keys_.clear();
        std::string so_far;
        for (const model::Surface* surface : surfaces_) {
            // What came before or after such a surface nobody knows, so that it counts as one that nobody saw.
            const bool is_ordered = !model::is_in_clash(clashes_, surface->id);
            std::string heights = is_ordered ? surface_key(record_, surface->id, frame_) : std::string{};
            std::string labels = heights + fmt::format("\n{}\n", record_.settings.tolerance);
            for (const model::Region& region : regions_[surface->id]) labels += outline_key(region);
            so_far += heights + '\n';
            keys_.push_back({std::move(heights), sha256(fmt::format("{}{}", kVersion, labels)), sha256(so_far)});
        }
    }

    [[nodiscard]] scans::SurfaceSummary summary(std::size_t i) {
        if (auto cached = cache_->summary(keys_[i].labels)) return std::move(*cached);
        scans::SurfaceSummary found = scans::summarise(labelled(i));
        if (!is_broken(i)) cache_->keep(keys_[i].labels, found);
        return found;
    }

    void add_step(std::size_t i) {
        bool nobody_knows_where = false;
        const auto hidden = hidden_cells(*surfaces_[i], *surfaces_[i + 1], nobody_knows_where);
        evidence_.history.hides_somewhere.push_back(nobody_knows_where);
        std::string parts = keys_[i].labels + keys_[i + 1].labels + (i > 0 ? keys_[i - 1].floor : "");
        for (const std::size_t cell : hidden) parts += fmt::format(" {}", cell);
        const std::string key = sha256(parts);
        if (auto cached = cache_->step(key)) {
            evidence_.history.steps.push_back(std::move(*cached));
            return;
        }
        labelled(i);
        labelled(i + 1);
        std::vector<float> floor = i > 0 ? floor_of(i - 1) : std::vector<float>{};
        scans::SurfaceStep step = scans::step_between(labelled_.at(i), labelled_.at(i + 1), tolerance(), hidden, floor);
        const bool is_sound = std::none_of(broken_.begin(), broken_.end(), [&](std::size_t b) { return b <= i + 1; });
        if (is_sound) {
            cache_->keep_floor(keys_[i].floor, floor);
            cache_->keep(key, step);
        }
        last_floor_ = {i, std::move(floor)};
        evidence_.history.steps.push_back(std::move(step));
    }

    // The lowest heights on surfaces 0 to i.
    [[nodiscard]] std::vector<float> floor_of(std::size_t i) {
        if (last_floor_ && last_floor_->first == i) return last_floor_->second;
        std::size_t next = i + 1;
        std::vector<float> floor(frame_.cells(), std::nanf(""));
        for (; next > 0; --next) {
            if (auto cached = cache_->floor(keys_[next - 1].floor, frame_.cells())) {
                floor = std::move(*cached);
                break;
            }
        }
        for (; next <= i; ++next) {
            const scans::SurfaceGrid grid = heights(next);
            for (std::size_t cell = 0; cell < floor.size(); ++cell)
                floor[cell] = std::fmin(floor[cell], grid.height[cell]);
        }
        return floor;
    }

    [[nodiscard]] bool is_out_of_order(std::size_t i) const { return model::is_in_clash(clashes_, surfaces_[i]->id); }

    [[nodiscard]] bool is_broken(std::size_t i) const { return broken_.contains(i); }

    [[nodiscard]] scans::SurfaceGrid heights(std::size_t i) {
        if (keys_[i].heights.empty() || is_broken(i)) return nothing_seen();
        try {
            return seen_surface(project_, surfaces_[i]->id, frame_, keys_[i].heights, progress_);
        } catch (const Error& e) {
            if (e.code() == ErrorCode::Cancelled) throw;
            broken_.insert(i);
            evidence_.unseen.push_back({surfaces_[i]->id, e.what()});
            return nothing_seen();
        }
    }

    // Two at a time are kept.
    const scans::LabelledSurface& labelled(std::size_t i) {
        if (const auto known = labelled_.find(i); known != labelled_.end()) return known->second;
        const std::vector<model::Region>& regions = regions_[surfaces_[i]->id];
        std::vector<scans::UnitNumber> units;
        for (const model::Region& region : regions) {
            const auto number = numbers_.find(region.unit);
            const bool is_unit = region.category == model::RegionCategory::Unit && number != numbers_.end();
            units.push_back(is_unit ? number->second : scans::kNobody);
        }
        std::erase_if(labelled_, [&](const auto& kept) { return kept.first + 1 < i; });
        const scans::SurfaceGrid grid = heights(i);
        const scans::LabelGrid labels = undisputed(scans::label_cells(frame_, regions), regions);
        return labelled_.emplace(i, scans::label_surface(grid, labels, regions, units, tolerance())).first->second;
    }

    // What two outlines claim belongs to neither.
    [[nodiscard]] static scans::LabelGrid undisputed(scans::LabelGrid labels,
                                                     const std::vector<model::Region>& regions) {
        std::vector<const model::Region*> all;
        for (const model::Region& region : regions) all.push_back(&region);
        for (const RegionOverlap& overlap : layout_regions(all).overlaps) {
            scans::for_cells_within(labels.frame, overlap.where,
                                    [&](std::size_t cell) { labels.region[cell] = scans::kNoRegion; });
        }
        return labels;
    }

    [[nodiscard]] scans::SurfaceGrid nothing_seen() const {
        const std::size_t n = frame_.cells();
        const float nan = std::nanf("");
        return {frame_,
                std::vector<float>(n, nan),
                std::vector<float>(n, 0.0F),
                std::vector<float>(n, 0.0F),
                std::vector<float>(n, nan),
                std::vector<std::uint16_t>(n, 0),
                std::vector<scans::CellState>(n, scans::CellState::Unseen)};
    }

    // Places of units that no surface shows and that were finished between the two.
    [[nodiscard]] std::vector<std::size_t> hidden_cells(const model::Surface& upper, const model::Surface& lower,
                                                        bool& nobody_knows_where) const {
        std::vector<std::size_t> cells;
        for (const model::StratigraphicUnit& unit : record_.units) {
            if (numbers_.contains(unit.id) || unit.status == model::UnitStatus::Void) continue;
            if (!unit.area.is_nil() && !evidence_.area.is_nil() && unit.area != evidence_.area) continue;
            if (unit.excavated_on <= last_day_of(upper) || unit.excavated_on > last_day_of(lower)) continue;
            const std::size_t before = cells.size();
            for (const model::Level& level : record_.levels) {
                if (level.unit == unit.id) add_cell(cells, level.x, level.y);
            }
            for (const model::Find& find : record_.finds) {
                if (find.unit == unit.id) add_cell(cells, find.x, find.y);
            }
            if (cells.size() == before) nobody_knows_where = true;
        }
        return cells;
    }

    void add_cell(std::vector<std::size_t>& cells, std::optional<double> x, std::optional<double> y) const {
        if (!x || !y) return;
        const double column = std::floor(*x / frame_.cell) - static_cast<double>(frame_.west);
        const double row = std::floor(*y / frame_.cell) - static_cast<double>(frame_.south);
        if (!(column >= 0.0 && row >= 0.0 && column < frame_.columns && row < frame_.rows)) return;
        cells.push_back(frame_.at(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column)));
    }

    struct Keys {
        std::string heights; ///< empty: no scan on the site grid
        std::string labels;  ///< heights and outlines
        std::string floor;   ///< heights of all surfaces up to here
    };

    Project& project_;
    const model::Record& record_;
    Progress& progress_;
    std::vector<model::OrderClash> clashes_;
    AreaEvidence evidence_;
    std::optional<StepCache> cache_; ///< once the units have numbers
    scans::GridFrame frame_;
    std::vector<const model::Surface*> surfaces_;
    std::vector<Keys> keys_;
    std::set<std::size_t> broken_; ///< surfaces whose points are missing
    std::map<std::size_t, scans::LabelledSurface> labelled_;
    std::optional<std::pair<std::size_t, std::vector<float>>> last_floor_;
    std::map<model::SurfaceId, std::vector<model::Region>> regions_;
    std::unordered_map<model::UnitId, scans::UnitNumber> numbers_;
};

bool has_registered_scans(const model::Record& record) { return !record.poses.empty() && !record.regions.empty(); }

} // namespace

std::vector<AreaEvidence> gather_evidence(Project& project, Progress& progress) {
    std::vector<AreaEvidence> all;
    if (!has_registered_scans(project.record())) return all;
    progress.step("comparing surfaces");
    std::vector<model::AreaId> areas;
    for (const model::Surface& surface : project.record().surfaces) {
        if (std::find(areas.begin(), areas.end(), surface.area) == areas.end()) areas.push_back(surface.area);
    }
    for (const model::AreaId area : areas) {
        AreaWork work(project, area, progress);
        if (work.is_worth_it()) all.push_back(work.gather());
    }
    return all;
}

bool same_sources(const model::Record& a, const model::Record& b) {
    const auto same_unit = [](const model::StratigraphicUnit& u, const model::StratigraphicUnit& v) {
        return u.id == v.id && u.kind == v.kind && u.form == v.form;
    };
    return a.settings.tolerance == b.settings.tolerance && a.surfaces == b.surfaces && a.scans == b.scans &&
           a.poses == b.poses && a.runs == b.runs && a.regions == b.regions && a.sections == b.sections &&
           std::equal(a.units.begin(), a.units.end(), b.units.begin(), b.units.end(), same_unit);
}

std::vector<model::SurfaceEvidence> surface_evidence(const std::vector<AreaEvidence>& areas) {
    std::vector<model::SurfaceEvidence> all;
    for (const AreaEvidence& area : areas) {
        for (const scans::Conclusion& c : area.conclusions) {
            const bool roof = c.ground == scans::Ground::RoofOfHollow && !c.thin;
            if (c.is_question && !roof) continue;
            model::SurfaceEvidence e;
            e.upper = area.units[static_cast<std::size_t>(c.unit)].id;
            e.lower = area.units[static_cast<std::size_t>(c.other)].id;
            e.source = c.source;
            e.area = c.area;
            e.contrary_area = c.contrary_area;
            e.thickness = c.thickness;
            e.tolerance = c.tolerance;
            e.both_faces_own = c.source == model::EvidenceSource::StratigraphicSurfaces;
            e.testable = !c.thin && !roof;
            e.below_is_bare_cut = roof || c.ground == scans::Ground::EmptiedCut;
            if (c.thin) e.why_not_testable = "thinner than the heights can tell";
            if (roof) e.why_not_testable = "may be the roof of a hollow";
            e.surfaces = {area.surfaces[c.from], area.surfaces[c.to]};
            all.push_back(std::move(e));
        }
    }
    return all;
}

} // namespace planum::app
