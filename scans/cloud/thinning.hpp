// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

#include "scans/cloud/store_layout.hpp"

namespace planum::scans {

/// A divided node keeps the first point of each cell of a grid with 2^kSampleBits cells along each edge:
/// about 5,000 on a surface.
inline constexpr unsigned kSampleBits = 6;

/// Says of each point of a node whether it stays there as part of the sample.
class Sampler {
  public:
    explicit Sampler(unsigned depth) : depth_(depth) {}

    [[nodiscard]] bool keeps(const PackedPoint& point) {
        // At depth d the node's own bits start at 31 - d; near the deepest level fewer than six are left.
        const unsigned shift = 32U - depth_ - kSampleBits;
        constexpr std::uint32_t kMask = (1U << kSampleBits) - 1U;
        const std::size_t cell = ((point.place[0] >> shift) & kMask) |
                                 ((point.place[1] >> shift) & kMask) << kSampleBits |
                                 ((point.place[2] >> shift) & kMask) << (2U * kSampleBits);
        if (taken_[cell]) return false;
        taken_[cell] = true;
        return true;
    }

  private:
    unsigned depth_;
    std::bitset<1U << (3U * kSampleBits)> taken_;
};

static_assert(32U - kDeepest >= kSampleBits);

/// Puts the points of one block from coarse to fine: in front those that come first in their cell of a
/// 2 × 2 × 2 grid, then of 4 × 4 × 4 and so on. So any first part of a block is a thinned sample of it.
class CoarseToFine {
  public:
    [[nodiscard]] std::span<const PackedPoint> order(std::span<const PackedPoint> points, unsigned depth) {
        for (std::vector<bool>& level : taken_) std::fill(level.begin(), level.end(), false);
        std::array<std::size_t, kLevels + 2> from{};
        levels_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            levels_[i] = level_of(points[i], depth);
            ++from[levels_[i] + 1U];
        }
        for (std::size_t level = 1; level < from.size(); ++level) from[level] += from[level - 1];
        ordered_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) ordered_[from[levels_[i]]++] = points[i];
        return ordered_;
    }

  private:
    static constexpr std::size_t kLevels = 5;

    [[nodiscard]] std::uint8_t level_of(const PackedPoint& point, unsigned depth) {
        auto level = static_cast<std::uint8_t>(kLevels);
        // From fine to coarse: who is first in a coarse cell is first in all finer ones within it.
        for (unsigned bits = kLevels; bits >= 1; --bits) {
            const unsigned shift = 32U - depth - bits;
            const std::uint32_t mask = (1U << bits) - 1U;
            const std::size_t cell = ((point.place[0] >> shift) & mask) | ((point.place[1] >> shift) & mask) << bits |
                                     ((point.place[2] >> shift) & mask) << (2U * bits);
            if (taken_[bits - 1][cell]) break;
            taken_[bits - 1][cell] = true;
            level = static_cast<std::uint8_t>(bits - 1);
        }
        return level;
    }

    std::array<std::vector<bool>, kLevels> taken_ = {std::vector<bool>(1U << 3U), std::vector<bool>(1U << 6U),
                                                     std::vector<bool>(1U << 9U), std::vector<bool>(1U << 12U),
                                                     std::vector<bool>(1U << 15U)};
    std::vector<std::uint8_t> levels_;
    std::vector<PackedPoint> ordered_;
};

} // namespace planum::scans
