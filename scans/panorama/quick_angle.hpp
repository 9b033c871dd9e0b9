// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// sin to 2e-16 for |x| up to 1.26 rad, for the same reason: its series, the last term of which is below 3e-18 there.
[[nodiscard]] inline double quick_sin(double x) noexcept {
    const double z = x * x;
    double p = 1.0 / 51090942171709440000.0; // 21!
    p = p * z - 1.0 / 121645100408832000.0;
    p = p * z + 1.0 / 355687428096000.0;
    p = p * z - 1.0 / 1307674368000.0;
    p = p * z + 1.0 / 6227020800.0;
    p = p * z - 1.0 / 39916800.0;
    p = p * z + 1.0 / 362880.0;
    p = p * z - 1.0 / 5040.0;
    p = p * z + 1.0 / 120.0;
    p = p * z - 1.0 / 6.0;
    return x + x * (p * z);
}

/// Natural logarithm to 3e-16 (times the larger of 1 and itself) of a positive normal number, for the same reason. What
/// is none gives some number beyond ±708, never less.
[[nodiscard]] inline double quick_log(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    // x = m · 2^e with m from √½ to √2: bits of √½ are taken off before the exponent is read and put back.
    constexpr std::uint64_t kRootHalf = 0x3FE6A09E667F3BCDULL;
    const std::uint64_t shifted = bits - kRootHalf;
    const std::uint64_t mantissa = (shifted & 0x000FFFFFFFFFFFFFULL) + kRootHalf;
    // The exponent as a double without a conversion of 64-bit integers: in the low bits of 2^52, off by the sign.
    const std::uint64_t exponent = ((shifted >> 52U) ^ 0x800ULL) | 0x4330000000000000ULL;
    const double e = std::bit_cast<double>(exponent) - (4503599627370496.0 + 2048.0);
    const double m = std::bit_cast<double>(mantissa);
    // log m = 2 artanh t, by its series; the next term is below 2e-18.
    const double t = (m - 1.0) / (m + 1.0);
    const double z = t * t;
    double p = 1.0 / 21.0;
    p = p * z + 1.0 / 19.0;
    p = p * z + 1.0 / 17.0;
    p = p * z + 1.0 / 15.0;
    p = p * z + 1.0 / 13.0;
    p = p * z + 1.0 / 11.0;
    p = p * z + 1.0 / 9.0;
    p = p * z + 1.0 / 7.0;
    p = p * z + 1.0 / 5.0;
    p = p * z + 1.0 / 3.0;
    return e * std::numbers::ln2 + 2.0 * (t + t * (p * z));
}

} // namespace planum::scans
