// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "scans/formats/point_block.hpp"

namespace planum::scans {

// The bytes of a point store; docs/formats/point-store.md describes them in words.

static_assert(std::endian::native == std::endian::little, "point stores are little-endian and mapped as they are");

inline constexpr std::array<char, 8> kStoreMagic = {'P', 'L', 'N', 'M', 'P', 'T', 'S', '\n'};
inline constexpr std::uint32_t kStoreVersion = 1;

/// Edge of the cubes that the trees start from [m]. With 65,536 steps a step is 0.122 mm there and finer
/// further down, so that no coordinate is off by more than 0.062 mm.
inline constexpr double kRootEdge = 8.0;

/// Depth of the smallest nodes: 8 m / 2^16. Root-relative coordinates have 32 bits, nodes use 16.
inline constexpr unsigned kDeepest = 16;

/// Roots lie within ± this many root edges of the origin, so that cells at the deepest level fit 32 bits.
inline constexpr std::int32_t kFarthestRoot = 1 << 14;

/// Which columns a block has behind its coordinates.
enum StoreFlags : std::uint32_t { kStoreIntensity = 1, kStoreGrid = 2, kStoreColour = 4 };

struct StoreHeaderRecord {
    std::array<char, 8> magic = kStoreMagic;
    std::uint32_t version = kStoreVersion;
    std::uint32_t flags = 0;
    std::uint64_t file_bytes = 0;
    std::uint64_t points = 0;
    std::array<double, 3> origin{};  ///< [m] in the scan's frame, a multiple of kRootEdge
    std::array<double, 3> minimum{}; ///< bounds of the points as they came, before rounding
    std::array<double, 3> maximum{};
    double root_edge = kRootEdge;
    std::uint64_t nodes_at = 0; ///< [byte]
    std::uint64_t nodes = 0;
    std::uint64_t roots = 0; ///< the first so many nodes
    std::uint64_t text_at = 0;
    std::uint64_t text_bytes = 0;
    std::uint32_t nodes_checksum = 0; ///< CRC-32C
    std::uint32_t text_checksum = 0;
    std::uint32_t reserved = 0;
    std::uint32_t header_checksum = 0; ///< of all before it
};

static_assert(sizeof(StoreHeaderRecord) == 168);

struct StoreNodeRecord {
    std::uint64_t block_at = 0;         ///< [byte]; a multiple of 8
    std::uint64_t subtree_points = 0;   ///< here and below
    std::uint32_t points = 0;           ///< here
    std::uint32_t checksum = 0;         ///< CRC-32C of the block
    std::array<std::int32_t, 3> cell{}; ///< cube index at this depth, counted from the origin
    std::uint32_t first_child = 0;      ///< children stand together, in the order of their octants
    std::array<std::uint16_t, 3> low{}; ///< bounds of all points here and below, in this node's steps
    std::array<std::uint16_t, 3> high{};
    std::uint8_t depth = 0;
    std::uint8_t child_mask = 0; ///< bit o: octant o has a child; o = x + 2y + 4z
    std::uint16_t reserved = 0;
};

static_assert(sizeof(StoreNodeRecord) == 56);

/// Bytes a point takes in a block.
[[nodiscard]] constexpr std::uint64_t stored_bytes(std::uint32_t flags) noexcept {
    return 6U + ((flags & kStoreIntensity) != 0 ? 2U : 0U) + ((flags & kStoreGrid) != 0 ? 4U : 0U) +
           ((flags & kStoreColour) != 0 ? 3U : 0U);
}

/// A point on its way into the store: coordinates in 2^-32 of the root's edge.
struct PackedPoint {
    std::array<std::uint32_t, 3> place{};
    std::uint16_t intensity = 0;
    std::uint16_t row = 0;
    std::uint16_t column = 0;
    Rgb colour;

    /// Which octant of a node at `depth` it lies in.
    [[nodiscard]] unsigned octant(unsigned depth) const noexcept {
        const unsigned shift = 31U - depth;
        return ((place[0] >> shift) & 1U) | ((place[1] >> shift) & 1U) << 1U | ((place[2] >> shift) & 1U) << 2U;
    }

    /// Its 16 bits within a node at `depth`.
    [[nodiscard]] std::uint16_t step(std::size_t axis, unsigned depth) const noexcept {
        return static_cast<std::uint16_t>(place[axis] >> (16U - depth));
    }
};

static_assert(sizeof(PackedPoint) == 24);

} // namespace planum::scans
