// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/geometry/rigid.hpp"

namespace planum::scans {

/// A marker as the total station or the scanner measured it.
struct Marker {
    std::string name;
    Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< [m], in site or in scan
};

struct MarkerOptions {
    double survey_sigma = 0.001; ///< of one surveyed coordinate [m]
    double scan_sigma = 0.001;   ///< of one coordinate measured in the scan [m]
};

/// What became of one marker of the scan.
struct MarkerResidual {
    std::string name;
    bool is_used = false;
    /// x_in_site of the scan's measurement minus the survey [m]; zero if there is nothing to compare.
    Eigen::Vector3d residual = Eigen::Vector3d::Zero();
    std::string reason; ///< why it was left out, in words; empty if used
};

struct MarkerPlacement {
    bool is_placed = false;
    geometry::Rigid3 site_from_scan;
    /// Of the six numbers of geometry::moved [rad, m], from the two sigmas; larger if the residuals are.
    geometry::Matrix6 covariance = geometry::Matrix6::Zero();
    double rms = 0.0; ///< of the distances of the used markers [m]
    int used = 0;
    std::vector<MarkerResidual> residuals; ///< one a marker of the scan, in their order
    std::string verdict;                   ///< one sentence; if not placed, why
};

/// Places a scan by markers with the same name in both lists: the largest set of at least three markers that
/// agree within their sigmas (χ², 99.9 %) is fitted; the others are named with the reason, a swap or a
/// mistaken name recognised by where the marker lies. Never guesses: too few, nearly collinear or
/// ambiguous markers leave the scan unplaced with a verdict. Throws BadInput for sigmas not above zero.
[[nodiscard]] MarkerPlacement place_by_markers(std::span<const Marker> survey, std::span<const Marker> in_scan,
                                               const MarkerOptions& options = {});

} // namespace planum::scans
