// SPDX-License-Identifier: MIT
#include "tests/support/dug_tally.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace planum::test {

namespace {

constexpr double kNearShare = 0.015;
constexpr double kNarrowShare = 0.05;
constexpr double kNarrow = 0.05; // [m³]

struct Sunk {
    double all = 0.0;
    std::map<std::string, double> of_unit;
};

// By how much the ground sank from the surface before to this one [m³].
Sunk sunk_ground(const app::demo::DemoDig& dig, std::size_t surface) {
    const app::demo::SurfaceMap& before = dig.maps[surface - 1];
    const app::demo::SurfaceMap& after = dig.maps[surface];
    const double area = dig.grid->cell() * dig.grid->cell();
    Sunk sunk;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const double depth = area * (static_cast<double>(before[i].z) - static_cast<double>(after[i].z));
        sunk.all += depth;
        if (before[i].unit != app::demo::kAir)
            sunk.of_unit[dig.formation.units()[static_cast<std::size_t>(before[i].unit)].number] += depth;
    }
    return sunk;
}

} // namespace

DugTally& DugTally::operator+=(const ToldVolume& volume) {
    const double error = std::abs(volume.error());
    ++volumes;
    near += error <= kNearShare * volume.dug ? 1U : 0U;
    within += error <= volume.bound ? 1U : 0U;
    narrow += volume.bound <= std::max(kNarrow, kNarrowShare * volume.dug) ? 1U : 0U;
    if (volume.dug > 0.0) worst_share = std::max(worst_share, error / volume.dug);
    return *this;
}

DugTally& DugTally::operator+=(const DugTally& other) {
    volumes += other.volumes;
    near += other.near;
    within += other.within;
    narrow += other.narrow;
    worst_share = std::max(worst_share, other.worst_share);
    return *this;
}

void DugTally::print(const std::string& name) const {
    fmt::print(
        "{:<24} {:4} volumes: within 1.5 % {}, within their bound {}, bound ≤ 5 % or 0.05 m³ {}, worst {:.2f} %\n",
        name, volumes, near, within, narrow, 100.0 * worst_share);
}

DugVolumesTold compare_volumes(const app::demo::DemoDig& dig, const app::EarthReport& report) {
    std::map<app::demo::SurfaceNo, double> dug;
    for (const auto& [key, volume] : dig.volumes) dug[key.second] += volume;
    DugVolumesTold told;
    told.total = {"total", 0.0, report.total.net, report.total.bound};
    std::map<std::string, double> of_unit;
    for (const app::EarthStep& step : report.steps) {
        for (app::demo::SurfaceNo s = 1; s < dig.plan.surfaces; ++s) {
            if (!step.after.ends_with(dig.plan.days[static_cast<std::size_t>(s)])) continue;
            const Sunk sunk = sunk_ground(dig, static_cast<std::size_t>(s));
            told.total.dug += dug[s];
            told.days.push_back({step.after, dug[s], step.total.net, step.total.bound});
            told.bare.push_back({step.after, sunk.all, step.total.net, step.total.bound});
            for (const auto& [unit, volume] : sunk.of_unit) of_unit[unit] += volume;
        }
    }
    for (const app::EarthOfUnit& unit : report.units) {
        if (unit.is_unit) told.units.push_back({unit.unit, of_unit[unit.unit], unit.earth.net, unit.earth.bound});
    }
    return told;
}

} // namespace planum::test
