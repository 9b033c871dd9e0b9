// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace planum::app::demo {

/// The finisher of SplitMix64 (Steele, Lea and Flood 2014): every bit of the result depends on every bit of `x`.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) noexcept {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31U);
}

[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t a, std::uint64_t b) noexcept { return mix(mix(a) ^ b); }

/// A number in [0, 1) from a key.
[[nodiscard]] constexpr double unit_of(std::uint64_t key) noexcept {
    return static_cast<double>(mix(key) >> 11U) * 0x1.0p-53;
}

/// A standard normal number from a key (Box and Muller).
[[nodiscard]] inline double normal_of(std::uint64_t key) noexcept {
    const double u = 1.0 - unit_of(key);
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * unit_of(mix(key, 1)));
}

/// Random numbers by counting: the n-th depends on seed, stream and n only, so that threads may share the
/// work in any way.
class Draw {
  public:
    Draw(std::uint64_t seed, std::uint64_t stream) noexcept : key_(mix(seed, stream)) {}

    [[nodiscard]] std::uint64_t next() noexcept { return mix(key_, ++count_); }

    [[nodiscard]] double unit() noexcept { return unit_of(next()); }

    [[nodiscard]] double between(double low, double high) noexcept { return low + (high - low) * unit(); }

    [[nodiscard]] int below(int n) noexcept { return static_cast<int>(unit() * n); }

    [[nodiscard]] bool chance(double probability) noexcept { return unit() < probability; }

    [[nodiscard]] double normal() noexcept { return normal_of(next()); }

  private:
    std::uint64_t key_;
    std::uint64_t count_ = 0;
};

/// Smooth noise in -1…1 with features of size 1.
[[nodiscard]] double noise(std::uint64_t seed, double x, double y) noexcept;
[[nodiscard]] double noise(std::uint64_t seed, double x, double y, double z) noexcept;

} // namespace planum::app::demo
