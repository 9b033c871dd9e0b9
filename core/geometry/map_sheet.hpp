// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "core/geometry/polygons.hpp"

namespace planum::geometry {

/// A colour as 0xRRGGBB.
using SheetColour = std::uint32_t;

enum class SheetDash { Solid, Dashed, Dotted };

/// How something is drawn, on the sheet and in its key.
struct SheetLook {
    SheetColour line = 0x1d1c1a;
    double width = 0.35; ///< [mm on paper]; 0: no line
    SheetDash dash = SheetDash::Solid;
    SheetColour fill = 0xffffff;
    double opacity = 0.0; ///< of the fill

    friend bool operator==(const SheetLook&, const SheetLook&) = default;
};

/// Pixels under everything else, the first row on top.
struct SheetPicture {
    double left = 0.0; ///< [m]
    double top = 0.0;
    double pixel = 0.0; ///< side [m]
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::vector<std::uint8_t> rgba; ///< four bytes a pixel
};

struct SheetShape {
    MultiPolygon shape; ///< x and y count [m]
    SheetLook look;
};

struct SheetLine {
    Line3 points; ///< open; x and y count [m]
    SheetLook look;
};

enum class SheetSign { None, Level, Find, Station };

/// A sign with words beside it. Where signs crowd, words that would lie on others are left out.
struct SheetMark {
    double x = 0.0; ///< [m]
    double y = 0.0;
    SheetSign sign = SheetSign::None;
    std::string text;
};

/// The number of a unit, in the middle of its outline, with a smaller line below it.
struct SheetLabel {
    double x = 0.0; ///< [m]
    double y = 0.0;
    std::string text;
    std::string below;
};

struct SheetKey {
    std::string text;
    SheetLook look;
    SheetSign sign = SheetSign::None;
};

/// A plan (x east, y north) or a section (x along it, y up) as values; what paint/ prints at a scale. Everything is
/// painted in the order of its list, pictures first, then shapes, lines, marks and labels.
struct MapSheet {
    Extent extent; ///< what is shown [m]
    bool is_section = false;
    std::string title;
    std::string subtitle;
    std::string site; ///< at the foot
    std::vector<SheetPicture> pictures;
    std::vector<SheetShape> shapes;
    std::vector<SheetLine> lines;
    std::vector<SheetMark> marks;
    std::vector<SheetLabel> labels;
    std::vector<SheetKey> keys;
};

} // namespace planum::geometry
