// SPDX-License-Identifier: MIT
#include "tests/unit/scans_registration/textured_room.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace planum::test {

namespace {

std::uint32_t mixed(std::uint32_t a) {
    a ^= a >> 16U;
    a *= 0x7feb352dU;
    a ^= a >> 15U;
    a *= 0x846ca68bU;
    return a ^ (a >> 16U);
}

/// Grey of a place: cells of 1.2, 0.5 and 0.2 m, each with a shade of its own.
double shade(const Eigen::Vector3d& x, unsigned pattern) {
    double sum = 0.0;
    for (const double cell : {1.2, 0.5, 0.2}) {
        std::uint32_t key = mixed(pattern + static_cast<std::uint32_t>(cell * 10.0));
        for (int k = 0; k < 3; ++k) {
            key = mixed(key ^ static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(x[k] / cell + 0.01))));
        }
        sum += static_cast<double>(key % 1000U) / 3000.0;
    }
    return sum;
}

/// Distance to the walls from inside.
double distance_to_walls(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
    const Eigen::Vector3d low(-6.0, -4.5, 0.0);
    const Eigen::Vector3d high(6.0, 4.5, 5.0);
    double least = 1e9;
    for (int k = 0; k < 3; ++k) {
        if (ray[k] == 0.0) continue;
        least = std::min(least, ((ray[k] > 0.0 ? high[k] : low[k]) - from[k]) / ray[k]);
    }
    return least;
}

} // namespace

scans::PointBlock textured_room(const geometry::Rigid3& site_from_scan, const RoomOptions& options) {
    std::mt19937_64 random(options.pattern);
    std::normal_distribution<double> normal(0.0, options.sigma);
    scans::PointBlock block;
    block.resize(static_cast<std::size_t>(options.columns * options.rows), {true, false, false, false});
    std::size_t i = 0;
    for (int column = 0; column < options.columns; ++column) {
        for (int row = 0; row < options.rows; ++row, ++i) {
            const double azimuth = 2.0 * std::numbers::pi * column / options.columns;
            const double elevation = -1.0 + 1.5 * row / options.rows;
            Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
            const Eigen::Vector3d in_site = site_from_scan.rotation * ray;
            const double range = distance_to_walls(site_from_scan.translation, in_site);
            const double grey = shade(site_from_scan.translation + range * in_site, options.pattern);
            if (options.is_mirrored) ray.x() = -ray.x();
            const Eigen::Vector3d x = ray * (range + normal(random));
            block.x[i] = x.x();
            block.y[i] = x.y();
            block.z[i] = x.z();
            block.intensity[i] = static_cast<std::uint16_t>(60000.0 * grey);
            block.validity[i] = scans::Validity::Valid;
        }
    }
    return block;
}

scans::Panorama room_panorama(const geometry::Rigid3& site_from_scan, const RoomOptions& options) {
    scans::PanoramaOptions panorama;
    panorama.projection.width = options.columns;
    panorama.projection.height = 240;
    panorama.projection.elevation_from = -1.0;
    panorama.projection.elevation_to = 0.5;
    scans::PanoramaBuilder builder(panorama, {true, false, false, false});
    builder.add(textured_room(site_from_scan, options));
    return builder.finish(Progress::none());
}

} // namespace planum::test
