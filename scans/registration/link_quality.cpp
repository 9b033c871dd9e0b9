// SPDX-License-Identifier: MIT
#include "scans/registration/link_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "scans/registration/fixed_blocks.hpp"

namespace planum::scans {

using geometry::Matrix6;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double worst_sigma(const Eigen::Matrix3d& covariance) {
    if (!covariance.allFinite()) return std::numeric_limits<double>::infinity();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

// True if the normals leave a shift open: noise alone tilts them by a few hundredths, which must not be taken for
// relief.
bool is_open(const Matrix6& information) {
    constexpr double kLeastShare = 0.001; // of the votes, on the weakest direction
    const Eigen::Matrix3d shift = information.bottomRightCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(shift, Eigen::EigenvaluesOnly);
    return !(solver.eigenvalues()[0] > kLeastShare * shift.trace());
}

void measure_overlap(FineResult& result, const PreparedScan& target, const PreparedScan& source, int threads) {
    // On the coarsest clouds, where points stand for areas; counted within twice what their spacing is.
    const SurfelCloud& coarse_target = target.clouds.back();
    const SurfelCloud& coarse_source = source.clouds.back();
    const double spacing = std::max(coarse_target.voxel, coarse_source.voxel);
    std::vector<SurfelMatch> matches;
    (void)match_surfels(coarse_target, coarse_source, result.target_from_source,
                        {2.0 * spacing, 0.1 * spacing, 0.7, 3.0, MatchWays::Forward, threads}, {}, {}, matches);
    double agree = 0.0;
    double near = 0.0;
    double flat = 0.0;
    for (std::size_t i = 0; i < matches.size(); ++i) {
        flat += coarse_source.surfels[i].is_flat ? 1.0 : 0.0;
        near += matches[i].kind != MatchKind::None ? 1.0 : 0.0;
        agree += matches[i].kind == MatchKind::Agree ? 1.0 : 0.0;
    }
    result.overlap = flat > 0.0 ? agree / flat : 0.0;
    result.agreement = near > 0.0 ? agree / near : 0.0;
}

/// Of the pieces of ground that both scans see well enough.
struct StandingGround {
    int stable = 0;
    int judged = 0;
};

StandingGround standing_ground(const FineResult& result) {
    StandingGround ground;
    for (const auto& patch : result.patches) {
        ground.stable += patch.state == PatchState::Stable ? 1 : 0;
        ground.judged += patch.state != PatchState::Thin ? 1 : 0;
    }
    return ground;
}

// Empty if nothing speaks against the link.
std::string objection(const FineResult& result, const Rigid3& start, bool has_votes, const FineOptions& options) {
    if (!has_votes) return "too little common ground near the start value";
    const Vector6 step = geometry::step_between(start, result.target_from_source);
    if (step.tail<3>().norm() > options.max_shift || step.head<3>().norm() > options.max_turn) {
        return fmt::format("moved {:.2f} m and {:.1f}° away from the start value, {:.2f} m and {:.1f}° are allowed",
                           step.tail<3>().norm(), kDegrees * step.head<3>().norm(), options.max_shift,
                           kDegrees * options.max_turn);
    }
    if (result.overlap < options.min_overlap) {
        return fmt::format("only {:.0f} % of the scan has a partner, {:.0f} % are needed", 100.0 * result.overlap,
                           100.0 * options.min_overlap);
    }
    if (result.agreement < options.min_agreement) {
        return fmt::format("where both scans have ground only {:.0f} % of it agrees, {:.0f} % are needed",
                           100.0 * result.agreement, 100.0 * options.min_agreement);
    }
    // Scans of two sites may lie upon each other here and there, and even say so firmly; those of one mostly agree.
    const StandingGround ground = standing_ground(result);
    if (ground.stable < options.min_stable * ground.judged) {
        return fmt::format("only {} of {} pieces of ground lie where they lay, {:.0f} % are needed", ground.stable,
                           ground.judged, 100.0 * options.min_stable);
    }
    const double turn = worst_sigma(result.covariance.topLeftCorner<3, 3>());
    const double shift = worst_sigma(result.covariance.bottomRightCorner<3, 3>());
    if (!(turn <= options.max_sigma_rotation) || !(shift <= options.max_sigma_position)) {
        return fmt::format("the common ground leaves a direction open: σ {:.1f} mm and {:.3f}°, allowed are {:.1f} mm "
                           "and {:.3f}°",
                           1000.0 * shift, kDegrees * turn, 1000.0 * options.max_sigma_position,
                           kDegrees * options.max_sigma_rotation);
    }
    return {};
}

/// What one block of ground votes for, and how firmly.
struct BlockVote {
    AlignmentVector gradient = AlignmentVector::Zero();
    AlignmentMatrix slope = AlignmentMatrix::Zero();
};

struct Sums {
    std::vector<BlockVote> of_block;
    AlignmentMatrix bread = AlignmentMatrix::Zero();
    AlignmentMatrix slope = AlignmentMatrix::Zero();
    double square = 0.0;
    double votes = 0.0;
};

void hold_range_offset(BlockVote& block) {
    block.gradient[6] = 0.0;
    block.slope.row(6).setZero();
    block.slope.col(6).setZero();
}

// How the pose would move if the block had not voted.
AlignmentVector without(const BlockVote& block, const AlignmentMatrix& slope,
                        const Eigen::LDLT<AlignmentMatrix>& with_all) {
    const Eigen::LDLT<AlignmentMatrix> solver(slope - block.slope);
    const bool is_firm = solver.info() == Eigen::Success && solver.isPositive();
    return is_firm ? solver.solve(block.gradient) : with_all.solve(block.gradient);
}

// The jackknife over blocks, for ground errs by blocks.
Matrix6 covariance_of(const Sums& sums) {
    const Eigen::LDLT<AlignmentMatrix> solver(sums.slope);
    const auto voting = std::count_if(sums.of_block.begin(), sums.of_block.end(),
                                      [](const BlockVote& block) { return block.gradient.squaredNorm() > 0.0; });
    if (voting < 12 || is_open(sums.bread.topLeftCorner<6, 6>()) || solver.info() != Eigen::Success ||
        !solver.isPositive()) {
        return Matrix6::Constant(std::numeric_limits<double>::infinity());
    }
    Matrix6 seen = Matrix6::Zero();
    for (const auto& block : sums.of_block) {
        if (block.gradient.squaredNorm() <= 0.0) continue;
        const Vector6 moved = without(block, sums.slope, solver).head<6>();
        seen += moved * moved.transpose();
    }
    // Which patches vote is itself decided by their offsets; that the jackknife does not see. As measured, see
    // docs/registration.md.
    constexpr double kChosenVotes = 1.25;
    return kChosenVotes * seen;
}

} // namespace

void add_range_prior(NormalEquations& equations, double range_offset, double sigma) {
    if (sigma > 0.0) {
        equations.information(6, 6) += 1.0 / (sigma * sigma);
        equations.gradient[6] += range_offset / (sigma * sigma);
        return;
    }
    equations.information.row(6).setZero();
    equations.information.col(6).setZero();
    equations.information(6, 6) = 1.0;
    equations.gradient[6] = 0.0;
}

AlignmentVector damped_step(const NormalEquations& equations) {
    AlignmentMatrix damped = equations.information;
    damped.diagonal() *= 1.0 + 1e-9;
    damped.diagonal().array() += 1e-9 * equations.information.topLeftCorner<6, 6>().trace() / 6.0 + 1e-30;
    return -damped.ldlt().solve(equations.gradient);
}

LinkStatistics link_statistics(const SurfelCloud& target, const SurfelCloud& source, const Rigid3& target_from_source,
                               double range_offset, std::span<const SurfelMatch> matches, const PatchMap& map,
                               const FineOptions& options) {
    std::vector<NormalEquations> pairs(matches.size());
    for_blocks(matches.size(), options.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (matches[i].kind != MatchKind::Agree) continue;
            const Surfel& t = target.surfels[matches[i].target];
            const Surfel& s = source.surfels[matches[i].source];
            pairs[i] = equations_of(t, s, target_from_source, options.levels.back().blur, range_offset);
        }
    });
    Sums sums;
    sums.of_block.resize(map.blocks);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (matches[i].kind != MatchKind::Agree) continue;
        const auto patch = map.patch_of[matches[i].target];
        const double weight = matches[i].weight * matches[i].share * map.patches[patch].weight;
        if (weight <= 0.0) continue;
        // The derivative of a robust vote w · r is less than w: of Geman-McClure's 4 √w - 3 times that. A twentieth
        // keeps the sum above nothing.
        const double steepness = 4.0 * std::sqrt(matches[i].weight) - 2.95;
        BlockVote& block = sums.of_block[map.block_of[patch]];
        block.gradient += weight * pairs[i].gradient;
        block.slope += weight * steepness * pairs[i].information;
        sums.bread += weight * pairs[i].information;
        sums.square += weight * matches[i].offset * matches[i].offset;
        sums.votes += weight;
    }
    NormalEquations prior;
    add_range_prior(prior, range_offset, options.range_offset_sigma);
    sums.slope = prior.information;
    for (auto& block : sums.of_block) {
        if (!(options.range_offset_sigma > 0.0)) hold_range_offset(block);
        sums.slope += block.slope;
    }
    LinkStatistics link;
    link.rms = sums.votes > 0.0 ? std::sqrt(sums.square / sums.votes) : 0.0;
    link.covariance = covariance_of(sums);
    return link;
}

void judge_link(FineResult& result, const PreparedScan& target, const PreparedScan& source, const Rigid3& start,
                bool has_votes, const FineOptions& options) {
    if (has_votes) measure_overlap(result, target, source, options.threads);
    const std::string against = objection(result, start, has_votes, options);
    result.is_accepted = against.empty();
    if (!result.is_accepted) {
        result.verdict = "refused: " + against;
        return;
    }
    result.information = result.covariance.ldlt().solve(Matrix6::Identity());
    const StandingGround ground = standing_ground(result);
    result.verdict = fmt::format("aligned on {} of {} pieces of ground, {:.1f} mm rms, σ {:.2f} mm and {:.4f}°",
                                 ground.stable, ground.judged, 1000.0 * result.rms,
                                 1000.0 * worst_sigma(result.covariance.bottomRightCorner<3, 3>()),
                                 kDegrees * worst_sigma(result.covariance.topLeftCorner<3, 3>()));
}

} // namespace planum::scans
