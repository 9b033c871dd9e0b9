// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace planum::app {

/// Random numbers that are the same on every machine and library (SplitMix64, Steele et al. 2014); the
/// distributions of the standard library are not.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    [[nodiscard]] std::uint64_t next() noexcept {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }

    /// 0 ≤ x < 1
    [[nodiscard]] double unit() noexcept { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

    [[nodiscard]] double between(double low, double high) noexcept { return low + (high - low) * unit(); }

    [[nodiscard]] bool chance(double probability) noexcept { return unit() < probability; }

    /// 0 … n−1; n must not be 0.
    [[nodiscard]] std::size_t below(std::size_t n) noexcept { return static_cast<std::size_t>(next() % n); }

    /// Mean 0, σ 1 (twelve uniforms less six: good enough, and without a logarithm of zero).
    [[nodiscard]] double normal() noexcept {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) sum += unit();
        return sum;
    }

    /// Mean as given.
    [[nodiscard]] double exponential(double mean) noexcept { return -mean * std::log(1.0 - unit()); }

  private:
    std::uint64_t state_;
};

} // namespace planum::app
