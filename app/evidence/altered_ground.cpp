// SPDX-License-Identifier: MIT
#include "app/evidence/altered_ground.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/evidence/outline_key.hpp"
#include "app/project/sealed_file.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "app/surfaces/recorded_surface.hpp"
#include "app/surfaces/surface_cache.hpp"
#include "core/base/error.hpp"
#include "core/base/sha256.hpp"
#include "core/model/surface_order.hpp"
#include "scans/surface/altered_ground.hpp"
#include "scans/surface/label_grid.hpp"

namespace planum::app {

namespace {

using Kind = model::GroundAlteration::Kind;
using model::GroundAlteration;
using nlohmann::json;

constexpr std::string_view kVersion = "planum altered ground 1\n";
constexpr double kNamed = 0.02; // units with less of a patch are not named, unless they have most of it [m²]

json to_json(const GroundAlteration& a) {
    json units = json::array();
    for (const model::UnitId unit : a.units) units.push_back(unit.to_string());
    return {a.kind == Kind::Rose, std::move(units), a.x, a.y, a.area, a.change, a.detectable, a.low, a.high,
            a.lower_scan,         a.higher_scan};
}

// Without the names of surfaces, which may change while what is seen on them does not.
GroundAlteration alteration_from(const json& j) {
    GroundAlteration a;
    a.kind = j.at(0).get<bool>() ? Kind::Rose : Kind::ChangedWithin;
    for (const json& unit : j.at(1)) {
        if (const auto id = Uuid::parse(unit.get_ref<const std::string&>())) a.units.push_back(model::UnitId{*id});
    }
    a.x = j.at(2);
    a.y = j.at(3);
    a.area = j.at(4);
    a.change = j.at(5);
    a.detectable = j.at(6);
    a.low = j.at(7);
    a.high = j.at(8);
    a.lower_scan = j.at(9);
    a.higher_scan = j.at(10);
    return a;
}

std::optional<std::vector<GroundAlteration>> read_kept(const std::filesystem::path& file) {
    const auto bytes = read_sealed(file);
    if (!bytes) return std::nullopt;
    std::vector<GroundAlteration> kept;
    try {
        for (const json& j : json::parse(*bytes)) kept.push_back(alteration_from(j));
    } catch (const json::exception&) {
        return std::nullopt;
    }
    return kept;
}

void keep(const std::filesystem::path& file, const std::vector<GroundAlteration>& found) {
    json all = json::array();
    for (const GroundAlteration& a : found) all.push_back(to_json(a));
    // Names of scans are names of files, whose bytes need not be UTF-8.
    write_sealed(file, all.dump(-1, ' ', false, json::error_handler_t::replace));
}

bool is_drawn_ground(const model::Region& region) {
    return region.category == model::RegionCategory::Unit && region.shows != model::RegionShows::Face &&
           region.shows != model::RegionShows::Nothing;
}

// The surfaces of one area, one after the other.
class AreaGround {
  public:
    AreaGround(Project& project, const AreaEvidence& area, Progress& progress)
        : project_(project), record_(project.record()), area_(area), progress_(progress),
          folder_(scans_folder(project.path()) / "evidence"), clashes_(model::clashes_of_order(record_)) {
        for (const model::Region& region : record_.regions) {
            if (region.section.is_nil()) regions_[region.surface].push_back(region);
        }
    }

    void add_to(std::vector<GroundAlteration>& all) {
        const model::Surface* before = nullptr;
        const std::vector<model::Region>* drawn = nullptr;
        for (const model::Surface* surface : surfaces_in_time(record_, area_.area)) {
            progress_.check();
            if (model::is_in_clash(clashes_, surface->id)) continue;
            if (const auto own = regions_.find(surface->id); own != regions_.end()) drawn = &own->second;
            const std::string key = surface_key(record_, surface->id, area_.frame);
            if (key.empty() || drawn == nullptr) continue;
            for (GroundAlteration& a : found(*surface, before, *drawn)) {
                a.surface = surface_name(record_, *surface);
                if (a.kind == Kind::Rose) a.since = surface_name(record_, *before);
                all.push_back(std::move(a));
            }
            before = surface;
        }
    }

