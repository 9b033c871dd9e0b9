// SPDX-License-Identifier: MIT
#include "tests/unit/scans_registration/synthetic_ground.hpp"

#include <cmath>
#include <random>

namespace planum::test {

namespace {

double height(double x, double y, double dug_depth) {
    const double rolling = 0.08 * std::sin(0.9 * x + 0.4) * std::cos(0.7 * y);
    const bool is_pit = std::abs(x) < 1.5 && std::abs(y) < 1.0;
    return rolling - (is_pit ? 0.5 + dug_depth : 0.0);
}

} // namespace

std::vector<Eigen::Vector3d> synthetic_ground(const geometry::Rigid3& site_from_scan, const GroundOptions& options) {
    std::mt19937_64 random(options.seed);
    std::uniform_real_distribution<double> even(-1.0, 1.0);
    std::normal_distribution<double> noise(0.0, options.sigma);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < options.points; ++i) {
        const double a = even(random);
        const double b = even(random);
        Eigen::Vector3d x(4.0 * a, 3.0 * b, 0.0);
        if (i % 5 == 0) {
            x = {4.0, 3.0 * a, 1.0 + b}; // a wall in the east
        } else if (i % 5 == 1) {
            x = {4.0 * a, 3.0 + 0.05 * a * a, 1.0 + b}; // and a bent one in the north
        }
        if (i % 5 == 0) {
            x.x() += noise(random);
        } else if (i % 5 == 1) {
            x.y() += noise(random);
        } else {
            x.z() = height(x.x(), x.y(), options.dug_depth) + noise(random);
        }
        if (options.is_mirrored) x.x() = -x.x();
        points.push_back(site_from_scan.inverse() * x);
    }
    return points;
}

} // namespace planum::test
