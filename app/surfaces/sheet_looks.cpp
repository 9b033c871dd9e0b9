// SPDX-License-Identifier: MIT
#include "app/surfaces/sheet_looks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planum::app {

namespace {

using geometry::SheetDash;
using geometry::SheetLook;
using model::UnitForm;
using model::UnitKind;

constexpr double kCasing = 0.2; // of coloured lines, on either side [mm]

} // namespace

SheetLook unit_look(UnitKind kind, UnitForm form) {
    SheetLook look;
    switch (kind) {
    case UnitKind::Deposit:
        look.fill = form == UnitForm::Fill ? 0xb9770e : 0xd9b46a;
        look.opacity = form == UnitForm::Fill ? 0.38 : 0.25;
        return look;
    case UnitKind::Cut:
        look.dash = SheetDash::Dashed;
        look.fill = 0x5f7f95;
        look.opacity = 0.25;
        return look;
    case UnitKind::Structure:
        look.width = 0.5;
        look.fill = 0xa44a3f;
        look.opacity = 0.5;
        return look;
    case UnitKind::Skeleton:
        look.fill = 0x6b5ca5;
        look.opacity = 0.45;
        return look;
    case UnitKind::Feature:
        look.fill = 0x8a6fa8;
        look.opacity = 0.3;
        return look;
    case UnitKind::Natural:
        look.fill = 0x5d8a54;
        look.opacity = 0.3;
        return look;
    case UnitKind::Interface:
    case UnitKind::Void:
    case UnitKind::Unknown:
        look.fill = 0x9a958a;
        look.opacity = 0.25;
        return look;
    }
    return look;
}

void add_outline(geometry::MapSheet& sheet, const geometry::MultiPolygon& shape, const SheetLook& look) {
    const bool is_coloured = look.opacity == 0.0;
    if (is_coloured || look.dash != SheetDash::Solid) {
        SheetLook below;
        below.line = 0xffffff;
        below.width = look.width + (is_coloured ? 2.0 * kCasing : 0.0);
        sheet.shapes.push_back({shape, below});
    }
    sheet.shapes.push_back({shape, look});
}

geometry::SheetColour colour_in_time(std::size_t place, std::size_t count) {
    constexpr std::array<std::array<double, 3>, 4> kSteps = {
        {{236, 160, 40}, {214, 80, 60}, {140, 40, 120}, {40, 30, 110}}};
    const double at = count > 1 ? 3.0 * static_cast<double>(place) / static_cast<double>(count - 1) : 3.0;
    const auto from = static_cast<std::size_t>(std::min(2.0, std::floor(at)));
    geometry::SheetColour colour = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double value =
            kSteps[from][k] + (at - static_cast<double>(from)) * (kSteps[from + 1][k] - kSteps[from][k]);
        colour = colour << 8U | static_cast<geometry::SheetColour>(std::lround(value));
    }
    return colour;
}

} // namespace planum::app
