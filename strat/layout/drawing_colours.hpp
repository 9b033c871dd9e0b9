// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "strat/layout/drawing.hpp"

namespace planum::strat {

/// A colour as 0xRRGGBB; opaque.
using Colour = std::uint32_t;

enum class Dash { Solid, Dashed, Dotted, LongDashed, DashDotted };

struct StrokeStyle {
    Colour colour = 0x3b3a36;
    double width = 0.8; ///< [pt]
    Dash dash = Dash::Solid;
};

struct BoxStyle {
    Colour fill = 0xffffff;
    StrokeStyle stroke;
    Colour text = 0x1d1c1a;
};

inline constexpr Colour kInk = 0x1d1c1a;       ///< titles, labels
inline constexpr Colour kFaintInk = 0x6b675f;  ///< headings, notes
inline constexpr Colour kLineInk = 0x3b3a36;   ///< outlines and lines
inline constexpr Colour kBandShade = 0xf4f1ea; ///< every second band
inline constexpr Colour kBandEdge = 0xc9c2b3;
inline constexpr Colour kFrameEdge = 0x8a9bb0;
inline constexpr Colour kAlarm = 0xc1121f;   ///< cycles
inline constexpr Colour kAgainst = 0xa35a00; ///< orders against the phases
inline constexpr Colour kPaper = 0xffffff;

/// Length of dashes and gaps in turn [pt]; empty: solid.
[[nodiscard]] std::span<const double> pattern_of(Dash dash) noexcept;

/// How a line is painted of which the evidence says so: it tells apart by width and dashes what it does by colour.
/// None is painted as not testable.
[[nodiscard]] StrokeStyle style_of(model::EvidenceVerdict verdict) noexcept;

/// How a box or a line is painted; the same in SVG, PDF, PNG and on the screen.
[[nodiscard]] BoxStyle style_of(const DrawnBox& box) noexcept;
[[nodiscard]] StrokeStyle style_of(const DrawnLine& line) noexcept;

/// Corners of the small mark that says "has finds", in the upper right corner of the box.
[[nodiscard]] std::vector<DrawPoint> finds_mark(const DrawRect& box);

/// Puts the arrow heads of upward lines on their longest upright parts, near the middle but clear of bars that cross.
void place_arrows(MatrixDrawing& drawing);

/// Corners of the arrow head on an upward line; empty if none.
[[nodiscard]] std::vector<DrawPoint> arrow_head(const DrawnLine& line);

/// Radius of the dot at a junction [pt].
inline constexpr double kJunctionRadius = 1.7;

} // namespace planum::strat
