// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>

#include "scans/surface/point_source.hpp"

namespace planum::test {

using Ground = std::function<double(double x, double y)>;

/// Points that a scanner high above would see: everywhere over a rectangle, with noise.
struct GroundShot {
    scans::PlanBox box{0.0, 0.0, 2.0, 2.0};
    double per_square_metre = 25000.0;
    double noise = 0.002;
    std::uint32_t seed = 1;
};

class Shots {
  public:
    explicit Shots(std::uint32_t seed) : random_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1.0p-53;
    }

    double normal() {
        const double u = uniform(1e-12, 1.0);
        return std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * uniform(0.0, 1.0));
    }

    void add(double x, double y, double z) {
        block_.x.push_back(x);
        block_.y.push_back(y);
        block_.z.push_back(z);
        block_.validity.push_back(scans::Validity::Valid);
    }

    void add_ground(const GroundShot& shot, const Ground& ground) {
        const double area = (shot.box.east - shot.box.west) * (shot.box.north - shot.box.south);
        const auto count = static_cast<std::size_t>(area * shot.per_square_metre);
        for (std::size_t i = 0; i < count; ++i) {
            const double x = uniform(shot.box.west, shot.box.east);
            const double y = uniform(shot.box.south, shot.box.north);
            add(x, y, ground(x, y) + shot.noise * normal());
        }
    }

    /// The side of an upright cylinder, as a person or a bucket shows it.
    void add_cylinder(double x, double y, double radius, double low, double high, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const double angle = uniform(0.0, 6.283185307179586);
            add(x + radius * std::cos(angle), y + radius * std::sin(angle), uniform(low, high));
        }
        for (std::size_t i = 0; i < count / 4; ++i) {
            const double r = radius * std::sqrt(uniform(0.0, 1.0));
            const double angle = uniform(0.0, 6.283185307179586);
            add(x + r * std::cos(angle), y + r * std::sin(angle), high);
        }
    }

    [[nodiscard]] const scans::PointBlock& block() const { return block_; }

    [[nodiscard]] scans::SurfaceScan scan(const std::string& name) const {
        scans::SurfaceScan scan;
        scan.name = name;
        scan.points = std::make_shared<scans::BlockPoints>(block_);
        scan.station = {0.0, 0.0, 1.7};
        return scan;
    }

  private:
    std::mt19937_64 random_;
    scans::PointBlock block_;
};

inline scans::SurfaceScan shoot(const std::string& name, const GroundShot& shot, const Ground& ground) {
    Shots shots(shot.seed);
    shots.add_ground(shot, ground);
    return shots.scan(name);
}

} // namespace planum::test
