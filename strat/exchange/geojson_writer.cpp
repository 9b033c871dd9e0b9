// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/text.hpp"
#include "core/geometry/geographic.hpp"
#include "strat/exchange/map_features.hpp"
#include "strat/exchange/writers.hpp"

namespace planum::strat {

namespace {

using Json = nlohmann::ordered_json;
using Shape = MapFeature::Shape;
using Point = std::array<double, 3>;

// Ring area in plan, positive when it runs against the clock.
double signed_area(const model::Ring& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& a = ring[i];
        const Point& b = ring[(i + 1) % ring.size()];
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return twice / 2.0;
}

class FeatureWriter {
  public:
    explicit FeatureWriter(std::optional<geometry::Geographic> geographic) : geographic_(std::move(geographic)) {}

    /// nullopt when a point of it has no longitude and latitude.
    [[nodiscard]] std::optional<Json> write(const MapFeature& feature) {
        missed_ = false;
        Json out;
        out["type"] = "Feature";
        out["geometry"] = geometry_of(feature);
        out["properties"]["layer"] = feature.layer;
        for (const auto& [name, value] : feature.fields) out["properties"][name] = text::clean_utf8(value).text;
        if (missed_) return std::nullopt;
        return out;
    }

  private:
    [[nodiscard]] Json position(const Point& x_in_site, bool has_height) {
        double x = x_in_site[0];
        double y = x_in_site[1];
        if (geographic_) {
            const auto place = geographic_->longitude_latitude(x, y);
            missed_ = missed_ || !place;
            if (place) x = (*place)[0], y = (*place)[1];
        }
        Json out = Json::array({x, y});
        if (has_height) out.push_back(x_in_site[2]);
        return out;
    }

    // RFC 7946: closed, the outer ring against the clock, holes with it.
    [[nodiscard]] Json ring(const model::Ring& points, bool outer, bool has_height) {
        Json out = Json::array();
        const bool turn = (signed_area(points) > 0.0) != outer;
        for (std::size_t i = 0; i <= points.size() && !points.empty(); ++i) {
            const std::size_t at = i % points.size();
            out.push_back(position(points[turn ? (points.size() - at) % points.size() : at], has_height));
        }
        return out;
    }

    [[nodiscard]] Json polygon(const model::Polygon& shape, bool has_height) {
        Json rings = Json::array({ring(shape.outer, true, has_height)});
        for (const model::Ring& hole : shape.holes) rings.push_back(ring(hole, false, has_height));
        return rings;
    }

    [[nodiscard]] Json geometry_of(const MapFeature& feature) {
        switch (feature.shape) {
        case Shape::Point:
            return {{"type", "Point"}, {"coordinates", position(feature.points.front(), feature.has_height)}};
        case Shape::Line: {
            Json line = Json::array();
            for (const Point& point : feature.points) line.push_back(position(point, feature.has_height));
            return {{"type", "LineString"}, {"coordinates", line}};
        }
        case Shape::Outline: break;
        }
        if (feature.outline.empty()) return nullptr;
        if (feature.outline.size() == 1) {
            return {{"type", "Polygon"}, {"coordinates", polygon(feature.outline.front(), feature.has_height)}};
        }
        Json parts = Json::array();
        for (const model::Polygon& part : feature.outline) parts.push_back(polygon(part, feature.has_height));
        return {{"type", "MultiPolygon"}, {"coordinates", parts}};
    }

    std::optional<geometry::Geographic> geographic_;
    bool missed_ = false;
};

void add_record_losses(const model::Record& record, std::vector<std::string>& lost) {
    add_loss(lost, record.relations.size(), "relations");
    add_loss(lost, record.samples.size(), "samples");
    add_loss(lost, record.documents.size(), "documents");
    add_loss(lost, record.datings.size(), "dates");
}

Written write_features(const model::Record& record, std::optional<geometry::Geographic> geographic) {
    const RecordNames names(record);
    const bool on_site_grid = !geographic;
    FeatureWriter writer(std::move(geographic));
    MapFeatures map = map_features(names);
    Json root;
    root["type"] = "FeatureCollection";
    root["name"] = text::clean_utf8(record.settings.name).text;
    if (on_site_grid && record.settings.srs_id > 0) {
        root["crs"] = {{"type", "name"},
                       {"properties", {{"name", fmt::format("urn:ogc:def:crs:EPSG::{}", record.settings.srs_id)}}}};
    }
    if (on_site_grid && record.settings.srs_id <= 0) root["crs"] = nullptr; // unknown, or readers take it for degrees
    if (on_site_grid) root["coordinates"] = "site grid, metres";
    root["features"] = Json::array();
    std::size_t outside = 0;
    for (const MapFeature& feature : map.features) {
        std::optional<Json> written = writer.write(feature);
        if (written)
            root["features"].push_back(std::move(*written));
        else
            ++outside;
    }
    add_loss(map.lost, outside, "places without longitude and latitude");
    add_record_losses(record, map.lost);
    return {{{"", root.dump(1) + "\n"}}, std::move(map.lost)};
}

} // namespace

Written write_geojson(const model::Record& record, const WriteOptions& /*options*/) {
    auto geographic = record.settings.srs_id > 0 ? geometry::Geographic::of_epsg(record.settings.srs_id) : std::nullopt;
    const bool known = geographic.has_value();
    Written written = write_features(record, std::move(geographic));
    if (!known) {
        written.lost.insert(written.lost.begin(), "longitude and latitude: the project is on a local grid, so the file "
                                                  "holds site coordinates, which RFC 7946 does not know");
    }
    return written;
}

Written write_geojson_site(const model::Record& record, const WriteOptions& /*options*/) {
    return write_features(record, std::nullopt);
}

} // namespace planum::strat
