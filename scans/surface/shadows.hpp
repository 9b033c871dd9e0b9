// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "scans/surface/sight_rules.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

/// What one scan saw of each cell [m]; not a number where nothing.
struct ScanSight {
    std::vector<float> top;
    std::vector<float> bottom;
    double spacing = 0.0; ///< from one cell with points to the next, where the scan saw the ground [m]
    double widened = 0.0; ///< cells so near to such a cell count as seen, or sparse points would be seen through [m]
};

/// Takes the cells around those with points for seen as far as points usually lie apart.
void widen(const GridFrame& frame, ScanSight& seen);

/// Share of the cells that hold points, around the middle one of all that do.
[[nodiscard]] double usual_share(const GridFrame& frame, const std::vector<float>& top);

/// The line of sight over an edge, where it passes a cell behind it.
struct SightLine {
    double height = 0.0; ///< [m]
    double fall = 0.0;   ///< tangent, downwards
};

/// What lies hidden behind edges from where a scan was made. Keeps references to all that it is given.
class Shadows {
  public:
    /// Behind `near_sides` nothing is looked for: what lies before a side that only others saw may belong to the edge.
    Shadows(const GridFrame& frame, const ScanSight& seen, const std::vector<bool>& near_sides,
            const Eigen::Vector3d& station, const SightRules& rules);

    /// Whether what the scan saw could be seen from the station: few of its cells lie in the shadow of others.
    [[nodiscard]] bool are_of_one_station() const;

    /// The line of sight over a cell, where it lies in a shadow.
    [[nodiscard]] std::optional<SightLine> over(std::int32_t row, std::int32_t column) const;

    /// Whether the next two cells that the scan saw behind this one lie at that height: ground goes on there.
    [[nodiscard]] bool goes_on_at(double height, std::int32_t row, std::int32_t column) const;

  private:
    struct Way {
        double distance = 0.0; // of a cell from the station, in plan [m]
        double east = 0.0;     // unit vector away from the station
        double north = 0.0;
    };

    struct Met {
        std::size_t cell = 0;
        double distance = 0.0; // in plan [m]
    };

    enum class Sides { Pass, Stop };

    [[nodiscard]] Way way_to(std::int32_t row, std::int32_t column) const;
    [[nodiscard]] std::optional<double> highest_line(std::int32_t row, std::int32_t column) const;
    [[nodiscard]] std::optional<std::size_t> cell_at(std::int32_t row, std::int32_t column, double east,
                                                     double north) const;
    [[nodiscard]] std::optional<Met> first_seen(std::int32_t row, std::int32_t column, const Way& way,
                                                Sides sides) const;

    const GridFrame& frame_;
    const ScanSight& seen_;
    const std::vector<bool>& near_sides_;
    const Eigen::Vector3d& station_;
    const SightRules& rules_;
};

} // namespace planum::scans
