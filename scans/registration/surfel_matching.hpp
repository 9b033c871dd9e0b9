// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/rigid.hpp"
#include "scans/registration/surfels.hpp"

namespace planum::scans {

/// Both: every target surfel looks for its nearest source surfel too. What the choice of the nearest does to
/// the height of rough ground is then the same for both and cancels.
enum class MatchWays : std::uint8_t { Forward, Both };

/// How far surfels may be from each other to be taken for the same ground.
struct MatchOptions {
    double max_distance = 0.1; ///< to the nearest surfel [m]
    /// Added to the spread of both: how wrong the pose may still be [m]. With none, only the distance along
    /// the mean of both normals counts.
    double blur = 0.0;
    double least_facing = 0.0; ///< cosine between the two normals, less is other ground
    double gate = 4.0;         ///< largest distance in standard deviations that still votes
    MatchWays ways = MatchWays::Forward;
    int threads = 2;
    double range_offset = 0.0; ///< by which all ranges of both scans are taken to be too long [m]
    /// Takes the pairs that `matches` holds, made with the same clouds and ways, instead of looking for the nearest
    /// anew: what costs most, and the same while the pose moves by little of the spacing.
    bool keep_pairs = false;
};

enum class MatchKind : std::uint8_t {
    None,     ///< not flat, or nothing near
    Disagree, ///< ground near, but not the same
    Agree,
};

struct SurfelMatch {
    std::uint32_t target = 0;
    std::uint32_t source = 0;
    MatchKind kind = MatchKind::None;
    double weight = 0.0; ///< robust, 0…1, without that of the patch
    /// Of the variance, what is the pair's own, 0…1: a surfel that is the nearest of several errs with all of them.
    double share = 1.0;
    double offset = 0.0;   ///< signed distance along the normal of the target [m]
    double variance = 0.0; ///< that the two surfels state for it, divided by the share [m²]
};

/// The six numbers of geometry::moved, then the range offset [m].
using AlignmentVector = Eigen::Matrix<double, 7, 1>;
using AlignmentMatrix = Eigen::Matrix<double, 7, 7>;

/// The normal equations of one Gauss-Newton step.
struct NormalEquations {
    AlignmentMatrix information = AlignmentMatrix::Zero();
    AlignmentVector gradient = AlignmentVector::Zero();
    double cost = 0.0;
    double votes = 0.0; ///< sum of the weights

    NormalEquations& operator+=(const NormalEquations& other);
};

/// What one pair of surfels adds, with weight 1.
[[nodiscard]] NormalEquations equations_of(const Surfel& target, const Surfel& source,
                                           const geometry::Rigid3& target_from_source, double blur,
                                           double range_offset);

/// Plane-to-plane (Segal, Haehnel, Thrun 2009) with covariances in metres: every source surfel against its
/// nearest target surfel, weighted by Geman-McClure within the gate, times the weight of its target's
/// patch (patch_of[target surfel] → patch_weight; both empty: 1). With blur the range offset has no vote. Fills
/// `matches`: one a source surfel, then, if asked for, one a target surfel.
[[nodiscard]] NormalEquations match_surfels(const SurfelCloud& target, const SurfelCloud& source,
                                            const geometry::Rigid3& target_from_source, const MatchOptions& options,
                                            std::span<const std::uint32_t> patch_of,
                                            std::span<const double> patch_weight, std::vector<SurfelMatch>& matches);

} // namespace planum::scans
