// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/geometry/rigid.hpp"

namespace planum::scans {

/// Two scans aligned to each other.
struct NetworkLink {
    std::size_t target = 0;
    std::size_t source = 0;
    geometry::Rigid3 target_from_source;
    geometry::Matrix6 covariance = geometry::Matrix6::Identity(); ///< in the numbers of geometry::moved
};

/// What is known of a scan's place on the site grid without the links.
struct NetworkAnchor {
    std::size_t scan = 0;
    geometry::Rigid3 site_from_scan;
    geometry::Matrix6 covariance = geometry::Matrix6::Zero();
    bool is_held = false; ///< an earlier accepted pose: it does not move. Else measured by markers
};

struct NetworkOptions {
    /// A link or marker set that contradicts the rest by more than this many standard deviations is left out; the
    /// limit of six numbers at 99.9 % is 4.74. Statements of σ are themselves good to some tens of percent.
    double most_error = 6.0;
};

struct NetworkPose {
    geometry::Rigid3 site_from_scan;
    geometry::Matrix6 covariance = geometry::Matrix6::Zero(); ///< on the site grid, the anchors' own share included
    /// Of the pose relative to its anchors: what the links alone leave open.
    geometry::Matrix6 link_covariance = geometry::Matrix6::Zero();
};

/// What became of a link or an anchor.
struct NetworkCheck {
    bool is_used = false;
    double before = 0.0; ///< error along the best chain of links, in standard deviations
    double after = 0.0;  ///< error after all were relaxed, in standard deviations
    double shift = 0.0;  ///< that remains after [m]
    double turn = 0.0;   ///< that remains after [rad]
    std::string reason;  ///< if not used, why
};

struct NetworkResult {
    std::vector<std::optional<NetworkPose>> poses; ///< one a scan; nullopt: hangs on no anchor
    std::vector<NetworkCheck> links;
    std::vector<NetworkCheck> anchors;
    double cost_before = 0.0;
    double cost_after = 0.0;
};

/// Puts all scans on the site grid at once: one pose graph over all links and anchors. What contradicts the rest
/// is left out, the worst first, as long as the rest still says where the scan is; every pose carries its covariance.
/// Scans that hang on no anchor stay without a pose.
[[nodiscard]] NetworkResult solve_network(std::size_t scans, std::span<const NetworkLink> links,
                                          std::span<const NetworkAnchor> anchors, const NetworkOptions& options = {},
                                          Progress& progress = Progress::none());

/// Covariance of a pose that is carried along rigidly when another one errs, both on the site grid.
[[nodiscard]] geometry::Matrix6 carried_covariance(const geometry::Matrix6& covariance, const Eigen::Vector3d& from,
                                                   const Eigen::Vector3d& to);

} // namespace planum::scans
