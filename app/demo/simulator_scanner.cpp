// SPDX-License-Identifier: MIT
#include "app/demo/simulator_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "app/demo/dig_parallel.hpp"
#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

constexpr double kLowest = -60.0 * std::numbers::pi / 180.0; ///< of the beam, below the horizon
constexpr double kHighest = 30.0 * std::numbers::pi / 180.0;
constexpr double kRangeNoise = 0.002;  ///< σ [m]
constexpr double kMarkerNoise = 0.001; ///< σ per coordinate [m]
constexpr double kReach = 60.0;        ///< [m]
constexpr double kMixedShare = 0.015;  ///< of the returns

constexpr int kGround = -1;
constexpr int kNothing = -2;

struct Hit {
    double range = 0.0;
    int what = kNothing; ///< index of the solid, kGround or kNothing
};

// What can be in the way of one column of beams, which all have nearly one azimuth.
std::vector<int> solids_along(const std::vector<Solid>& solids, const Vec3& from, double azimuth) {
    std::vector<int> near;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const Solid& solid = solids[i];
        const double radius = solid.type == Solid::Type::Box ? std::hypot(solid.half.x, solid.half.y)
                                                             : std::max(solid.half.x, solid.half.y);
        const double dx = solid.centre.x - from.x;
        const double dy = solid.centre.y - from.y;
        const double far = std::hypot(dx, dy);
        const double off = std::abs(std::remainder(std::atan2(dy, dx) - azimuth, 2.0 * std::numbers::pi));
        // Half a degree of tilt moves a steep beam by up to a degree.
        if (far < radius * 1.5 || off < std::asin(std::min(1.0, radius / far)) + 0.03)
            near.push_back(static_cast<int>(i));
    }
    return near;
}

Hit trace(const Surroundings& around, const std::vector<Solid>& solids, const std::vector<int>& near, const Vec3& from,
          const Vec3& direction, std::uint64_t key) {
    Hit hit;
    if (const double t = around.ground_hit(from, direction); t > 0.0) hit = {t, kGround};
    for (const int i : near) {
        const Solid& solid = solids[static_cast<std::size_t>(i)];
        auto t = solid.hit(from, direction);
        if (!t || *t > kReach) continue;
        if (solid.look == Solid::Look::Leaves) {
            // Foliage: many beams pass, the others end somewhere inside.
            const std::uint64_t leaf = mix(key, static_cast<std::uint64_t>(i) + 71);
            if (unit_of(leaf) < 0.45) continue;
            *t += 0.8 * solid.half.x * unit_of(mix(leaf, 1));
        }
        if (hit.what == kNothing || *t < hit.range) hit = {*t, i};
    }
    return hit;
}

struct Geometry {
    std::vector<Hit> hits;
    int columns;
    int rows;

    [[nodiscard]] const Hit& at(int column, int row) const {
        const int wrapped = (column + columns) % columns;
        return hits[static_cast<std::size_t>(wrapped) * static_cast<std::size_t>(rows) +
                    static_cast<std::size_t>(std::clamp(row, 0, rows - 1))];
    }
};

// How far a beam's range leaves the line through its neighbours, for a plane of any slope 0 [m].
double jump(const Geometry& g, int column, int row, int dc, int dr) {
    const Hit& a = g.at(column - dc, row - dr);
    const Hit& b = g.at(column, row);
    const Hit& c = g.at(column + dc, row + dr);
    if (a.what == kNothing || c.what == kNothing) return 0.0;
    return std::abs(1.0 / a.range - 2.0 / b.range + 1.0 / c.range) * b.range * b.range;
}

bool at_edge(const Geometry& g, int column, int row) {
    return jump(g, column, row, 1, 0) > 0.08 || jump(g, column, row, 0, 1) > 0.08;
}

// The farthest neighbour that returned: what the other half of the beam hit.
double other_range(const Geometry& g, int column, int row) {
    const double here = g.at(column, row).range;
    double other = here;
    for (const auto& [dc, dr] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
        const Hit& hit = g.at(column + dc, row + dr);
        if (hit.what != kNothing && std::abs(hit.range - here) > std::abs(other - here)) other = hit.range;
    }
    return other;
}

// Cosine between beam and surface normal, from the neighbours in the grid.
double incidence(const ScanImage& image, const Geometry& g, int column, int row) {
    const auto point = [&](int c, int r) {
        const Hit& hit = g.at(c, r);
        return (hit.what == kNothing ? g.at(column, row).range : hit.range) *
               image.direction_in_scan((c + g.columns) % g.columns, std::clamp(r, 0, g.rows - 1));
    };
    const Vec3 across = point(column + 1, row) - point(column - 1, row);
    const Vec3 along = point(column, row + 1) - point(column, row - 1);
    const Vec3 normal{across.y * along.z - across.z * along.y, across.z * along.x - across.x * along.z,
                      across.x * along.y - across.y * along.x};
    const double length = std::sqrt(dot(normal, normal));
    if (length < 1e-12) return 0.5;
    return std::abs(dot(normal, image.direction_in_scan(column, row))) / length;
}

