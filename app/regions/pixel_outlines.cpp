// SPDX-License-Identifier: MIT
#include "app/regions/pixel_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "app/regions/outline_properties.hpp"
#include "app/scans/list_scans.hpp"
#include "app/scans/scan_stores.hpp"
#include "core/base/error.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::app {

namespace {

using geometry::Line3;
using geometry::MultiPolygon;
using strat::Json;

constexpr double kStep = 6.0;          ///< lines are followed every so many pixels
constexpr int kReach = 3;              ///< a corner may be so many pixels beside what is seen
constexpr double kSimplified = 0.005;  ///< [m]
constexpr double kMostPixels = 200000; ///< of one line; no picture is wider

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::BadInput, message); }

double number_or(const Json& json, const char* key, double otherwise) {
    return strat::json_number(json, key).value_or(otherwise);
}

int pixels_of(const Json& json, const char* key) {
    const double value = number_or(json, key, 0.0);
    if (!(value >= 1.0 && value <= 100000.0) || value != std::floor(value)) {
        refuse(fmt::format("{}: the picture's size in pixels is missing", key));
    }
    return static_cast<int>(value);
}

// The keys that a panorama's own description has.
scans::ProjectionOptions projection_from(const Json& json) {
    constexpr double kRadians = std::numbers::pi / 180.0;
    scans::ProjectionOptions options;
    const std::string name = strat::json_text(json, "projection");
    const auto kind = scans::projection_from_name(name);
    if (!kind) refuse(fmt::format("projection: {} is unknown", name.empty() ? "(missing)" : name));
    options.kind = *kind;
    options.width = pixels_of(json, "width");
    options.height = pixels_of(json, "height");
    options.azimuth_to = kRadians * number_or(json, "azimuth_left_deg", options.azimuth_to / kRadians);
    options.azimuth_from = kRadians * number_or(json, "azimuth_right_deg", options.azimuth_from / kRadians);
    options.elevation_to = kRadians * number_or(json, "elevation_top_deg", options.elevation_to / kRadians);
    options.elevation_from = kRadians * number_or(json, "elevation_bottom_deg", options.elevation_from / kRadians);
    options.views = static_cast<int>(std::clamp(number_or(json, "views", options.views), 1.0, 1000.0));
    options.distance = number_or(json, "pannini_distance", options.distance);
    return options;
}

MultiPolygon shape_from(const Json& json) {
    const auto polygon = [](const Json& rings) {
        if (!rings.is_array()) refuse("rings: it is no list of rings");
        geometry::Rings shape;
        for (const Json& ring : rings) {
            shape.push_back(ring_from_json(ring));
            for (auto& pixel : shape.back()) pixel[2] = 0.0; // pixels have none
        }
        return shape;
    };
    MultiPolygon shape;
    if (const Json* rings = strat::json_member(json, "rings")) shape.push_back(polygon(*rings));
    if (const Json* parts = strat::json_member(json, "parts"); parts != nullptr && parts->is_array()) {
        for (const Json& part : *parts) shape.push_back(polygon(part));
    }
    if (shape.empty()) refuse("it has neither rings nor parts");
    return shape;
}

PixelPicture picture_from(const Json& json) {
    PixelPicture picture;
    picture.scan = strat::json_text(json, "scan");
    if (picture.scan.empty()) refuse("a picture names no scan");
    picture.projection = projection_from(json);
    const Json* polygons = strat::json_member(json, "polygons");
    if (polygons == nullptr || !polygons->is_array())
        refuse("picture of " + picture.scan + ": it has no list of polygons");
    std::size_t n = 0;
    for (const Json& polygon : *polygons) {
        DrawnOutline outline;
        outline.where = fmt::format("{}, polygon {}", picture.scan, ++n);
        outline.drawn_on = "panorama";
        try {
            if (!polygon.is_object()) refuse("it is no object");
            for (const auto& [name, value] : polygon.items()) {
                if (name != "rings" && name != "parts") read_outline_property(outline, name, value);
            }
            outline.shape = shape_from(polygon);
            picture.outlines.push_back(std::move(outline));
        } catch (const Error& e) {
            picture.notes.push_back({outline.where, e.what()});
        }
    }
    return picture;
}

// Follows one ring over the ground that its pixels show.
class Follower {
  public:
    Follower(const scans::Panorama& panorama, const geometry::Rigid3& site_from_scan)
        : panorama_(panorama), site_from_scan_(site_from_scan) {}

