// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/geometry/rigid.hpp"
#include "scans/registration/patch_votes.hpp"

namespace planum::scans {

/// One step of the schedule from coarse to fine.
struct AlignmentLevel {
    double voxel = 0.02;       ///< cube edge of the thinned scan [m]
    double max_distance = 0.1; ///< to the nearest surfel [m]
    double blur = 0.0;         ///< how wrong the pose may still be [m]
    int max_iterations = 15;
};

struct FineOptions {
    /// Voxels must not grow from level to level.
    std::vector<AlignmentLevel> levels{
        {0.20, 0.60, 0.10, 20}, {0.08, 0.25, 0.03, 15}, {0.02, 0.25, 0.008, 10}, {0.02, 0.25, 0.0, 15}};
    std::size_t max_surfels = 200'000; ///< of a scan at one level; its voxel grows until it holds
    int neighbours = 24;               ///< points that make the plane of a surfel
    double patch = 0.4;                ///< edge of the pieces in which ground votes [m]
    double min_overlap = 0.12;         ///< share of the source with a partner, less is refused
    double min_stable = 0.5;           ///< share of the judged pieces of ground that stands still, less is refused
    double min_agreement = 0.35;       ///< share of it that agrees where there is ground, less is refused
    double max_sigma_position = 0.02;  ///< of the scanner, in the worst direction [m]; more is refused
    double max_sigma_rotation = 0.01;  ///< about the worst axis [rad]; more is refused
    /// What no scatter of the ground shows, added to the covariance; sizes as seen between simulated scans of known
    /// pose, see docs/registration.md.
    double systematic_position = 1e-5; ///< [m]
    double systematic_rotation = 1e-6; ///< [rad]
    /// How much too long or short all ranges of a scanner may be (its additive constant, see Lichti 2007) [m]. It is
    /// found along with the pose, one for both scans, because it lifts ground seen from above more than ground seen
    /// at a slant, and so leans scans that face each other. 0: none is looked for.
    double range_offset_sigma = 0.002;
    double max_shift = 1.0;                            ///< from the start [m]; more is refused
    double max_turn = 20.0 * std::numbers::pi / 180.0; ///< from the start [rad]; more is refused
    int threads = 2;                                   ///< does not change the result
};

/// A scan thinned for every level; made once, used for all its pairs.
struct PreparedScan {
    std::vector<SurfelCloud> clouds;   ///< from coarse to fine, one a different voxel
    std::vector<std::size_t> cloud_of; ///< level → cloud
    std::size_t points = 0;            ///< finite ones that went in
};

/// Points in the frame of the scanner, which stands at the origin. Throws BadInput for options that make no
/// sense or points spread too far.
[[nodiscard]] PreparedScan prepare_scan(std::span<const Eigen::Vector3d> x_in_scan, const FineOptions& options = {});

struct FineResult {
    bool is_accepted = false;
    geometry::Rigid3 target_from_source; ///< of the last step even if refused
    /// Of the six numbers of geometry::moved [rad, m]; from the scatter of whole patches, so that points that
    /// err together count once. Only if accepted.
    geometry::Matrix6 covariance = geometry::Matrix6::Zero();
    geometry::Matrix6 information = geometry::Matrix6::Zero(); ///< its inverse
    double range_offset = 0.0;                                 ///< by which all ranges are too long [m]
    double rms = 0.0;                                          ///< of the distances along the normals of what votes [m]
    double overlap = 0.0;   ///< share of the source with the same ground in the target, 0…1
    double agreement = 0.0; ///< share of it that is the same where the target has ground at all, 0…1
    double scatter = 0.0;   ///< of patches beyond their noise, one σ [m]
    int iterations = 0;
    std::vector<Patch> patches; ///< which ground voted, in target
    std::string verdict;        ///< one sentence; if refused, why
};

/// Fine alignment from a start value good to about the first level's distance. Same bits for any number of
/// threads. What does not overlap, does not agree or leaves a direction open is refused, not forced.
[[nodiscard]] FineResult align_scans(const PreparedScan& target, const PreparedScan& source,
                                     const geometry::Rigid3& start, const FineOptions& options = {},
                                     Progress& progress = Progress::none());

} // namespace planum::scans
