// SPDX-License-Identifier: MIT
#include "strat/exchange/map_features.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace planum::strat {

namespace {

using Shape = MapFeature::Shape;

std::string number(double value) { return fmt::format("{}", value); }

// Empty fields are left out.
void field(MapFeature& feature, const char* name, std::string value) {
    if (!value.empty()) feature.fields.emplace_back(name, std::move(value));
}

std::string kind_word(const model::StratigraphicUnit& unit) {
    return std::string(unit.form == model::UnitForm::None ? to_word(unit.kind) : to_word(unit.form));
}

class Collector {
  public:
    explicit Collector(const RecordNames& names) : names_(names), record_(names.record()) {}

    [[nodiscard]] MapFeatures all() {
        regions();
        finds();
        levels();
        stations();
        sections();
        return std::move(found_);
    }

  private:
    [[nodiscard]] std::string unit_name(model::UnitId id) const {
        return id.is_nil() || !names_.has(id) ? std::string{} : names_.unit(id);
    }

    [[nodiscard]] const model::Surface* surface_of(model::SurfaceId id) const {
        const auto it = std::find_if(record_.surfaces.begin(), record_.surfaces.end(),
                                     [&](const model::Surface& surface) { return surface.id == id; });
        return it == record_.surfaces.end() ? nullptr : &*it;
    }

    void regions() {
        std::size_t upright = 0;
        for (const model::Region& region : record_.regions) {
            if (region.surface.is_nil() && !region.section.is_nil()) {
                ++upright;
                continue;
            }
            MapFeature feature;
            feature.layer = "region";
            feature.shape = Shape::Outline;
            feature.outline = region.outline;
            feature.has_height = region.has_heights;
            feature.label = names_.has(region.unit) ? names_.unit(region.unit) : region.unit_as_drawn;
            feature.kind = region.category != model::RegionCategory::Unit ? std::string(to_word(region.category))
                           : names_.has(region.unit)                      ? kind_word(names_.unit_at(region.unit))
                                                                          : "unknown";
            field(feature, "unit", feature.label);
            field(feature, "part", fmt::format("{}", region.part));
            field(feature, "kind", feature.kind);
            field(feature, "category", std::string(to_word(region.category)));
            field(feature, "shows", std::string(to_word(region.shows)));
            if (const model::Surface* surface = surface_of(region.surface)) {
                field(feature, "surface", surface->name);
                field(feature, "day", surface->first_day);
                field(feature, "area", names_.area(surface->area));
            }
            field(feature, "sigma_m", number(region.sigma));
            field(feature, "drawn_on", region.drawn_on);
            field(feature, "notes", region.notes);
            found_.features.push_back(std::move(feature));
        }
        add_loss(found_.lost, upright, "regions that stand upright on a section");
    }

    void finds() {
        std::size_t nowhere = 0;
        for (const model::Find& find : record_.finds) {
            if (!find.x || !find.y) {
                ++nowhere;
                continue;
            }
            MapFeature feature = point("find", *find.x, *find.y, find.z);
            feature.kind = find.type.empty() ? "find" : find.type;
            feature.label = find.number;
            field(feature, "number", find.number);
            field(feature, "unit", unit_name(find.unit));
            field(feature, "type", find.type);
            field(feature, "material", find.material);
            field(feature, "found_on", find.found_on);
            field(feature, "description", find.description);
            found_.features.push_back(std::move(feature));
        }
        add_loss(found_.lost, nowhere, "finds without a measured place");
    }

    void levels() {
        std::size_t nowhere = 0;
        for (const model::Level& level : record_.levels) {
            if (!level.x || !level.y) {
                ++nowhere;
                continue;
            }
            MapFeature feature = point("level", *level.x, *level.y, level.z);
            feature.kind = std::string(to_word(level.role));
            feature.label = fmt::format("{:.2f}", level.z);
            field(feature, "unit", unit_name(level.unit));
            field(feature, "role", feature.kind);
            field(feature, "z", number(level.z));
            field(feature, "label", level.label);
            found_.features.push_back(std::move(feature));
        }
        add_loss(found_.lost, nowhere, "levels without a measured place");
    }

    void stations() {
        std::size_t unplaced = 0;
        for (const model::Scan& scan : record_.scans) {
            const model::ScanPose* pose = model::pose_in_force(record_, scan.id);
            if (pose == nullptr) {
                ++unplaced;
                continue;
            }
            const auto& matrix = pose->site_from_scan; // the station is the scan's origin
            MapFeature feature = point("scan", matrix[3], matrix[7], matrix[11]);
            feature.kind = "station";
            feature.label = scan.name;
            field(feature, "scan", scan.name);
            field(feature, "day", scan.day);
            field(feature, "points", fmt::format("{}", scan.points));
            field(feature, "rms_m", number(pose->rms));
            found_.features.push_back(std::move(feature));
        }
        add_loss(found_.lost, unplaced, "scans that are not on the site grid yet");
    }

    void sections() {
        for (const model::Section& section : record_.sections) {
            MapFeature feature;
            feature.layer = "section";
            feature.shape = Shape::Line;
            feature.has_height = false;
            feature.points = {{section.from_in_site[0], section.from_in_site[1], 0.0},
                              {section.to_in_site[0], section.to_in_site[1], 0.0}};
            feature.kind = "section";
            feature.label = section.name;
            field(feature, "name", section.name);
            field(feature, "day", section.day);
            field(feature, "area", names_.area(section.area));
            found_.features.push_back(std::move(feature));
        }
    }

    [[nodiscard]] static MapFeature point(const char* layer, double x, double y, std::optional<double> z) {
        MapFeature feature;
        feature.layer = layer;
        feature.points = {{x, y, z.value_or(0.0)}};
        feature.has_height = z.has_value();
        return feature;
    }

    const RecordNames& names_;
    const model::Record& record_;
    MapFeatures found_;
};

} // namespace

MapFeatures map_features(const RecordNames& names) { return Collector(names).all(); }

} // namespace planum::strat
