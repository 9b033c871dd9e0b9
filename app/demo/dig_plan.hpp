// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/dig_columns.hpp"
#include "core/model/place.hpp"

namespace planum::app::demo {

/// Number of a surface from 0; also "gone from this surface on".
using SurfaceNo = int;
inline constexpr SurfaceNo kSide = 254;  ///< stands in the side of the trench, never dug
inline constexpr SurfaceNo kNever = 255; ///< within reach, but left in the ground

/// Dug too deep by mistake: a shallow bowl into what lay below.
struct OverdugPatch {
    bool made = false;
    SurfaceNo surface = 0;
    Vec3 centre;
    Vec3 radii;

    [[nodiscard]] bool holds(const Vec3& p) const noexcept;
};

/// Earth that came down from the side on one day and was carried off before the next scan.
struct Slump {
    bool fell = false;
    SurfaceNo surface = 0;
    double x = 0.0;
    double y = 0.0;      ///< of the foot of the side
    double half_x = 0.8; ///< along the side [m]
    double half_y = 0.7; ///< into the trench [m]
    double floor = 0.0;  ///< [m, site]
    double height = 0.35;

    [[nodiscard]] bool holds(const Vec3& p) const noexcept;
};

/// A pit of which first one half was emptied, then the other.
struct HalfSection {
    UnitNo cut = kAir;
    double x = 0.0;
    double y = 0.0;
    double normal_x = 0.0; ///< towards the half that goes first
    double normal_y = 1.0;
    SurfaceNo first = 0; ///< surface on which the first half is empty
};

/// What was taken away when. Invariant: what was gone on one surface is gone on all later ones.
struct DigPlan {
    model::DigMethod method = model::DigMethod::Stratigraphic;
    SurfaceNo surfaces = 4;
    std::vector<SurfaceNo> out;      ///< per unit: gone at the latest; kNever: by levels only, or not at all
    std::vector<HeightTable> levels; ///< per surface, where the method has levels
    double baulk_low = 0.0;          ///< strip of x that goes last; empty when not low < high
    double baulk_high = 0.0;
    OverdugPatch overdug;
    Slump slump;
    HalfSection half;
    std::vector<UnitNo> late;      ///< cuts whose fills are drawn only from the second surface on
    std::vector<std::string> days; ///< ISO date of each surface
    SiteShape site;
    std::uint64_t seed = 0;

    [[nodiscard]] bool in_baulk(double x) const noexcept { return x > baulk_low && x < baulk_high; }

    [[nodiscard]] bool has_levels() const noexcept { return method != model::DigMethod::Stratigraphic; }

    /// Height below which the side of the trench begins at (x, y).
    [[nodiscard]] double side_height(double x, double y) const noexcept;
    /// Surface from which on the point, being of that unit, is gone, if there were no baulk. Earth under a wall goes
    /// with the wall at the earliest: nobody digs away what a wall stands on.
    [[nodiscard]] SurfaceNo gone_without_baulk(const Formation& formation, UnitNo unit, const Vec3& p) const noexcept;
    /// Surface from which on the point, being of that unit, is gone.
    [[nodiscard]] SurfaceNo gone_on(const Formation& formation, UnitNo unit, const Vec3& p) const noexcept;

  private:
    [[nodiscard]] SurfaceNo dug_on(const FormedUnit& formed, UnitNo unit, const Vec3& p) const noexcept;
};

[[nodiscard]] DigPlan plan_dig(const SiteShape& site, const Formation& formation, const ColumnGrid& grid,
                               const std::vector<Contact>& contacts, model::DigMethod method, std::uint64_t seed);

/// The day `offset` days after `first` (both ISO).
[[nodiscard]] std::string day_after(const std::string& first, int offset);

} // namespace planum::app::demo
