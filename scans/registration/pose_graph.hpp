// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/geometry/rigid.hpp"

namespace planum::scans {

/// A measured relative pose between two scans.
struct PoseLink {
    std::size_t target = 0; ///< index of the pose
    std::size_t source = 0;
    geometry::Rigid3 target_from_source;
    /// Inverse covariance in the six numbers of geometry::moved, in target axes.
    geometry::Matrix6 information = geometry::Matrix6::Identity();
};

struct PoseNode {
    geometry::Rigid3 site_from_scan; ///< start value; result
    bool is_fixed = false;
};

struct PoseGraphOptions {
    int max_iterations = 100;
    double tolerance = 1e-10; ///< relative fall of the cost at which it stops
    /// Huber limit of a link's error in standard deviations; 0: least squares.
    double huber = 0.0;
    bool with_covariances = true;
};

struct LinkError {
    double before = 0.0; ///< standard deviations, root of eᵀ Ω e
    double after = 0.0;
    double shift = 0.0; ///< that remains [m]
    double turn = 0.0;  ///< that remains [rad]
};

struct PoseGraphResult {
    std::vector<geometry::Rigid3> site_from_scan;
    /// Marginal, of the six numbers of geometry::moved; zero for fixed poses; empty unless asked for.
    std::vector<geometry::Matrix6> covariance;
    std::vector<LinkError> links;
    double cost_before = 0.0; ///< see relax_poses
    double cost_after = 0.0;
    int iterations = 0;
    bool has_converged = false;
};

/// Relaxes all poses at once: the cost is Σ ρ(eᵀ Ω e) over the links with e = geometry::step_between(measured,
/// predicted target_from_source): the rotation error as log of SO(3), the translation in target axes; ρ is
/// Huber or none. Levenberg-Marquardt on SO(3) × R³ with sparse Cholesky; the cost never rises. Throws
/// BadInput if a pose hangs on no fixed one (naming its index), links point nowhere, or numbers are not
/// finite.
[[nodiscard]] PoseGraphResult relax_poses(std::span<const PoseNode> nodes, std::span<const PoseLink> links,
                                          const PoseGraphOptions& options = {}, Progress& progress = Progress::none());

/// Start values along a spanning tree of the links, breadth first from the fixed poses; poses that hang on none
/// keep theirs.
[[nodiscard]] std::vector<PoseNode> spread_from_fixed(std::span<const PoseNode> nodes, std::span<const PoseLink> links);

/// Error of one link in standard deviations.
[[nodiscard]] double link_error(const PoseLink& link, const geometry::Rigid3& site_from_target,
                                const geometry::Rigid3& site_from_source);

} // namespace planum::scans
