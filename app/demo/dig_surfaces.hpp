// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "app/demo/dig_plan.hpp"
#include "core/model/place.hpp"

namespace planum::app::demo {

/// A piece of a column that is one unit and goes at one time.
struct DugRun {
    float low = 0.0F;
    float high = 0.0F;
    std::int16_t unit = 0;
    std::int16_t cut = kAir;
    std::uint8_t gone = kNever; ///< surface from which on it is gone
    std::uint8_t due = kNever;  ///< when it would be gone if it were not in a baulk
};

/// The columns of a ColumnGrid, cut where the dig cut them.
class DugGrid {
  public:
    DugGrid(const ColumnGrid& grid, const Formation& formation, const DigPlan& plan);

    [[nodiscard]] std::span<const DugRun> at(std::size_t index) const noexcept {
        return {runs_.data() + first_[index], first_[index + 1] - first_[index]};
    }

  private:
    std::vector<std::size_t> first_;
    std::vector<DugRun> runs_;
};

/// What lies bare in one cell of a surface.
struct SurfaceCell {
    enum class Shown : std::uint8_t { Nothing, Top, Level, Cut, Overdug, Baulk, Slump };

    float z = 0.0F;
    std::int16_t unit = kAir; ///< the unit, or the cut whose side or bottom it is
    Shown shown = Shown::Nothing;

    friend bool operator==(const SurfaceCell&, const SurfaceCell&) = default;
};

/// One surface of the dig, cell by cell in the order of the grid.
using SurfaceMap = std::vector<SurfaceCell>;

/// What lies bare, as it is. Needs the plan's slump to have its floor.
[[nodiscard]] SurfaceMap map_surface(const ColumnGrid& grid, const DugGrid& dug, const DigPlan& plan,
                                     SurfaceNo surface);

/// What the digger recognises: features seen too late are their surroundings on the first surface on which
/// they show.
void forget_late_features(std::vector<SurfaceMap>& maps, const ColumnGrid& grid, const Formation& formation,
                          const DigPlan& plan);

/// Lets the slump come to lie on the ground of its day.
void settle_slump(DigPlan& plan, const ColumnGrid& grid, const DugGrid& dug);

/// Earth taken away between two surfaces [m³], by unit and the surface on which it is gone.
using DugVolumes = std::map<std::pair<UnitNo, SurfaceNo>, double>;

[[nodiscard]] DugVolumes dug_volumes(const ColumnGrid& grid, const DugGrid& dug, const DigPlan& plan);

/// Where u lay bare and on the next surface, lower, another unit v: area in plan [m²] and the first pair of
/// surfaces; the contact that surfaces can prove.
struct SeenContact {
    double area = 0.0;
    SurfaceNo from = 0;
    SurfaceNo to = 0;
    double shared_outline = 0.0; ///< longest common outline on one surface [m]
};

using SeenContacts = std::map<std::pair<UnitNo, UnitNo>, SeenContact>;

[[nodiscard]] SeenContacts seen_contacts(const std::vector<SurfaceMap>& maps, const ColumnGrid& grid);

} // namespace planum::app::demo
