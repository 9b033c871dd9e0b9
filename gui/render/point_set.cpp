// SPDX-License-Identifier: MIT
#include "gui/render/point_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planum::gui {

namespace {

scans::Frustum frustum_in_scan(const PointQuery& query, const geometry::Rigid3& site_from_scan) {
    scans::Frustum frustum;
    frustum.eye = site_from_scan.inverse() * query.camera.eye();
    std::vector<Eigen::Vector4d> planes = query.cuts;
    if (!query.everywhere) {
        const std::vector<Eigen::Vector4d> seen = query.camera.planes(query.aspect);
        planes.insert(planes.end(), seen.begin(), seen.end());
    }
    for (const Eigen::Vector4d& plane : planes) {
        Eigen::Vector4d turned;
        turned.head<3>() = site_from_scan.rotation.transpose() * plane.head<3>();
        turned.w() = plane.head<3>().dot(site_from_scan.translation) + plane.w();
        frustum.planes.push_back(turned);
    }
    return frustum;
}

void paint(PointVertex& vertex, std::uint32_t rgb, double light) {
    const auto part = [&](unsigned shift) {
        return static_cast<std::uint8_t>(std::clamp(light * static_cast<double>((rgb >> shift) & 0xffU), 0.0, 255.0));
    };
    vertex.red = part(16);
    vertex.green = part(8);
    vertex.blue = part(0);
}

// Reflectances of scanners bunch together near the dark end: the root spreads them.
double light_of(const scans::PointBlock& points, std::size_t i) {
    if (points.intensity.empty()) return 0.75;
    return 0.12 + 0.88 * std::sqrt(static_cast<double>(points.intensity[i]) / 65535.0);
}

PointVertex vertex_of(const scans::PointBlock& points, std::size_t i, const Eigen::Vector3d& x_in_site,
                      const ShownScan& scan, const PointQuery& query) {
    PointVertex vertex;
    const Eigen::Vector3f x = (x_in_site - query.origin).cast<float>();
    vertex.x = x.x();
    vertex.y = x.y();
    vertex.z = x.z();
    switch (query.colour) {
    case PointColour::Intensity: paint(vertex, 0xffffff, light_of(points, i)); break;
    case PointColour::Colour:
        if (points.colour.empty()) {
            paint(vertex, 0xffffff, light_of(points, i));
        } else {
            vertex.red = points.colour[i].red;
            vertex.green = points.colour[i].green;
            vertex.blue = points.colour[i].blue;
        }
        break;
    case PointColour::Height: {
        const double span = std::max(query.height_high - query.height_low, 1e-6);
        paint(vertex, height_colour((x_in_site.z() - query.height_low) / span), 0.55 + 0.45 * light_of(points, i));
        break;
    }
    case PointColour::Unit:
    case PointColour::Difference: {
        const std::uint32_t tint = query.tints == nullptr ? 0 : query.tints->at(x_in_site.x(), x_in_site.y());
        if (tint == 0) {
            paint(vertex, 0xffffff, 0.45 * light_of(points, i));
        } else {
            paint(vertex, tint, 0.35 + 0.8 * light_of(points, i));
        }
        break;
    }
    case PointColour::Day: paint(vertex, scan.tint, 0.35 + 0.8 * light_of(points, i)); break;
    }
    return vertex;
}

} // namespace

std::uint32_t TintGrid::at(double x, double y) const noexcept {
    const double column = std::floor((x - low_x) / cell);
    const double row = std::floor((y - low_y) / cell);
    if (!(column >= 0.0 && row >= 0.0 && column < width && row < height)) return 0;
    return rgb[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
}

std::uint32_t height_colour(double share) noexcept {
    constexpr std::array<std::array<double, 3>, 5> kStops = {
        {{68, 40, 120}, {49, 104, 142}, {53, 160, 132}, {144, 202, 80}, {250, 231, 80}}};
    const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
    const double t = at - static_cast<double>(below);
    std::uint32_t rgb = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = kStops[below][c] * (1.0 - t) + kStops[below + 1][c] * t;
        rgb = rgb << 8U | static_cast<std::uint32_t>(std::lround(value));
    }
    return rgb;
}

PointSet choose_points(const std::vector<ShownScan>& scans, const PointQuery& query, Progress& progress) {
    PointSet set;
    set.origin = query.origin;
    std::uint64_t left = 0;
    for (const ShownScan& scan : scans) left += scan.store->points();
    set.points.reserve(std::min(query.budget, left));
    for (const ShownScan& scan : scans) {
        progress.check();
        // What one scan does not need is there for those after it.
        const std::uint64_t free = query.budget - std::min<std::uint64_t>(query.budget, set.points.size());
        const double part =
            static_cast<double>(scan.store->points()) / static_cast<double>(std::max<std::uint64_t>(left, 1));
        const auto share = static_cast<std::uint64_t>(static_cast<double>(free) * part);
        left -= scan.store->points();
        scan.store->in_frustum(
            frustum_in_scan(query, scan.site_from_scan), share, [&](const scans::FoundPoints& found) {
                progress.check();
                for (std::size_t i = 0; i < found.points.size(); ++i) {
                    const Eigen::Vector3d x_in_site =
                        scan.site_from_scan * Eigen::Vector3d(found.points.x[i], found.points.y[i], found.points.z[i]);
                    set.points.push_back(vertex_of(found.points, i, x_in_site, scan, query));
                }
            });
    }
    return set;
}

SceneCorners corners_of(const std::vector<ShownScan>& scans) {
    if (scans.empty()) return {};
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-1e300);
    for (const ShownScan& scan : scans) {
        const scans::Bounds& box = scan.store->bounds();
        for (unsigned corner = 0; corner < 8; ++corner) {
            Eigen::Vector3d x;
            for (unsigned axis = 0; axis < 3; ++axis) {
                x(axis) = ((corner >> axis) & 1U) != 0 ? box.maximum.at(axis) : box.minimum.at(axis);
            }
            const Eigen::Vector3d x_in_site = scan.site_from_scan * x;
            low = low.cwiseMin(x_in_site);
            high = high.cwiseMax(x_in_site);
        }
    }
    return {low, high};
}

SceneBounds bounds_of(const std::vector<ShownScan>& scans) {
    const SceneCorners corners = corners_of(scans);
    return {(corners.low + corners.high) / 2.0, (corners.high - corners.low).norm() / 2.0};
}

std::optional<Eigen::Vector3d> pick_point(const std::vector<ShownScan>& scans, const SightPart& part, double spread) {
    std::optional<Eigen::Vector3d> best;
    double nearest = part.length;
    for (const ShownScan& scan : scans) {
        const geometry::Rigid3 scan_from_site = scan.site_from_scan.inverse();
        scans::Ray ray;
        ray.origin = scan_from_site * part.sight.from;
        ray.direction = scan_from_site.rotation * part.sight.direction;
        ray.radius = 0.005 + spread * part.begins;
        ray.spread = spread;
        const auto hit = scan.store->pick(ray);
        if (!hit || hit->distance >= nearest) continue;
        nearest = hit->distance;
        best = scan.site_from_scan * hit->x_in_scan;
    }
    return best;
}

} // namespace planum::gui
