// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <random>

#include "scans/cloud/point_store.hpp"
#include "scans/cloud/store_builder.hpp"

namespace planum::test {

struct CloudOptions {
    std::size_t points = 100000;
    std::uint32_t seed = 1;
    double extent = 20.0; ///< [m] along x and y
    double relief = 1.0;  ///< [m]
    Eigen::Vector3d centre = Eigen::Vector3d(-3.0, 5.0, 1.0);
    double outliers = 0.001; ///< share of points anywhere within 200 m
};

/// A rough surface. Row and column say the number of a point (i % 65536, i / 65536), so that it is known
/// again.
inline scans::PointBlock surface_cloud(const CloudOptions& options = {}) {
    std::mt19937_64 random(options.seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1.0p-53;
    };
    scans::PointBlock cloud;
    cloud.resize(options.points, {true, true, true, false});
    for (std::size_t i = 0; i < options.points; ++i) {
        double x = uniform(-0.5, 0.5) * options.extent;
        double y = uniform(-0.5, 0.5) * options.extent;
        double z = options.relief * (std::sin(x) * std::cos(0.7 * y) + 0.02 * uniform(-1.0, 1.0));
        if (uniform(0.0, 1.0) < options.outliers) {
            x = uniform(-200.0, 200.0);
            y = uniform(-200.0, 200.0);
            z = uniform(-200.0, 200.0);
        }
        cloud.x[i] = options.centre.x() + x;
        cloud.y[i] = options.centre.y() + y;
        cloud.z[i] = options.centre.z() + z;
        cloud.intensity[i] = static_cast<std::uint16_t>(random());
        cloud.colour[i] = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                           static_cast<std::uint8_t>(random())};
        cloud.row[i] = static_cast<std::uint32_t>(i % 65536);
        cloud.column[i] = static_cast<std::uint32_t>(i / 65536);
    }
    return cloud;
}

inline scans::StoreInfo full_info() {
    scans::StoreInfo info;
    info.name = "2025-06-01/station1";
    info.source_sha256 = "0123";
    info.has = {true, true, true, false};
    info.intensity = {0.0, 1.0 / 65535.0};
    info.rows = 65536;
    info.columns = 16;
    info.attributes = {"x", "y", "z", "intensity", "red", "green", "blue", "odd thing"};
    return info;
}

inline scans::StoreSummary store_cloud(const scans::PointBlock& cloud, const std::filesystem::path& file,
                                       const scans::StoreOptions& options = {}) {
    scans::StoreBuilder builder(file, full_info(), options);
    builder.add(cloud);
    return builder.finish(Progress::none());
}

inline std::size_t number_of(const scans::PointBlock& block, std::size_t i) {
    return block.row[i] + std::size_t{65536} * block.column[i];
}

} // namespace planum::test
