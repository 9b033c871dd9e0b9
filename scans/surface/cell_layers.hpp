// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace planum::scans {

/// A measured height in a cell, packed so that sorting the numbers sorts by height: steps of 0.1 mm above −100 km, then
/// eight bits each for the place in the cell from west and from south, then 16 bits for the scan.
using PackedHeight = std::uint64_t;

inline constexpr double kHeightStep = 1e-4;       ///< [m]
inline constexpr double kHeightOrigin = -100e3;   ///< [m]
inline constexpr double kHeightCeiling = 300e3;   ///< [m]; nothing above can be packed
inline constexpr std::uint32_t kLastMaskBit = 31; ///< stands for this scan and all after it

/// `east` and `north`: place in the cell, 0…255 for its sides.
[[nodiscard]] inline PackedHeight pack_height(double z, std::uint16_t scan, std::uint8_t east = 128,
                                              std::uint8_t north = 128) noexcept {
    return static_cast<std::uint64_t>((z - kHeightOrigin) / kHeightStep) << 32U |
           static_cast<std::uint64_t>(east) << 24U | static_cast<std::uint64_t>(north) << 16U | scan;
}

[[nodiscard]] inline std::uint64_t steps_of(PackedHeight packed) noexcept { return packed >> 32U; }

[[nodiscard]] inline double height_of(PackedHeight packed) noexcept {
    return (static_cast<double>(steps_of(packed)) + 0.5) * kHeightStep + kHeightOrigin;
}

/// Place in the cell from its middle, in cells: −0.5…0.5.
[[nodiscard]] inline std::array<double, 2> place_of(PackedHeight packed) noexcept {
    return {(static_cast<double>(packed >> 24U & 0xffU) + 0.5) / 256.0 - 0.5,
            (static_cast<double>(packed >> 16U & 0xffU) + 0.5) / 256.0 - 0.5};
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

/// Where a side runs through a cell: the mean place of its points, [cells] from the middle; not a number where none
/// shows it.
struct SidePlace {
    float east = std::numeric_limits<float>::quiet_NaN();
    float north = std::numeric_limits<float>::quiet_NaN();
};

/// Of points drawn out in height the middle three fifths, so that ground above and below the side does not count; of
/// points at one height all. `sorted` is in ascending order.
[[nodiscard]] SidePlace side_place(std::span<const PackedHeight> sorted, const LayerRules& rules);

/// Finds the layers of a cell, from low to high, and appends them to `layers`. `sorted` is in ascending order.
///
/// Where points are drawn out from some height upwards, but another scan sees only the lower end, these are two layers:
/// the ground, and something that stood on it when the first scan was made.
void find_layers(std::span<const PackedHeight> sorted, const LayerRules& rules, std::vector<HeightLayer>& layers);

} // namespace planum::scans
