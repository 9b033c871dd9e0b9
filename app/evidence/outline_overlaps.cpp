// SPDX-License-Identifier: MIT
#include "app/evidence/outline_overlaps.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/evidence/outline_key.hpp"
#include "app/project/sealed_file.hpp"
#include "app/regions/region_layout.hpp"
#include "app/regions/region_names.hpp"
#include "app/scans/days_surface.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/sha256.hpp"
#include "core/geometry/polygon_overlay.hpp"

namespace planum::app {

namespace {

using nlohmann::json;

constexpr std::string_view kVersion = "planum outline overlaps 1\n";

// Two of the regions that were laid out, by their position.
struct Overlap {
    std::size_t first = 0;
    std::size_t second = 0;
    double area = 0.0; // [m²]
    double x = 0.0;    // a place inside: in plan, or along the section and up
    double y = 0.0;
};

std::optional<std::vector<Overlap>> read_kept(const std::filesystem::path& file, std::size_t regions) {
    const auto bytes = read_sealed(file);
    if (!bytes) return std::nullopt;
    std::vector<Overlap> kept;
    try {
        for (const json& j : json::parse(*bytes)) {
            kept.push_back({j.at(0), j.at(1), j.at(2), j.at(3), j.at(4)});
            if (kept.back().first >= regions || kept.back().second >= regions) return std::nullopt;
        }
    } catch (const json::exception&) {
        return std::nullopt;
    }
    return kept;
}

std::vector<Overlap> laid_out(const std::vector<const model::Region*>& regions, const model::Section* section) {
    std::vector<Overlap> found;
    const auto position = [&](const model::Region* region) {
        return static_cast<std::size_t>(std::find(regions.begin(), regions.end(), region) - regions.begin());
    };
    for (const RegionOverlap& overlap : layout_regions(regions, section).overlaps) {
        const auto [x, y] = geometry::inner_place(overlap.where);
        found.push_back({position(overlap.first), position(overlap.second), overlap.area, x, y});
    }
    return found;
}

class Finder {
  public:
    Finder(Project& project, Progress& progress)
        : record_(project.record()), index_(project.index()), progress_(progress),
          folder_(scans_folder(project.path()) / "evidence") {}

    std::vector<model::OutlineOverlap> find() {
        for (const model::Surface& surface : record_.surfaces)
            look_at(surface_name(record_, surface), regions_on(record_, surface.id), nullptr);
        for (const model::Section& section : record_.sections)
            look_at(section.name, regions_on(record_, section.id), &section);
        return std::move(all_);
    }

  private:
    void look_at(const std::string& where, const std::vector<const model::Region*>& regions,
                 const model::Section* section) {
        if (regions.size() < 2) return;
        progress_.check();
        std::string text{kVersion};
        if (section != nullptr) {
            for (const auto& end : {section->from_in_site, section->to_in_site})
                text += fmt::format("{} {}\n", end[0], end[1]);
        }
        for (const model::Region* region : regions) {
            text += outline_key(*region);
            if (section != nullptr) { // the key of an outline in plan is without heights
                for (const model::Polygon& polygon : region->outline) {
                    for (const auto& corner : polygon.outer) text += fmt::format("{} ", corner[2]);
                }
            }
        }
        const std::filesystem::path file = folder_ / (sha256(text).substr(0, 32) + ".overlaps");
        std::optional<std::vector<Overlap>> found = read_kept(file, regions.size());
        if (!found) {
            found = laid_out(regions, section);
            json kept = json::array();
            for (const Overlap& o : *found) kept.push_back({o.first, o.second, o.area, o.x, o.y});
            write_sealed(file, kept.dump());
        }
        for (const Overlap& o : *found) add(where, *regions[o.first], *regions[o.second], o);
    }

    void add(const std::string& where, const model::Region& first, const model::Region& second, const Overlap& o) {
        model::OutlineOverlap overlap;
        overlap.where = where;
        overlap.first = region_name(record_, index_, first);
        overlap.second = region_name(record_, index_, second);
        for (const model::UnitId unit : {first.unit, second.unit}) {
            if (!unit.is_nil() && (overlap.units.empty() || overlap.units.front() != unit))
                overlap.units.push_back(unit);
        }
        overlap.area = o.area;
        overlap.x = o.x;
        overlap.y = o.y;
        all_.push_back(std::move(overlap));
    }

    const model::Record& record_;
    const model::RecordIndex& index_;
    Progress& progress_;
    std::filesystem::path folder_;
    std::vector<model::OutlineOverlap> all_;
};

} // namespace

std::vector<model::OutlineOverlap> outline_overlaps(Project& project, Progress& progress) {
    progress.step("laying outlines over each other");
    return Finder(project, progress).find();
}

} // namespace planum::app
