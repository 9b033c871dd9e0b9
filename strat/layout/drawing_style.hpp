// SPDX-License-Identifier: MIT
#pragma once

namespace planum::strat::style {

// The measures every engine, writer and painter shares, in points. Chosen so that a matrix of some
// hundred units reads on A3 and one of some dozen on A4.
inline constexpr double kTextSize = 9.0;
inline constexpr double kSmallText = 7.0;
inline constexpr double kLineHeight = 11.0; ///< from one label line to the next
inline constexpr double kBoxHeight = 20.0;  ///< of a one-line box
inline constexpr double kBoxMinWidth = 38.0;
inline constexpr double kBoxMaxLabel = 150.0; ///< wider labels break
inline constexpr double kBoxPadding = 8.0;    ///< left and right of the label
inline constexpr double kInnerMark = 10.0;    ///< room for the mark of a contradiction, left and right of the label
inline constexpr double kBoxGap = 16.0;       ///< between neighbouring boxes of a level
inline constexpr double kLineGap = 8.0;       ///< between a line and anything beside it in a level
inline constexpr double kLeastLineGap = 5.0;  ///< where a line would have to step aside otherwise
inline constexpr double kPortGap = 7.0;       ///< between two lines at one side of a box
inline constexpr double kPortMargin = 5.5;    ///< from the corner of a box to its first line
inline constexpr double kTrackGap = 7.0;      ///< between two horizontal lines
inline constexpr double kChannelMargin = 9.0; ///< from a box to the first horizontal line
inline constexpr double kChannelMin = 20.0;   ///< least height between two levels
inline constexpr double kComponentGap = 34.0; ///< between parts of the matrix that no line joins
inline constexpr double kFramePad = 8.0;      ///< from a group's boxes to its frame
inline constexpr double kPageMargin = 36.0;
inline constexpr double kTitleSize = 16.0;
inline constexpr double kSubtitleSize = 9.5;
inline constexpr double kHeadingSize = 9.5;
inline constexpr double kLineWidth = 0.8;

} // namespace planum::strat::style
