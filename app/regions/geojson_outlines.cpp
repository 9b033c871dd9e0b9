// SPDX-License-Identifier: MIT
#include "app/regions/geojson_outlines.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "app/regions/outline_properties.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"

namespace planum::app {

namespace {

using strat::Json;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

geometry::Rings polygon_from(const Json& rings) {
    if (!rings.is_array()) refuse("a polygon is no list of rings");
    geometry::Rings polygon;
    for (const Json& ring : rings) polygon.push_back(ring_from_json(ring));
    return polygon;
}

void add_geometry(const Json& json, geometry::MultiPolygon& shape) {
    const std::string type = strat::json_text(json, "type");
    if (type == "GeometryCollection") {
        const Json* parts = strat::json_member(json, "geometries");
        if (parts == nullptr || !parts->is_array()) refuse("a geometry collection has no list of geometries");
        for (const Json& part : *parts) add_geometry(part, shape);
        return;
    }
    if (type != "Polygon" && type != "MultiPolygon") {
        refuse(fmt::format("a {} is no outline; draw polygons", type.empty() ? "feature without geometry" : type));
    }
    const Json* coordinates = strat::json_member(json, "coordinates");
    if (coordinates == nullptr || !coordinates->is_array()) refuse("it has no coordinates");
    if (type == "Polygon") {
        shape.push_back(polygon_from(*coordinates));
        return;
    }
    for (const Json& polygon : *coordinates) shape.push_back(polygon_from(polygon));
}

class Reader {
  public:
    void feature(const Json& json, const std::string& where) {
        try {
            DrawnOutline outline;
            outline.where = where;
            if (const Json* properties = strat::json_member(json, "properties");
                properties != nullptr && properties->is_object()) {
                for (const auto& [name, value] : properties->items()) {
                    if (!read_outline_property(outline, name, value)) ++unknown_[text::clean_utf8(name).text];
                }
            }
            const Json* geometry = strat::json_member(json, "geometry");
            if (geometry == nullptr || geometry->is_null()) refuse("it has no geometry");
            add_geometry(*geometry, outline.shape);
            file_.outlines.push_back(std::move(outline));
        } catch (const Error& e) {
            file_.notes.push_back({where, e.what()});
        }
    }

    OutlineFile finish() {
        for (const auto& [name, count] : unknown_) {
            file_.notes.push_back({"", fmt::format("property {} was not read ({} times)", name, count)});
        }
        return std::move(file_);
    }

  private:
    OutlineFile file_;
    std::map<std::string, std::size_t> unknown_;
};

// QGIS writes degrees unless told otherwise; they would be taken for metres near the origin.
void refuse_degrees(const Json& json) {
    const Json* crs = strat::json_member(json, "crs");
    if (crs == nullptr) return;
    const Json* properties = strat::json_member(*crs, "properties");
    if (properties == nullptr) return;
    const std::string name = strat::json_text(*properties, "name");
    if (name.find("CRS84") == std::string::npos && name.find("4326") == std::string::npos) return;
    refuse("its coordinates are degrees (" + name + "); export it in the coordinate system of the site grid");
}

} // namespace

OutlineFile read_geojson_outlines(std::string_view bytes) { return geojson_outlines_from(strat::parse_json(bytes)); }

OutlineFile geojson_outlines_from(const Json& json) {
    refuse_degrees(json);
    const std::string type = strat::json_text(json, "type");
    Reader reader;
    if (type == "FeatureCollection") {
        const Json* features = strat::json_member(json, "features");
        if (features == nullptr || !features->is_array()) refuse("the feature collection has no list of features");
        std::size_t n = 0;
        for (const Json& feature : *features) reader.feature(feature, fmt::format("feature {}", ++n));
    } else if (type == "Feature") {
        reader.feature(json, "feature 1");
    } else if (type == "Polygon" || type == "MultiPolygon" || type == "GeometryCollection") {
        reader.feature({{"type", "Feature"}, {"geometry", json}}, "feature 1");
    } else {
        refuse("this is no GeoJSON: its type is none of FeatureCollection, Feature, Polygon, MultiPolygon");
    }
    return reader.finish();
}

} // namespace planum::app
