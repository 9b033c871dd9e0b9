// SPDX-License-Identifier: MIT
#include "tests/support/shown_by_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace planum::test {

namespace {

using app::demo::DemoDig;
using app::demo::SurfaceMap;
using app::demo::UnitNo;
using model::UnitKind;

constexpr double kLower = 0.02;    // [m]
constexpr double kOutline = 0.06;  // [m]
constexpr double kLeast = 0.02;    // [m²]
constexpr double kFlatShare = 0.6; // of a contact

// All cells of a map within 6 cm are the unit.
bool is_inside(const DemoDig& dig, const SurfaceMap& map, std::size_t cell, UnitNo unit) {
    const auto columns = static_cast<std::ptrdiff_t>(dig.grid->columns());
    const auto rows = static_cast<std::ptrdiff_t>(dig.grid->rows());
    const auto reach = static_cast<std::ptrdiff_t>(std::lround(kOutline / dig.grid->cell()));
    const auto row = static_cast<std::ptrdiff_t>(cell) / columns;
    const auto column = static_cast<std::ptrdiff_t>(cell) % columns;
    for (std::ptrdiff_t r = row - reach; r <= row + reach; ++r) {
        for (std::ptrdiff_t c = column - reach; c <= column + reach; ++c) {
            if ((r - row) * (r - row) + (c - column) * (c - column) > reach * reach) continue;
            if (r < 0 || c < 0 || r >= rows || c >= columns) return false;
            if (map[static_cast<std::size_t>(r * columns + c)].unit != unit) return false;
        }
    }
    return true;
}

bool holds(const SurfaceMap& map, UnitNo unit) {
    return std::any_of(map.begin(), map.end(), [&](const auto& cell) { return cell.unit == unit; });
}

bool side_by_side(const DemoDig& dig, const SurfaceMap& map, UnitNo a, UnitNo b) {
    const std::size_t columns = dig.grid->columns();
    for (std::size_t cell = 0; cell + columns < map.size(); ++cell) {
        for (const std::size_t other : {cell + 1, cell + columns}) {
            const auto one = map[cell].unit;
            const auto two = map[other].unit;
            if ((one == a && two == b) || (one == b && two == a)) return true;
        }
    }
    return false;
}

struct Shown {
    double clear = 0.0;  // [m²]
    bool beside = false; // on the upper surface of a step that shows the pair
    bool gone = false;   // nothing of the later one is left on the lower
};

Shown shown(const DemoDig& dig, UnitNo later, UnitNo earlier) {
    Shown all;
    for (std::size_t s = 0; s + 1 < dig.maps.size(); ++s) {
        const SurfaceMap& upper = dig.maps[s];
        const SurfaceMap& lower = dig.maps[s + 1];
        double clear = 0.0;
        for (std::size_t cell = 0; cell < upper.size(); ++cell) {
            if (upper[cell].unit != later || lower[cell].unit != earlier) continue;
            if (static_cast<double>(upper[cell].z - lower[cell].z) <= kLower) continue;
            if (is_inside(dig, upper, cell, later) && is_inside(dig, lower, cell, earlier))
                clear += dig.grid->cell() * dig.grid->cell();
        }
        all.clear += clear;
        if (clear == 0.0) continue;
        all.beside = all.beside || side_by_side(dig, upper, later, earlier);
        all.gone = all.gone || !holds(lower, later);
    }
    return all;
}

} // namespace

std::string why_not_shown(const DemoDig& dig, UnitNo later, UnitNo earlier) {
    const auto& above = dig.formation.units()[static_cast<std::size_t>(later)];
    const auto& below = dig.formation.units()[static_cast<std::size_t>(earlier)];
    const Shown seen = shown(dig, later, earlier);
    if (seen.clear < kLeast)
        return fmt::format("{:.3f} m² of the contact lie farther than 6 cm from all outlines", seen.clear);
    const auto is_loose = [](const auto& unit) { return unit.kind == UnitKind::Deposit; };
    if (below.kind == UnitKind::Cut) {
        if (is_loose(above) && above.cut == earlier) return {};
        return "what lay over an emptied cut and not in it may be its roof";
    }
    if (above.kind == UnitKind::Cut) return "below an emptied cut surfaces show the bottom, not what was cut through";
    if (dig.options.method == model::DigMethod::Stratigraphic) return {};
    if (below.kind == UnitKind::Natural) return {};
    if (!is_loose(above) || !is_loose(below)) return "levels leave the order with a structure open";
    const auto contact = std::find_if(dig.contacts.begin(), dig.contacts.end(), [&](const app::demo::Contact& c) {
        return c.later == later && c.earlier == earlier;
    });
    if (contact == dig.contacts.end()) return "the two do not touch";
    if (contact->plan_area < kFlatShare * (contact->plan_area + contact->side_area))
        return "the contact is steep, and levels do not show steep ones";
    if (!seen.beside && !seen.gone) return "on levels it first appears inside the other: covered, or seen too late";
    return {};
}

} // namespace planum::test
