// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "core/model/record.hpp"

namespace planum::model {

/// Scanners reach some ten metres over a trench; an outline farther from all their set-ups is a slip of coordinates.
inline constexpr double kFarthestOutline = 100.0; // [m]

/// What is said of an outline that is so far away: `reaches 6513 km away from …`.
[[nodiscard]] std::string astray_words(double distance);

/// The box around all set-ups of the scans that are placed, in plan of the site.
class ScannedBox {
  public:
    explicit ScannedBox(const Record& record);

    /// How far the farthest corner of an outline lies outside of the box [m]; 0 inside, and where no scan is placed.
    [[nodiscard]] double distance(const Region& region) const noexcept;

    /// Whether it lies beyond kFarthestOutline: such outlines would make plans of kilometres.
    [[nodiscard]] bool is_astray(const Region& region) const noexcept { return distance(region) > kFarthestOutline; }

  private:
    std::array<double, 2> low_;
    std::array<double, 2> high_;
};

} // namespace planum::model
