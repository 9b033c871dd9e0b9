// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scans/surface/gap_filling.hpp"
#include "scans/surface/surface_grid.hpp"
#include "scans/surface/undug_ground.hpp"

namespace planum::scans {

/// The cells that two frames have in common; empty (no rows) when they do not meet. Throws Usage when their cells
/// have not the same size.
[[nodiscard]] GridFrame common_frame(const GridFrame& a, const GridFrame& b);

/// Place in `grid` of a cell of a frame that lies inside it.
[[nodiscard]] inline std::size_t cell_in(const GridFrame& grid, const GridFrame& frame, std::int32_t row,
                                         std::int32_t column) noexcept {
    return grid.at(static_cast<std::int32_t>(frame.south - grid.south) + row,
                   static_cast<std::int32_t>(frame.west - grid.west) + column);
}

/// What changed between two surfaces, cell by cell.
struct SurfaceDifference {
    GridFrame frame;               ///< what both have in common
    std::vector<float> change;     ///< after − before [m]; NaN unless both saw ground
    std::vector<float> detectable; ///< smaller changes cannot be told from none, 95 % [m]
};

/// Level of detection after Lague and others (2013): 1.96 √(s₁²/n₁ + s₂²/n₂ + σ₁² + σ₂²), with spread and count of the
/// cells and the σ of the poses, and the project's `tolerance` [m] (a 95 % bound) added in quadrature.
[[nodiscard]] SurfaceDifference surface_difference(const SurfaceGrid& before, const SurfaceGrid& after,
                                                   double tolerance);

/// Earth that went, or came, between two surfaces.
struct DugVolume {
    double net = 0.0;         ///< gone less added [m³]
    double gone = 0.0;        ///< where the ground is lower now [m³]
    double added = 0.0;       ///< where it is higher [m³]
    double sigma = 0.0;       ///< of net [m³]
    double area = 0.0;        ///< that was counted, in plan [m²]
    double filled_area = 0.0; ///< of it: where one of the surfaces was not seen, or is a face [m²]
    double undug_area = 0.0;  ///< of it: where nobody dug, as far as the scans can tell [m²]
    double overhung = 0.0;    ///< of net: from under overhangs (FilledHeights::hollow) [m³]
    double unseen_area = 0.0; ///< not counted: too far from any ground that was seen [m²]

    [[nodiscard]] double bound() const noexcept { return 1.959964 * sigma; } ///< 95 % [m³]
};

struct VolumeOptions {
    GapOptions gaps;
    KnownGround known_before; ///< for fill_gaps()
    KnownGround known_after;
    double alike = 0.1;           ///< errors of filled cells are alike over so much, or the width of the gap [m]
    double hidden_doubt = 0.5;    ///< σ of a change that shadows hide on both days, as a share of it
    double overhang_doubt = 0.25; ///< σ of what lies under overhangs of a surface, as a share of it
    double outline_sigma = 0.0;   ///< of the lines between labels [m]
    double outline_alike = 0.3;   ///< a hand errs alike along so much of a line [m]
    std::optional<UndugRules> undug = UndugRules{}; ///< none: all ground counts
};

/// Volumes for each label 0…labels-1 between two surfaces; `label_of` has a value for every cell of
/// common_frame(), -1 for none. Empty `label_of`: all cells are label 0.
///
/// Ground on which nobody dug (undug_ground()) counts for the area and for nothing else: over a hundred square metres
/// errors of a millimetre are 0.1 m³, more than a day may dig of a few pits. What was scraped off by less than the
/// poses can tell is lost with it.
///
/// The σ adds: noise of each cell; gaps and faces, alike over their width; lines between labels, where the depth on
/// both sides differs; what lies under overhangs on either surface where something changed, alike over all of it;
/// and, linearly over all cells that count, the σ of the poses of either surface, which is common to them.
[[nodiscard]] std::vector<DugVolume> dug_volumes(const SurfaceGrid& before, const SurfaceGrid& after,
                                                 std::span<const std::int32_t> label_of, std::size_t labels,
                                                 const VolumeOptions& options = {});

} // namespace planum::scans