    [[nodiscard]] Line3 follow(const Line3& ring) const {
        Line3 ground;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Line3 line = piece(ring[i], ring[(i + 1) % ring.size()]);
            ground.insert(ground.end(), line.begin(), line.end() - 1);
        }
        return ground;
    }

    [[nodiscard]] Line3 piece(const geometry::Point3& a, const geometry::Point3& b) const {
        Line3 line = {corner(a)};
        const double pixels = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (!(pixels <= kMostPixels)) refuse("a line is longer than any picture");
        const int steps = std::max(1, static_cast<int>(std::ceil(pixels / kStep)));
        for (int step = 1; step < steps; ++step) {
            const double share = static_cast<double>(step) / steps;
            const auto place = seen(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]));
            if (place) line.push_back(*place);
        }
        line.push_back(corner(b));
        return geometry::simplified(line, kSimplified);
    }

  private:
    [[nodiscard]] std::optional<geometry::Point3> seen(double u, double v) const {
        const bool inside = u >= 0.0 && v >= 0.0 && u < panorama_.width() && v < panorama_.height();
        if (!inside) return std::nullopt;
        const auto x_in_scan = panorama_.surface_at({u, v});
        if (!x_in_scan) return std::nullopt;
        const Eigen::Vector3d x = site_from_scan_ * *x_in_scan;
        return geometry::Point3{x.x(), x.y(), x.z()};
    }

    [[nodiscard]] geometry::Point3 corner(const geometry::Point3& pixel) const {
        if (const auto place = seen(pixel[0], pixel[1])) return *place;
        std::optional<geometry::Point3> nearest;
        int best = kReach * kReach + 1;
        for (int dv = -kReach; dv <= kReach; ++dv) {
            for (int du = -kReach; du <= kReach; ++du) {
                const int distance = du * du + dv * dv;
                if (distance >= best) continue;
                if (const auto place = seen(pixel[0] + du, pixel[1] + dv)) {
                    nearest = place;
                    best = distance;
                }
            }
        }
        if (!nearest) refuse(fmt::format("the corner at pixel {:.0f} {:.0f} shows nothing", pixel[0], pixel[1]));
        return *nearest;
    }

    const scans::Panorama& panorama_;
    const geometry::Rigid3& site_from_scan_;
};

scans::Panorama panorama_of(const PlacedScan& placed, const scans::ProjectionOptions& projection, Progress& progress) {
    scans::PanoramaOptions options;
    options.projection = projection;
    scans::PanoramaBuilder builder(options, {});
    builder.expect(placed.store->points());
    placed.store->for_each([&](const scans::FoundPoints& found) { builder.add(found.points); }, progress);
    return builder.finish(progress);
}

void take_picture(const PlacedScan& placed, const PixelPicture& picture, OutlineFile& file, Progress& progress) {
    const scans::Panorama panorama = panorama_of(placed, picture.projection, progress);
    for (DrawnOutline outline : picture.outlines) {
        try {
            outline.shape = outline_under_pixels(panorama, placed.site_from_scan, outline.shape);
            outline.on_surface = placed.scan.surface;
            if (outline.day.empty()) outline.day = placed.scan.day;
            file.outlines.push_back(std::move(outline));
        } catch (const Error& e) {
            if (e.code() != ErrorCode::BadInput) throw;
            file.notes.push_back({outline.where, e.what()});
        }
    }
}

} // namespace

bool is_pixel_outlines(const Json& json) {
    return strat::json_member(json, "pictures") != nullptr || strat::json_member(json, "polygons") != nullptr;
}

std::vector<PixelPicture> read_pixel_outlines(std::string_view bytes) {
    return pixel_outlines_from(strat::parse_json(bytes));
}

std::vector<PixelPicture> pixel_outlines_from(const Json& json) {
    const Json* pictures = strat::json_member(json, "pictures");
    if (pictures == nullptr) return {picture_from(json)};
    if (!pictures->is_array()) refuse("pictures: it is no list");
    std::vector<PixelPicture> read;
    for (const Json& picture : *pictures) read.push_back(picture_from(picture));
    return read;
}

MultiPolygon outline_under_pixels(const scans::Panorama& panorama, const geometry::Rigid3& site_from_scan,
                                  const MultiPolygon& in_pixels) {
    const Follower follower(panorama, site_from_scan);
    MultiPolygon shape;
    for (const geometry::Rings& rings : in_pixels) {
        geometry::Rings ground;
        for (const Line3& ring : rings) {
            if (ring.size() < 3) refuse("it has no area: fewer than three corners");
            ground.push_back(follower.follow(ring));
        }
        shape.push_back(std::move(ground));
    }
    return shape;
}

Line3 line_under_pixels(const scans::Panorama& panorama, const geometry::Rigid3& site_from_scan,
                        const geometry::Point3& from, const geometry::Point3& to) {
    return Follower(panorama, site_from_scan).piece(from, to);
}

OutlineFile outlines_from_pixels(Project& project, const std::vector<PixelPicture>& pictures, Progress& progress) {
    OutlineFile file;
    for (const PixelPicture& picture : pictures) {
        file.notes.insert(file.notes.end(), picture.notes.begin(), picture.notes.end());
        const model::Scan scan = scan_named(project, picture.scan);
        progress.step("unrolling " + scan.name);
        const auto placed = placed_scans(
            project, [&](const model::Scan& other) { return other.id == scan.id; }, progress);
        if (placed.empty()) {
            file.notes.push_back({scan.name, fmt::format("it is not registered, so its {} outlines have no place yet; "
                                                         "register it and import again",
                                                         picture.outlines.size())});
            continue;
        }
        take_picture(placed.front(), picture, file, progress);
    }
    return file;
}

} // namespace planum::app
