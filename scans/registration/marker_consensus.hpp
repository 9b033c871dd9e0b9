// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/fit_rigid.hpp"

namespace planum::scans {

/// A set of markers that agree, with their fit.
struct MarkerSet {
    std::vector<std::size_t> members; ///< ascending
    geometry::RigidFit fit;
    double chi_square = 0.0;
};

struct MarkerConsensus {
    std::vector<MarkerSet> agreeing; ///< the largest sets that agree, best first; empty if none does
    bool any_spread = false;         ///< false: all sets tried lie on a line, as far as the sigmas tell
};

/// The largest sets of pairs, three at least, that agree within sigma [m] (one coordinate of one
/// difference). All subsets are tried up to 12 pairs; beyond that the sets that grow out of triples.
[[nodiscard]] MarkerConsensus agreeing_markers(std::span<const Eigen::Vector3d> x_in_scan,
                                               std::span<const Eigen::Vector3d> x_in_site, double sigma);

/// True if the points lie too close to one line for a pose at this sigma [m].
[[nodiscard]] bool is_nearly_a_line(const geometry::RigidFit& fit, double sigma);

} // namespace planum::scans
