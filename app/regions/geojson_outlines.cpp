// SPDX-License-Identifier: MIT
#include "app/regions/geojson_outlines.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "app/records/field_table.hpp"
#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "strat/exchange/json_support.hpp"

namespace planum::app {

namespace {

using strat::Json;

constexpr double kNoHeight = 0.0;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

geometry::Line3 ring_from(const Json& points) {
    if (!points.is_array()) refuse("a ring is no list of points");
    geometry::Line3 ring;
    for (const Json& point : points) {
        if (!point.is_array() || point.size() < 2 || point.size() > 4) refuse("a point is not [x, y] or [x, y, z]");
        geometry::Point3 p = {0.0, 0.0, kNoHeight};
        for (std::size_t i = 0; i < std::min<std::size_t>(point.size(), 3); ++i) {
            if (!point[i].is_number()) refuse("a coordinate is no number");
            p[i] = point[i].get<double>();
        }
        ring.push_back(p);
    }
    if (ring.size() > 1 && ring.front()[0] == ring.back()[0] && ring.front()[1] == ring.back()[1]) ring.pop_back();
    return ring;
}

geometry::Rings polygon_from(const Json& rings) {
    if (!rings.is_array()) refuse("a polygon is no list of rings");
    geometry::Rings polygon;
    for (const Json& ring : rings) polygon.push_back(ring_from(ring));
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

// Property names as people write them: case, blanks, hyphens and underscores do not matter.
std::string key_of(std::string_view name) {
    std::string key = text::fold_case(name);
    std::erase_if(key, [](char c) { return c == ' ' || c == '_' || c == '-'; });
    return key;
}

void read_category(DrawnOutline& outline, const std::string& word) {
    if (word.empty()) return;
    if (const auto category = model::region_category_from_word(text::fold_case(word))) {
        outline.category = *category;
    } else if (const auto kind = model::kind_from_any_word(word)) {
        outline.kind = *kind;
    } else {
        refuse(
            fmt::format("category {} is neither unit, spoil, slump, backfill, water, equipment, baulk, unexcavated nor "
                        "a kind of unit",
                        word));
    }
}

std::array<double, 2> place_from(const Json& value) {
    if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number()) {
        refuse("section: from and to are [x, y] in site coordinates");
    }
    return {value[0].get<double>(), value[1].get<double>()};
}

SectionWish section_from(const Json& value) {
    SectionWish wish;
    wish.name = value.is_object() ? strat::json_text(value, "name") : strat::json_scalar_text(value);
    if (wish.name.empty()) refuse("section: it has no name");
    const Json* from = strat::json_member(value, "from");
    const Json* to = strat::json_member(value, "to");
    if (from != nullptr && to != nullptr) wish.line = {place_from(*from), place_from(*to)};
    return wish;
}

// Tables of some programs keep whole numbers as 1017.0.
std::string word_of(const Json& value) {
    const std::string word = strat::json_scalar_text(value);
    return value.is_number_float() && word.ends_with(".0") ? word.substr(0, word.size() - 2) : word;
}

// One property into the outline; false when nobody knows it.
bool read_property(DrawnOutline& outline, const std::string& key, const Json& value) {
    const std::string word = word_of(value);
    const std::string trimmed{text::trim(word)};
    if (key == "unit")
        outline.unit = trimmed;
    else if (key == "area")
        outline.area = trimmed;
    else if (key == "day")
        outline.day = date_from("day", trimmed);
    else if (key == "surface")
        outline.surface = trimmed;
    else if (key == "category")
        read_category(outline, trimmed);
    else if (key == "notes")
        outline.notes = word;
    else if (key == "seenin")
        outline.seen_in = trimmed;
    else if (key == "drawnon")
        outline.drawn_on = trimmed.empty() ? outline.drawn_on : trimmed;
    else if (key == "onplane")
        outline.on_plane = trimmed == "true";
    else if (key == "section") {
        if (!value.is_null()) outline.section = section_from(value);
    } else if (key == "sigma") {
        outline.sigma = number_from("sigma", trimmed);
    } else if (key == "shows") {
        if (trimmed.empty()) return true;
        outline.shows = model::region_shows_from_word(text::fold_case(trimmed));
        if (!outline.shows)
            refuse("shows: " + trimmed + " is none of top, level, cut, overdug, machine, face, nothing");
    } else {
        return false;
    }
    return true;
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
                    if (!read_property(outline, key_of(name), value)) ++unknown_[text::clean_utf8(name).text];
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

OutlineFile read_geojson_outlines(std::string_view bytes) {
    const Json json = strat::parse_json(bytes);
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
