// SPDX-License-Identifier: MIT
#include "app/demo/simulator_composition.hpp"

#include <algorithm>
#include <vector>

#include "app/demo/simulator_composer.hpp"
#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

namespace {

using PhasePlan = std::vector<FeaturePlan>;

// What a site of that many phases has at least.
std::vector<PhasePlan> backbone(const SiteShape& site, DemoSize size) {
    std::vector<PhasePlan> phases(static_cast<std::size_t>(site.phases));
    if (size == DemoSize::Tiny) {
        phases[0] = {{FeatureType::BellPit, 1}, {FeatureType::PostHole, 1}};
        return phases;
    }
    if (size == DemoSize::Small) {
        phases[0] = {{FeatureType::Wall, 0},
                     {FeatureType::Floor, 0},
                     {FeatureType::PostHole, 1},
                     {FeatureType::BellPit, 2},
                     {FeatureType::Mound, 0}};
        return phases;
    }
    phases[0] = {{FeatureType::Ditch, 2}, {FeatureType::Pit, 2}};
    for (std::size_t p = 1; p < phases.size(); ++p) {
        if (p % 3 == 1) phases[p] = {{FeatureType::WallPair, 1}, {FeatureType::Floor, 0}, {FeatureType::BellPit, 3}};
        if (p % 3 == 2) phases[p] = {{FeatureType::Pit, 2}, {FeatureType::Mound, 0}};
        if (p % 3 == 0) phases[p] = {{FeatureType::BellPit, 2}};
    }
    return phases;
}

DemoSize size_of(const SiteShape& site) {
    if (site.units <= 8) return DemoSize::Tiny;
    if (site.units <= 12) return DemoSize::Small;
    return site.units <= 40 ? DemoSize::Medium : DemoSize::Large;
}

int units_in(const std::vector<PhasePlan>& phases) {
    int units = 0;
    for (const PhasePlan& phase : phases) {
        for (const FeaturePlan& feature : phase) units += demo::units_in(feature);
    }
    return units;
}

// Fills up to exactly the number of units with pits, post-holes and heaps.
void add_more(std::vector<PhasePlan>& phases, int missing, Draw& draw) {
    while (missing > 0) {
        FeaturePlan more{FeatureType::PostHole, 1};
        if (missing == 1) more = {FeatureType::Mound, 0};
        if (missing >= 4 && draw.chance(0.15)) more = {FeatureType::BellPit, 3};
        if (missing >= 3 && missing != 4 && draw.chance(0.4)) more = {FeatureType::Pit, 2};
        if (missing == 3) more = {FeatureType::Pit, 2};
        missing -= demo::units_in(more);
        phases[static_cast<std::size_t>(draw.below(static_cast<int>(phases.size())))].push_back(more);
    }
}

} // namespace

SiteShape site_shape(DemoSize size) {
    constexpr double kX = 100.0;
    constexpr double kY = 200.0;
    constexpr double kTurf = 50.0;
    SiteShape site;
    switch (size) {
    case DemoSize::Tiny:
        site.trench = {{kX, kY, kTurf - 1.6}, {kX + 3.0, kY + 2.5, kTurf}};
        site.days = 3;
        site.units = 8;
        site.scan_columns = 180;
        site.scan_rows = 48;
        break;
    case DemoSize::Small: site.trench = {{kX, kY, kTurf - 1.9}, {kX + 6.0, kY + 4.0, kTurf}}; break;
    case DemoSize::Medium:
        site.trench = {{kX, kY, kTurf - 2.5}, {kX + 10.0, kY + 8.0, kTurf}};
        site.days = 8;
        site.stations = 3;
        site.units = 40;
        site.phases = 4;
        site.scan_columns = 1440;
        site.scan_rows = 360;
        break;
    case DemoSize::Large:
        site.trench = {{kX, kY, kTurf - 3.4}, {kX + 20.0, kY + 15.0, kTurf}};
        site.days = 20;
        site.stations = 5;
        site.units = 300;
        site.phases = 10;
        site.table_step = 0.04;
        site.scan_columns = 3600;
        site.scan_rows = 900;
        break;
    }
    const bool shallow = site.phases == 1;
    site.natural = kTurf - (shallow ? 1.05 : size == DemoSize::Medium ? 1.7 : 2.6);
    site.last = kTurf - (shallow ? 0.55 : 0.38);
    return site;
}

double turf_height(const SiteShape& site, std::uint64_t seed, double x, double y) noexcept {
    const double dx = x - 0.5 * (site.trench.low.x + site.trench.high.x);
    const double dy = y - 0.5 * (site.trench.low.y + site.trench.high.y);
    return site.trench.high.z + 0.008 * dx - 0.005 * dy + 0.05 * noise(mix(seed, 11), x / 7.0, y / 7.0) +
           0.012 * noise(mix(seed, 12), x / 0.9, y / 0.9);
}

Formation compose_site(const SiteShape& site, std::uint64_t seed) {
    const DemoSize size = size_of(site);
    Draw draw(seed, 100);
    std::vector<PhasePlan> phases = backbone(site, size);
    const bool split = size == DemoSize::Medium || size == DemoSize::Large;
    const int frame = 2 + site.phases + (split ? 1 : 0); // natural, topsoil, spreads, a second number
    add_more(phases, site.units - frame - units_in(phases), draw);

    SiteComposer composer(site, seed);
    composer.natural();
    for (int phase = 0; phase < site.phases; ++phase) {
        const double share = static_cast<double>(phase + 1) / site.phases;
        composer.spread(phase, site.natural + share * (site.last - site.natural), split && phase == site.phases - 1);
        for (const FeaturePlan& feature : phases[static_cast<std::size_t>(phase)]) composer.feature(feature, phase);
    }
    composer.topsoil();
    return composer.finish();
}

} // namespace planum::app::demo
