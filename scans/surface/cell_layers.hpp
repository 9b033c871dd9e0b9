// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace planum::scans {

/// A measured height in a cell, packed so that sorting the numbers sorts by height, then by scan: steps of 0.1 mm
/// above −100 km, then 16 bits for the scan.
using PackedHeight = std::uint64_t;

inline constexpr double kHeightStep = 1e-4;       ///< [m]
inline constexpr double kHeightOrigin = -100e3;   ///< [m]
inline constexpr double kHeightCeiling = 300e3;   ///< [m]; nothing above can be packed
inline constexpr std::uint32_t kLastMaskBit = 31; ///< stands for this scan and all after it

[[nodiscard]] inline PackedHeight pack_height(double z, std::uint16_t scan) noexcept {
    return static_cast<std::uint64_t>((z - kHeightOrigin) / kHeightStep) << 16U | scan;
}

[[nodiscard]] inline double height_of(PackedHeight packed) noexcept {
    return (static_cast<double>(packed >> 16U) + 0.5) * kHeightStep + kHeightOrigin;
}

[[nodiscard]] inline std::uint16_t scan_of(PackedHeight packed) noexcept {
    return static_cast<std::uint16_t>(packed & 0xffffU);
}

[[nodiscard]] inline std::uint32_t mask_of(std::uint16_t scan) noexcept {
    return std::uint32_t{1} << (scan < kLastMaskBit ? scan : kLastMaskBit);
}

/// What one scan says of the height of a layer.
struct ScanHeight {
    float height = std::numeric_limits<float>::quiet_NaN(); ///< median [m]
    float spread = 0.0F;                                    ///< half of what lies between 16 % and 84 % [m]
    std::uint16_t scan = 0;
    std::uint16_t count = 0;
};

/// Points of a cell that lie together in height.
struct HeightLayer {
    float height = 0.0F; ///< median [m]
    float low = 0.0F;    ///< 10 % of the points are below
    float high = 0.0F;   ///< 10 % are above
    float spread = 0.0F; ///< half of what lies between 16 % and 84 % [m]
    std::uint32_t scans = 0;
    std::uint16_t count = 0;
    bool wide = false; ///< drawn out over more than a 60° slope gives
    ScanHeight lowest; ///< the scans that differ most; only where two or more see the layer
    ScanHeight highest;
};

struct LayerRules {
    double gap = 0.03;    ///< heights farther apart than this are two layers [m]
    double extent = 0.05; ///< from 10 % to 90 % of the points: more is a side, no surface [m]
    double share = 0.05;  ///< of the points of the cell; less is a stray (mixed pixels)
    std::size_t most = 3; ///< layers of a cell; those with most points
};

/// Finds the layers of a cell, from low to high, and appends them to `layers`. `sorted` is in ascending order.
///
/// Where points are drawn out from some height upwards, but another scan sees only the lower end, these are two layers:
/// the ground, and something that stood on it when the first scan was made.
void find_layers(std::span<const PackedHeight> sorted, const LayerRules& rules, std::vector<HeightLayer>& layers);

} // namespace planum::scans