  private:
    [[nodiscard]] std::vector<GroundAlteration> found(const model::Surface& surface, const model::Surface* before,
                                                      const std::vector<model::Region>& drawn) {
        const std::string heights = surface_key(record_, surface.id, area_.frame);
        const std::string former = before == nullptr ? "" : surface_key(record_, before->id, area_.frame);
        std::string text = fmt::format("{}{}\n{}\n", kVersion, heights, former);
        for (const model::Region& region : drawn) text += outline_key(region);
        const std::filesystem::path file = folder_ / (sha256(text).substr(0, 32) + ".altered");
        if (auto kept = read_kept(file)) return std::move(*kept);
        std::vector<GroundAlteration> all;
        try {
            KeptSurface here = kept_surface(project_, surface.id, area_.frame, heights, progress_);
            scans::put_back(here.grid, here.as_seen);
            const std::vector<std::int32_t> region = drawn_cells(drawn);
            for (const scans::DisputedPatch& patch : here.disputed) {
                const scans::AlteredPatch inside = scans::patch_inside(here.grid, patch.cells, region);
                if (inside.area < scans::RiseRules{}.least_area) continue;
                all.push_back(alteration(Kind::ChangedWithin, inside, drawn));
                all.back().change = patch.difference;
                all.back().detectable = patch.detectable;
                all.back().lower_scan = patch.lower;
                all.back().higher_scan = patch.higher;
            }
            if (before != nullptr) {
                const scans::SurfaceGrid was = seen_surface(project_, before->id, area_.frame, former, progress_);
                scans::RiseRules rules;
                rules.tolerance = record_.settings.tolerance;
                for (const scans::AlteredPatch& patch : scans::risen_ground(was, here.grid, region, rules))
                    all.push_back(alteration(Kind::Rose, patch, drawn));
            }
        } catch (const Error& e) {
            if (e.code() == ErrorCode::Cancelled) throw;
            return {};
        }
        keep(file, all);
        return all;
    }

    // The region of each cell; kNoRegion where none is, or what is known not to be ground.
    [[nodiscard]] std::vector<std::int32_t> drawn_cells(const std::vector<model::Region>& drawn) const {
        std::vector<std::int32_t> region = scans::label_cells(area_.frame, drawn).region;
        for (std::int32_t& one : region) {
            if (one != scans::kNoRegion && !is_drawn_ground(drawn[static_cast<std::size_t>(one)]))
                one = scans::kNoRegion;
        }
        return region;
    }

    static GroundAlteration alteration(Kind kind, const scans::AlteredPatch& patch,
                                       const std::vector<model::Region>& drawn) {
        GroundAlteration a;
        a.kind = kind;
        a.x = patch.x;
        a.y = patch.y;
        a.area = patch.area;
        a.change = patch.change;
        a.detectable = patch.detectable;
        a.low = patch.low;
        a.high = patch.high;
        std::map<model::UnitId, double> parts;
        for (const auto& [region, area] : patch.regions) {
            const model::UnitId unit = drawn[static_cast<std::size_t>(region)].unit;
            if (!unit.is_nil()) parts[unit] += area;
        }
        std::vector<std::pair<double, model::UnitId>> units;
        for (const auto& [unit, area] : parts) units.emplace_back(-area, unit);
        std::sort(units.begin(), units.end());
        for (const auto& [area, unit] : units) {
            if (a.units.empty() || -area >= kNamed) a.units.push_back(unit);
        }
        return a;
    }

    Project& project_;
    const model::Record& record_;
    const AreaEvidence& area_;
    Progress& progress_;
    std::filesystem::path folder_;
    std::vector<model::OrderClash> clashes_; ///< nobody knows what was before or after those
    std::map<model::SurfaceId, std::vector<model::Region>> regions_;
};

} // namespace

std::vector<GroundAlteration> altered_ground(Project& project, const std::vector<AreaEvidence>& areas,
                                             Progress& progress) {
    std::vector<GroundAlteration> all;
    progress.step("looking for ground that changed");
    for (const AreaEvidence& area : areas) {
        if (area.frame.cells() > 0) AreaGround(project, area, progress).add_to(all);
    }
    return all;
}

} // namespace planum::app
