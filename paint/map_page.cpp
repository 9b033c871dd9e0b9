// SPDX-License-Identifier: MIT
#include "paint/map_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/error.hpp"
#include "paint/font_measure.hpp"

namespace planum::paint {

namespace {

constexpr double kHeader = 40.0;      // title and the line below it
constexpr double kCoordinates = 14.0; // strip around the map
constexpr double kLeastWidth = 340.0; // so that scale bar and north arrow have room
constexpr double kKeyLine = 15.0;
constexpr double kKeyText = 8.0;
constexpr double kSwatch = 18.0;
constexpr double kTwoDashes = 13.0; // of 5 and a gap of 3, in widths of the line

// Dashes show as such only where two of them and what is between have room.
double swatch_width(const geometry::SheetLook& look) {
    if (look.opacity > 0.0 || look.dash == geometry::SheetDash::Solid) return kSwatch;
    return std::max(kSwatch, kTwoDashes * look.width * kPointsPerMillimetre);
}

std::int64_t ticks_between(double low, double high, double step) {
    return static_cast<std::int64_t>(std::floor(high / step + 1e-9) - std::ceil(low / step - 1e-9)) + 1;
}

// Entries from left to right, line by line; returns the height they take.
double place_keys(const geometry::MapSheet& sheet, double width, std::vector<PlacedKey>& keys) {
    const FontTextMeasure measure;
    double x = 0.0;
    double line = 0.0;
    for (const geometry::SheetKey& key : sheet.keys) {
        const double words = measure.width(key.text, kKeyText, strat::FontWeight::Regular);
        const double swatch = swatch_width(key.look);
        const double needs = swatch + 5.0 + words + 16.0;
        if (x > 0.0 && x + needs - 16.0 > width) {
            x = 0.0;
            line += kKeyLine;
        }
        keys.push_back({&key, QRectF(x, line + 1.0, swatch, 9.0), x + swatch + 5.0, line + 8.5});
        x += needs;
    }
    return keys.empty() ? 0.0 : line + kKeyLine;
}

} // namespace

double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= most * (1.0 + 1e-9)) return step * power;
    }
    return power;
}

double tick_step(const geometry::MapSheet& sheet, const MapPage& page, std::size_t axis) {
    constexpr double kMost = 2.5 * 72.0; // [pt]
    constexpr double kLeastAlong = 36.0; // numbers beside one another
    constexpr double kLeastUp = 10.0;    // numbers below one another
    const auto& [low, high] = sheet.extent;
    double step = round_length(1.01 * kMost / page.points_per_metre);
    const auto ticks = [&](std::size_t k) { return ticks_between(low[k], high[k], step); };
    const auto is_enough = [&] { return sheet.is_section ? ticks(axis) >= 3 : std::min(ticks(0), ticks(1)) >= 2; };
    const double least = sheet.is_section && axis == 1 ? kLeastUp : kLeastAlong;
    while (!is_enough()) {
        const double closer = round_length(0.99 * step);
        if (closer * page.points_per_metre < least) break;
        step = closer;
    }
    return step;
}

MapPage lay_out_map(const geometry::MapSheet& sheet, double scale, double width, double height) {
    if (sheet.extent.is_empty() || !(sheet.extent.low[0] < sheet.extent.high[0]) ||
        !(sheet.extent.low[1] < sheet.extent.high[1]))
        throw Error(ErrorCode::BadInput, "there is nothing to show");
    if (!(scale > 0.0 && std::isfinite(scale))) throw Error(ErrorCode::BadInput, "the scale is no positive number");
    MapPage page;
    page.points_per_metre = 1000.0 / scale * kPointsPerMillimetre;
    const double map_width = (sheet.extent.high[0] - sheet.extent.low[0]) * page.points_per_metre;
    const double map_height = (sheet.extent.high[1] - sheet.extent.low[1]) * page.points_per_metre;
    const double inner = std::max({map_width + 2.0 * kCoordinates, kLeastWidth, width - 2.0 * kMapMargin});
    const double keys = place_keys(sheet, inner - 2.0 * kCoordinates, page.keys);
    page.width = inner + 2.0 * kMapMargin;
    const double needs = 2.0 * kMapMargin + kHeader + map_height + 2.0 * kCoordinates + kFootHeight + 10.0 + keys;
    page.height = std::max(needs, height);
    const double left = (page.width - map_width) / 2.0;
    const double spare = (page.height - needs) / 2.0;
    page.frame = QRectF(left, kMapMargin + kHeader + kCoordinates + spare, map_width, map_height);
    page.foot = page.height - kMapMargin - keys - kFootHeight;
    for (PlacedKey& key : page.keys) {
        key.swatch.translate(kMapMargin + kCoordinates, page.foot + kFootHeight);
        key.text_x += kMapMargin + kCoordinates;
        key.base_line += page.foot + kFootHeight;
    }
    return page;
}

} // namespace planum::paint
