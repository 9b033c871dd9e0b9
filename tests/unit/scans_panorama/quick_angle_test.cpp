// SPDX-License-Identifier: MIT
#include "scans/panorama/quick_angle.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/catch.hpp"

using namespace planum::scans;

TEST_CASE("The quick angle is that of the library in every direction and at every length") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    double worst = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const double length = std::pow(10.0, 8.0 * part(random));
        // Half of them close to an axis or a diagonal, where the pieces of the function meet.
        const double x = i % 2 == 0 ? part(random) : std::round(part(random) * 2.0) + 1e-9 * part(random);
        const double y = i % 2 == 0 ? part(random) : std::round(part(random) * 2.0) + 1e-9 * part(random);
        worst = std::max(worst, std::abs(quick_atan2(length * y, length * x) - std::atan2(length * y, length * x)));
    }
    CHECK(worst < 1e-13);
}

TEST_CASE("The quick angle knows the axes, and no direction at all") {
    const double pi = std::numbers::pi;
    CHECK(quick_atan2(0.0, 0.0) == 0.0);
    CHECK(quick_atan2(0.0, 2.0) == 0.0);
    CHECK(quick_atan2(0.0, -2.0) == pi);
    CHECK(quick_atan2(3.0, 0.0) == Approx(pi / 2.0).epsilon(1e-15));
    CHECK(quick_atan2(-3.0, 0.0) == Approx(-pi / 2.0).epsilon(1e-15));
    CHECK(quick_atan2(1e-200, 1e-200) == Approx(pi / 4.0).epsilon(1e-13));
}

TEST_CASE("The quick sine and logarithm are those of the library") {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    double worst_sine = 0.0;
    double worst_log = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const double angle = 1.2567 * part(random);
        worst_sine = std::max(worst_sine, std::abs(quick_sin(angle) - std::sin(angle)));
        // Half of them close to 1, where a logarithm loses what its argument lost.
        const double x = i % 2 == 0 ? std::pow(10.0, 200.0 * part(random)) : 1.0 + 0.5 * part(random);
        worst_log = std::max(worst_log, std::abs(quick_log(x) - std::log(x)) / std::max(1.0, std::abs(std::log(x))));
    }
    CHECK(worst_sine < 1e-15);
    CHECK(worst_log < 1e-15);
    CHECK(quick_log(1.0) == 0.0);
    for (const double root : {std::numbers::sqrt2, 1.0 / std::numbers::sqrt2}) {
        CHECK(quick_log(std::nextafter(root, 0.0)) == Approx(std::log(root)).epsilon(1e-14));
        CHECK(quick_log(std::nextafter(root, 2.0)) == Approx(std::log(root)).epsilon(1e-14));
    }
}
