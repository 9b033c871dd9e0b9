// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/demo/simulator_shapes.hpp"
#include "core/model/unit.hpp"

namespace planum::app::demo {

/// Position of a unit in Formation::units, which is the order of formation: earliest first.
using UnitNo = int;
inline constexpr UnitNo kAir = -1;

/// What happened once: something was laid down, dug away or built.
struct FormationEvent {
    enum class Type { Deposit, Cut, Structure };

    Type type = Type::Deposit;
    UnitNo unit = 0;
    Bounds bounds;
    HeightTable top;      ///< deposit: everything empty below it becomes this unit
    UnitNo within = kAir; ///< deposit: only what that cut had emptied; structure: where its footing may be
    double side_x = 0.0;  ///< deposit: only where side * (x - side_x) > 0, unless side is 0
    int side = 0;
    CutShape cut;
    WallShape wall;
};

/// A unit as it came to be; numbers are given later, in the order in which a digger meets them.
struct FormedUnit {
    std::string number;
    model::UnitKind kind = model::UnitKind::Deposit;
    model::UnitForm form = model::UnitForm::Layer;
    std::string title;
    int phase = 0;        ///< 0 = earliest
    int feature = -1;     ///< units of one pit, wall or post-hole share it
    UnitNo cut = kAir;    ///< of a fill: its cut
    UnitNo twin = kAir;   ///< the unit it is same_as
    UnitNo bonded = kAir; ///< the wall it was built with
    bool thin = false;    ///< a floor
};

/// What is at a point: the unit, and the last cut that had emptied the point before.
struct Body {
    UnitNo unit = kAir;
    UnitNo cut = kAir;

    friend bool operator==(const Body&, const Body&) = default;
};

/// The ground as it is before the dig: every point of space has a unit or is air. Invariant: events in the
/// order in which they happened; the index is built.
class Formation {
  public:
    Formation() = default;
    Formation(std::vector<FormationEvent> events, std::vector<FormedUnit> units, const Bounds& extent);

    [[nodiscard]] Body body_at(const Vec3& p) const noexcept;

    /// The structure of which something lies straight above the point, be it earth or stone; kAir: none.
    [[nodiscard]] UnitNo wall_over(const Vec3& p) const noexcept;

    [[nodiscard]] const std::vector<FormedUnit>& units() const noexcept { return units_; }

    [[nodiscard]] std::vector<FormedUnit>& units() noexcept { return units_; }

    [[nodiscard]] const std::vector<FormationEvent>& events() const noexcept { return events_; }

    /// The box inside which body_at() is meaningful [m].
    [[nodiscard]] const Bounds& extent() const noexcept { return extent_; }

  private:
    [[nodiscard]] const std::vector<std::uint16_t>& events_near(double x, double y) const noexcept;

    std::vector<FormationEvent> events_;
    std::vector<FormedUnit> units_;
    Bounds extent_;
    std::size_t bucket_columns_ = 0;
    std::size_t bucket_rows_ = 0;
    std::vector<std::vector<std::uint16_t>> buckets_;
};

} // namespace planum::app::demo
