// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "app/demo/simulator_formation.hpp"

namespace planum::app::demo {

/// How large the simulated dig is. Tiny is for tests: one pit, one post-hole, one wall on 3 × 2.5 m.
enum class DemoSize { Tiny, Small, Medium, Large };

/// The frame of a dig of one size. Lengths in metres, heights in the site grid.
struct SiteShape {
    Bounds trench; ///< low.z: nothing is dug below; high.z: the turf in the middle
    int days = 4;
    int stations = 2; ///< of the scanner, each day
    int units = 12;
    int phases = 1;       ///< spreads of ground between natural and topsoil
    double natural = 0.0; ///< mean height of the natural's top
    double last = 0.0;    ///< mean height of what lies below the topsoil
    double table_step = 0.025;
    double cell = 0.02; ///< of the columns on which truth is counted
    int scan_columns = 720;
    int scan_rows = 180;
};

[[nodiscard]] SiteShape site_shape(DemoSize size);

/// The turf before the dig, in and around the trench.
[[nodiscard]] double turf_height(const SiteShape& site, std::uint64_t seed, double x, double y) noexcept;

/// Lets a site come to be: natural, then phase by phase spreads, walls, floors, pits, posts, a mound, at
/// last the topsoil. Always exactly `site.units` units.
[[nodiscard]] Formation compose_site(const SiteShape& site, std::uint64_t seed);

} // namespace planum::app::demo
