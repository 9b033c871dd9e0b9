// SPDX-License-Identifier: MIT
#pragma once

#include "scans/registration/fine_alignment.hpp"

namespace planum::scans {

/// What is believed of the range offset before anything was compared: none, within this σ [m]. 0: none at all.
void add_range_prior(NormalEquations& equations, double range_offset, double sigma);

/// Gauss-Newton step, damped so little that only a direction nobody votes on stands still.
[[nodiscard]] AlignmentVector damped_step(const NormalEquations& equations);

struct LinkStatistics {
    geometry::Matrix6 covariance = geometry::Matrix6::Zero(); ///< infinite if it cannot be told
    double rms = 0.0;                                         ///< [m]
};

/// Covariance from how the pose would move if one block of ground after the other did not vote (the jackknife over
/// clusters, Efron and Tibshirani 1993), around the slope of the robust votes (Huber 1981). What the range offset
/// leaves open is part of it.
[[nodiscard]] LinkStatistics link_statistics(const SurfelCloud& target, const SurfelCloud& source,
                                             const geometry::Rigid3& target_from_source, double range_offset,
                                             std::span<const SurfelMatch> matches, const PatchMap& map,
                                             const FineOptions& options);

/// Measures overlap and agreement at the final pose and decides: accepted, or refused and why.
void judge_link(FineResult& result, const PreparedScan& target, const PreparedScan& source,
                const geometry::Rigid3& start, bool has_votes, const FineOptions& options);

} // namespace planum::scans
