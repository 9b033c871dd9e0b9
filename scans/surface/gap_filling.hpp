// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/gpb.hpp"
#include "scans/surface/sight_lines.hpp"
#include "scans/surface/surface_grid.hpp"

namespace planum::scans {

struct GapOptions {
    double reach = 1.5;         ///< cells farther than this from any ground stay unknown [m]
    double fence_gap = 0.2;     ///< faces no farther apart than this are one side, where no ground is between [m]
    double doubt = 0.1;         ///< σ of a filled height for each metre from the ground it was taken from
    float shadow_doubt = 0.2F;  ///< σ in a shadow for each metre between the line of sight and what was filled in
    float planum_doubt = 0.05F; ///< most σ of what was filled in on an artificial level: somebody made it level [m]
    SightRules sight;
};

/// The height of a hollow's floor, measured by other means than the scans, as with a level or a total station.
struct SpotHeight {
    double x = 0.0; ///< in site [m]
    double y = 0.0;
    double z = 0.0;
    double sigma = 0.02;            ///< [m]
    geometry::MultiPolygon hollow;  ///< the outline of what it is the floor of, in plan of the site
    bool is_under_overhang = false; ///< its sides recede (find_overhangs()): no side goes on down to the floor
};

/// What is known of the ground of a surface besides its scans.
struct KnownGround {
    std::vector<SpotHeight> spots = {};
    std::vector<geometry::MultiPolygon> plana =
        {}; ///< outlines of what shows of artificial levels, in plan of the site
};

/// Heights of a surface with its gaps closed.
struct FilledHeights {
    GridFrame frame;
    std::vector<float> height;       ///< NaN where unknown
    std::vector<float> sigma;        ///< of what was filled in; 0 where ground was seen [m]
    std::vector<float> shadow_sigma; ///< at least this of what was filled in under a line of sight [m]
    std::vector<float> distance;     ///< from the ground that was seen nearest [m]
    std::vector<bool> was_seen;      ///< Surface or Disputed
    /// Cell of the ground that a height was continued from first; the cell itself where ground was seen, and on sides.
    std::vector<std::uint32_t> source;
    /// What is hollow under the ground of a cell, as far as the sides of a pit were seen to recede [m]. That of a pit
    /// is shared out over its mouth.
    std::vector<float> hollow;
    std::vector<bool> laid; ///< a floor that a spot height says, or what was seen of sides continued down to it
};

/// Closes gaps in the ground, once what hangs in them is left out (drop_hanging()), by a membrane that upright sides
/// cut: what lies in the shadow of a trench wall is continued from the floor, not from the field above it. A cell that
/// a side runs through is divided between the ground on both sides of it by the line on which points of the side lie
/// along it; where none shows the line, halfway. Under a line of sight over a shadow (SurfaceGrid::ceiling) only ground
/// that is no higher is continued. Where a side is several cells wide, its cells lie where their points do.
///
/// Where no scanner looked into a hollow, spot heights say how deep it is (lay_floors()). That floor ends at its
/// outline: what nobody saw beside it is continued from other ground, where there is any. Ground seen within a planum
/// is continued as far as its outline goes, without `reach`: who drew it saw it level behind every baulk. Under the
/// sides of a pit that widens downwards (find_overhangs()) ground lies as high as around; what is hollow there is told
/// beside the heights.
[[nodiscard]] FilledHeights fill_gaps(const SurfaceGrid& grid, const GapOptions& options = {},
                                      const KnownGround& known = {});

} // namespace planum::scans