double intensity_of(double look, double range, double cosine, std::uint64_t key) {
    const double falloff = 1.0 / (1.0 + (range / 30.0) * (range / 30.0));
    const double value = look * (0.45 + 0.55 * cosine) * falloff + 0.008 * normal_of(mix(key, 31));
    return std::clamp(value, 0.005, 0.995);
}

ScannerPose set_up(const Vec3& origin, Draw& draw) {
    const double yaw = draw.between(0.0, 2.0 * std::numbers::pi);
    const double tilt = draw.between(0.0, 0.5) * std::numbers::pi / 180.0;
    const double towards = draw.between(0.0, 2.0 * std::numbers::pi);
    // Rodrigues' formula for the tilt about a level axis, after the heading about the plumb line.
    const double ax = std::cos(towards);
    const double ay = std::sin(towards);
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    const std::array<double, 9> lean = {c + ax * ax * (1 - c),
                                        ax * ay * (1 - c),
                                        ay * s,
                                        ax * ay * (1 - c),
                                        c + ay * ay * (1 - c),
                                        -ax * s,
                                        -ay * s,
                                        ax * s,
                                        c};
    const std::array<double, 9> heading = {std::cos(yaw), -std::sin(yaw), 0, std::sin(yaw), std::cos(yaw), 0, 0, 0, 1};
    ScannerPose pose;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            pose.rotation[i * 3 + j] =
                lean[i * 3] * heading[j] + lean[i * 3 + 1] * heading[3 + j] + lean[i * 3 + 2] * heading[6 + j];
        }
    }
    pose.origin = origin;
    return pose;
}

} // namespace

Vec3 ScannerPose::turn(const Vec3& d) const noexcept {
    const auto& r = rotation;
    return {r[0] * d.x + r[1] * d.y + r[2] * d.z, r[3] * d.x + r[4] * d.y + r[5] * d.z,
            r[6] * d.x + r[7] * d.y + r[8] * d.z};
}

Vec3 ScannerPose::to_site(const Vec3& x_in_scan) const noexcept { return turn(x_in_scan) + origin; }

Vec3 ScannerPose::to_scan(const Vec3& x_in_site) const noexcept {
    const Vec3 d = x_in_site - origin;
    const auto& r = rotation;
    return {r[0] * d.x + r[3] * d.y + r[6] * d.z, r[1] * d.x + r[4] * d.y + r[7] * d.z,
            r[2] * d.x + r[5] * d.y + r[8] * d.z};
}

