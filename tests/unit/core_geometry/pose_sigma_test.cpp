// SPDX-License-Identifier: MIT
#include "core/geometry/pose_sigma.hpp"

#include "tests/support/catch.hpp"

using namespace planum;

TEST_CASE("The worst direction of a pose is found even between the axes") {
    std::array<double, 36> covariance{};
    const auto at = [&](std::size_t row, std::size_t column) -> double& { return covariance[row * 6 + column]; };
    // Rotation: 1, 2, 3 mrad about the axes. Translation: 5 mm along (1, 1, 0) / root 2 and nothing across it.
    for (std::size_t i = 0; i < 3; ++i) at(i, i) = 1e-6 * static_cast<double>((i + 1) * (i + 1));
    at(3, 3) = at(4, 4) = at(3, 4) = at(4, 3) = 0.5 * 25e-6;
    const geometry::PoseSigma sigma = geometry::worst_sigma(covariance);
    CHECK(sigma.rotation == Approx(3e-3).epsilon(1e-12));
    CHECK(sigma.position == Approx(5e-3).epsilon(1e-12));
    CHECK(geometry::worst_sigma({}).position == 0.0);
}
