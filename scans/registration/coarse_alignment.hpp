// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/rigid.hpp"
#include "scans/registration/features.hpp"

namespace planum::scans {

/// Two features that look alike.
struct FeatureMatch {
    std::uint32_t target = 0;
    std::uint32_t source = 0;
    double ratio = 1.0; ///< of the distance to the best to that of the second best descriptor

    friend bool operator==(const FeatureMatch&, const FeatureMatch&) = default;
};

struct CoarseOptions {
    double ratio = 0.85;            ///< Lowe's ratio test: more is left out
    double noise = 0.03;            ///< σ of a feature's place [m] …
    double noise_per_range = 0.004; ///< … and so much more for every metre from the scanner
    double gate = 3.0;              ///< in σ: what counts as an inlier
    double min_distance = 1.5;      ///< between the three places of one trial [m]
    double max_tilt = 0.2;          ///< between the upward axes of both scans [rad]; π: any
    int trials = 20'000;            ///< at most
    int min_inliers = 10;           ///< fewer are refused
    double min_spread = 0.7;        ///< of the inliers along their second axis, root mean square [m]; less is refused
    std::uint64_t seed = 1;
};

struct CoarseResult {
    bool is_accepted = false;
    geometry::Rigid3 target_from_source;
    int matches = 0; ///< that passed the ratio test
    int inliers = 0;
    double rms = 0.0; ///< of the inliers [m]
    /// Of the six numbers of geometry::moved, from the stated noise of the places. Only if accepted.
    geometry::Matrix6 covariance = geometry::Matrix6::Zero();
    std::string verdict; ///< one sentence; if refused, why
};

/// Features of the same channel that look most alike in both directions and pass the ratio test; ordered by source.
/// Against second bests on the very same spot (within 3 px) a match is not tested.
[[nodiscard]] std::vector<FeatureMatch> match_features(const FeatureSet& target, const FeatureSet& source,
                                                       double ratio);

/// RANSAC (Fischler and Bolles 1981) on triples of matches whose places are congruent and far from each other, then
/// least squares on all inliers, repeated until they no longer change. Same seed, same bits.
[[nodiscard]] CoarseResult align_features(const FeatureSet& target, const FeatureSet& source,
                                          std::span<const FeatureMatch> matches, const CoarseOptions& options = {});

/// Both in one.
[[nodiscard]] CoarseResult align_coarsely(const FeatureSet& target, const FeatureSet& source,
                                          const CoarseOptions& options = {});

} // namespace planum::scans