Vec3 ScanImage::direction_in_scan(int column, int row) const noexcept {
    const double azimuth = 2.0 * std::numbers::pi * column / columns;
    const double elevation = kLowest + (kHighest - kLowest) * row / (rows - 1);
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

std::vector<Station> stations_of(const DigPlan& plan, SurfaceNo surface) {
    std::vector<Station> stations;
    const Bounds& t = plan.site.trench;
    const double cx = 0.5 * (t.low.x + t.high.x);
    const double cy = 0.5 * (t.low.y + t.high.y);
    const double rx = 0.5 * (t.high.x - t.low.x) + 0.7;
    const double ry = 0.5 * (t.high.y - t.low.y) + 0.7;
    const std::uint64_t day_key = mix(mix(plan.seed, 650), static_cast<std::uint64_t>(surface));
    Draw draw(day_key, 1);
    const double turn = draw.between(-0.15, 0.15);
    for (int i = 0; i < plan.site.stations; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / plan.site.stations + 0.6 + turn + draw.between(-0.1, 0.1);
        // On the rim: the point of a rectangle in that direction.
        const double scale = 1.0 / std::max(std::abs(std::cos(angle)) / rx, std::abs(std::sin(angle)) / ry);
        const double x = cx + scale * std::cos(angle);
        const double y = cy + scale * std::sin(angle);
        Station station;
        station.surface = surface;
        station.number = i + 1;
        station.name = fmt::format("{}/station{}", plan.days[static_cast<std::size_t>(surface)], i + 1);
        station.key = mix(day_key, static_cast<std::uint64_t>(100 + i));
        station.pose = set_up({x, y, turf_height(plan.site, plan.seed, x, y) + draw.between(1.6, 1.8)}, draw);
        stations.push_back(std::move(station));
    }
    return stations;
}

ScanImage scan(const Surroundings& around, const SiteShape& site, const Station& station, Progress& progress) {
    ScanImage image;
    image.columns = site.scan_columns;
    image.rows = site.scan_rows;
    std::vector<Solid> solids = around.scene().standing;
    const std::vector<Solid> people = passers_by(site, around.scene(), mix(station.key, 2));
    image.people = !people.empty();
    solids.insert(solids.end(), people.begin(), people.end());
    const auto rows = static_cast<std::size_t>(image.rows);
    Geometry geometry{std::vector<Hit>(static_cast<std::size_t>(image.columns) * rows), image.columns, image.rows};
    const Vec3 from = station.pose.origin;
    for_each_index(static_cast<std::size_t>(image.columns), progress, [&](std::size_t column) {
        const Vec3 level = station.pose.turn(image.direction_in_scan(static_cast<int>(column), image.rows * 2 / 3));
        const std::vector<int> near = solids_along(solids, from, std::atan2(level.y, level.x));
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t i = column * rows + row;
            const Vec3 direction =
                station.pose.turn(image.direction_in_scan(static_cast<int>(column), static_cast<int>(row)));
            geometry.hits[i] = trace(around, solids, near, from, direction, mix(station.key, i));
        }
    });
    std::vector<std::uint8_t> edges(geometry.hits.size(), 0);
    std::int64_t edge_count = 0;
    for (int column = 0; column < image.columns; ++column) {
        for (int row = 1; row + 1 < image.rows; ++row) {
            if (geometry.at(column, row).what == kNothing || !at_edge(geometry, column, row)) continue;
            edges[static_cast<std::size_t>(column) * rows + static_cast<std::size_t>(row)] = 1;
            ++edge_count;
        }
    }
    for (const Hit& hit : geometry.hits) image.count += hit.what != kNothing ? 1 : 0;
    const double mixing = std::clamp(kMixedShare * static_cast<double>(image.count) /
                                         static_cast<double>(std::max<std::int64_t>(edge_count, 1)),
                                     0.25, 1.0);
    image.returns.resize(geometry.hits.size());
    for_each_index(static_cast<std::size_t>(image.columns), progress, [&](std::size_t column) {
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t i = column * rows + row;
            const Hit& hit = geometry.hits[i];
            if (hit.what == kNothing) continue;
            const std::uint64_t key = mix(mix(station.key, 3), i);
            Return& back = image.returns[i];
            const Vec3 p = from + hit.range * station.pose.turn(image.direction_in_scan(static_cast<int>(column),
                                                                                        static_cast<int>(row)));
            const double look =
                hit.what == kGround ? around.ground_look(p) : solids[static_cast<std::size_t>(hit.what)].look_at(p);
            const double cosine = incidence(image, geometry, static_cast<int>(column), static_cast<int>(row));
            back.true_range = static_cast<float>(hit.range);
            back.intensity = static_cast<float>(intensity_of(look, hit.range, cosine, key));
            double range = hit.range;
            if (edges[i] != 0 && unit_of(mix(key, 11)) < mixing) {
                const double share = 0.1 + 0.8 * unit_of(mix(key, 12));
                range += share * (other_range(geometry, static_cast<int>(column), static_cast<int>(row)) - range);
                back.mixed = true;
            }
            back.range = static_cast<float>(range + kRangeNoise * normal_of(mix(key, 13)));
        }
    });
    image.mixed = std::count_if(image.returns.begin(), image.returns.end(), [](const Return& r) { return r.mixed; });
    return image;
}

std::vector<MeasuredMarker> measure_markers(const Surroundings& around, const Station& station) {
    constexpr double kNear = 4.0;
    constexpr double kFar = 14.0;
    std::vector<MeasuredMarker> measured;
    const auto visible = [&](const Vec3& target, double distance) {
        const Vec3 direction = (1.0 / distance) * (target - station.pose.origin);
        const double ground = around.ground_hit(station.pose.origin, direction);
        if (ground > 0.0 && ground < distance - 0.1) return false;
        return std::none_of(around.scene().standing.begin(), around.scene().standing.end(), [&](const Solid& solid) {
            const auto t = solid.hit(station.pose.origin, direction);
            return t && *t < distance - 0.1;
        });
    };
    for (const bool only_visible : {true, false}) {
        measured.clear();
        for (std::size_t i = 0; i < around.scene().markers.size(); ++i) {
            const Marker& marker = around.scene().markers[i];
            const Vec3 d = marker.x_in_site - station.pose.origin;
            const double distance = std::sqrt(dot(d, d));
            if (distance < kNear || distance > kFar || (only_visible && !visible(marker.x_in_site, distance))) continue;
            const Vec3 x = station.pose.to_scan(marker.x_in_site);
            const std::uint64_t key = mix(mix(station.key, 4), i);
            measured.push_back(
                {marker.name,
                 {x.x + kMarkerNoise * normal_of(mix(key, 1)), x.y + kMarkerNoise * normal_of(mix(key, 2)),
                  x.z + kMarkerNoise * normal_of(mix(key, 3))}});
        }
        if (measured.size() >= 5) break;
    }
    return measured;
}

} // namespace planum::app::demo
