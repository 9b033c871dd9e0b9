// SPDX-License-Identifier: MIT
#pragma once

namespace planum::scans {

struct SightRules {
    double farthest = 2.5;    ///< shadows reach no farther in plan [m]
    double least_drop = 0.08; ///< from what throws a shadow to what is seen behind it [m]; less is a gap between points
    double around = 0.3;      ///< how many cells hold points is told from those within so much [m]
    double share = 0.3;       ///< of them must lie as a cell does, or it is a stray
    double fewest = 3.0;      ///< and so many at least
    double rough = 0.02;      ///< cells lie alike that differ by no more [m]
    double slope = 0.5;       ///< and by so much for each metre from one to the other
    int alone = 4; ///< cells with points within 6 cm, itself among them, are no more than this: a stray alone
    double alone_share = 0.2;  ///< nor than this share of what is usual
    double ground_near = 1.5;  ///< it hangs over ground within so much [m]; gaps are closed from no farther
    double hangs = 0.08;       ///< that is lower by so much [m], and by `slope` times its distance
    double grazing = 0.03;     ///< no lower under a line of sight than this is on it [m]
    double beside_side = 0.04; ///< points of a side lie no farther apart than twice this [m]
    double hidden = 0.05; ///< share of what a scan saw that may lie in its own shadows, or it is none of one station
};

} // namespace planum::scans
