// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/simulator_composition.hpp"
#include "app/demo/simulator_random.hpp"

namespace planum::app::demo {

enum class FeatureType { Wall, WallPair, Floor, PostHole, Pit, BellPit, Ditch, Mound };

struct FeaturePlan {
    FeatureType type = FeatureType::Pit;
    int fills = 1;
};

/// How many units such a feature is.
[[nodiscard]] int units_in(const FeaturePlan& feature) noexcept;

/// Builds a site event by event. Invariant: `soil_` is the ground as it lies now, structures left out.
class SiteComposer {
  public:
    SiteComposer(const SiteShape& site, std::uint64_t seed);

    void natural();
    /// One spread over the whole trench; split in two numbers by a line where `split`.
    void spread(int phase, double mean_height, bool split);
    void feature(const FeaturePlan& plan, int phase);
    void topsoil();

    [[nodiscard]] Formation finish();

  private:
    struct Circle {
        double x;
        double y;
        double radius;
        int phase;
        bool wall;
    };

    UnitNo add_unit(model::UnitKind kind, model::UnitForm form, std::string title, int phase);
    UnitNo add_deposit(HeightTable top, FormedUnit unit, UnitNo within = kAir);
    UnitNo add_cut(const CutShape& shape, std::string title, int phase);
    UnitNo add_wall(const WallShape& shape, UnitNo cut, int phase);
    void add_fills(const CutShape& shape, UnitNo cut, int fills, int phase);
    /// Raises the ground where `top` is above it; where it is not, `top` is lowered out of the way.
    void settle(HeightTable& top);
    [[nodiscard]] Circle find_place(double radius, int phase);
    [[nodiscard]] CutShape foundation(double x, double y, double axis_x, double axis_y, double half_length);
    [[nodiscard]] WallShape wall_on(const CutShape& trench);

    void wall(bool pair, int phase);
    void floor(int phase);
    void post_hole(int phase);
    void pit(bool bell, int fills, int phase);
    void ditch(int fills, int phase);
    void mound(int phase);

    SiteShape site_;
    std::uint64_t seed_;
    Draw draw_;
    HeightTable soil_;
    std::vector<FormationEvent> events_;
    std::vector<FormedUnit> units_;
    std::vector<Circle> taken_;
    int features_ = 0;
};

} // namespace planum::app::demo
