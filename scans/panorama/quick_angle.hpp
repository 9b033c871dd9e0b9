// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planum::scans {

/// atan2 to 3e-14 rad, several times as fast as the library's because compilers can do many at once: without branches,
/// infinities, signed zeros and errno. Both 0: an angle of 0.
[[nodiscard]] inline double quick_atan2(double y, double x) noexcept {
    const double across = std::abs(x);
    const double up = std::abs(y);
    // In this order of the arguments what is no number stays none.
    const double t = std::min(up, across) / (std::max(across, up) + 1e-300);
    const double z = t * t;
    // atan(√z) / √z for z in 0…1, through its values at the 16 Chebyshev points.
    double p = -0.00010950133737292665;
    p = p * z + 0.0009961348991062624;
    p = p * z - 0.0042695010966784085;
    p = p * z + 0.011594726016119614;
    p = p * z - 0.02279206378279654;
    p = p * z + 0.0354478304883713;
    p = p * z - 0.047005235904944216;
    p = p * z + 0.056826465091119466;
    p = p * z - 0.06613494495894422;
    p = p * z + 0.07681984916045911;
    p = p * z - 0.0908950250900279;
    p = p * z + 0.11110983774962185;
    p = p * z - 0.14285707246678706;
    p = p * z + 0.19999999793953496;
    p = p * z - 0.33333333330931053;
    p = p * z + 0.9999999999999531;
    double angle = p * t;
    angle = up > across ? std::numbers::pi / 2.0 - angle : angle;
    angle = x < 0.0 ? std::numbers::pi - angle : angle;
    return y < 0.0 ? -angle : angle;
}

} // namespace planum::scans
