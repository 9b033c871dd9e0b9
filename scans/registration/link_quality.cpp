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

/// How the vote of a pair changes if ground reads too high by the tangent of the incidence, towards its scanner.
Vector6 lean_of(const NormalEquations& pair, const Surfel& target, const Surfel& source, const Rigid3& pose) {
    const auto tangent = [](const Surfel& surfel) {
        const double cosine = std::clamp(-surfel.normal.dot(surfel.position.normalized()), 0.05, 1.0);
        return std::sqrt(1.0 - cosine * cosine) / cosine;
    };
    Eigen::Vector3d normal = pose.rotation * source.normal;
    const double side = normal.dot(target.normal) < 0.0 ? -1.0 : 1.0;
    normal = (side * normal + target.normal).normalized();
    Vector6 direction;
    direction << (pose.rotation * source.position).cross(normal), normal;
    const double precision = pair.information.bottomRightCorner<3, 3>().trace();
    return precision * (side * tangent(source) - tangent(target)) * direction;
}

/// What one block of ground votes for, and how firmly.
struct BlockVote {
    Vector6 gradient = Vector6::Zero();
    Matrix6 slope = Matrix6::Zero();
};

struct Sums {
    std::vector<BlockVote> of_block;
    Matrix6 bread = Matrix6::Zero();
    Matrix6 slope = Matrix6::Zero();
    Vector6 lean = Vector6::Zero();
    double square = 0.0;
    double votes = 0.0;
};

// How the pose would move if the block had not voted.
Vector6 without(const BlockVote& block, const Matrix6& slope, const Eigen::LDLT<Matrix6>& with_all) {
    const Eigen::LDLT<Matrix6> solver(slope - block.slope);
    const bool is_firm = solver.info() == Eigen::Success && solver.isPositive();
    return is_firm ? solver.solve(block.gradient) : with_all.solve(block.gradient);
}

// The jackknife over blocks, for ground errs by blocks, and what leans the same way everywhere.
Matrix6 covariance_of(const Sums& sums, double lean) {
    const Eigen::LDLT<Matrix6> solver(sums.slope);
    const auto voting = std::count_if(sums.of_block.begin(), sums.of_block.end(),
                                      [](const BlockVote& block) { return block.gradient.squaredNorm() > 0.0; });
    if (voting < 12 || is_open(sums.bread) || solver.info() != Eigen::Success || !solver.isPositive()) {
        return Matrix6::Constant(std::numeric_limits<double>::infinity());
    }
    Matrix6 seen = Matrix6::Zero();
    for (const auto& block : sums.of_block) {
        if (block.gradient.squaredNorm() <= 0.0) continue;
        const Vector6 moved = without(block, sums.slope, solver);
        seen += moved * moved.transpose();
    }
    // Which patches vote is itself decided by their offsets; that the jackknife does not see. As measured, see
    // docs/registration.md.
    constexpr double kChosenVotes = 1.25;
    const Vector6 leaning = lean * solver.solve(sums.lean);
    return kChosenVotes * seen + leaning * leaning.transpose();
}

} // namespace

Vector6 damped_step(const NormalEquations& equations) {
    Matrix6 damped = equations.information;
    damped.diagonal() *= 1.0 + 1e-9;
    damped.diagonal().array() += 1e-9 * equations.information.trace() / 6.0 + 1e-30;
    return -damped.ldlt().solve(equations.gradient);
}

LinkStatistics link_statistics(const SurfelCloud& target, const SurfelCloud& source, const Rigid3& target_from_source,
                               std::span<const SurfelMatch> matches, const PatchMap& map, const FineOptions& options) {
    std::vector<NormalEquations> pairs(matches.size());
    std::vector<Vector6> leans(matches.size(), Vector6::Zero());
    for_blocks(matches.size(), options.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (matches[i].kind != MatchKind::Agree) continue;
            const Surfel& t = target.surfels[matches[i].target];
            const Surfel& s = source.surfels[matches[i].source];
            pairs[i] = equations_of(t, s, target_from_source, 0.0);
            leans[i] = lean_of(pairs[i], t, s, target_from_source);
        }
    });
    Sums sums;
    sums.of_block.resize(map.blocks);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (matches[i].kind != MatchKind::Agree) continue;
        const auto patch = map.patch_of[matches[i].target];
        const double weight = matches[i].weight * map.patches[patch].weight;
        if (weight <= 0.0) continue;
        // The derivative of a robust vote w · r is less than w: of Geman-McClure's 4 √w - 3 times that. A twentieth
        // keeps the sum above nothing.
        const double steepness = 4.0 * std::sqrt(matches[i].weight) - 2.95;
        BlockVote& block = sums.of_block[map.block_of[patch]];
        block.gradient += weight * pairs[i].gradient;
        block.slope += weight * steepness * pairs[i].information;
        sums.bread += weight * pairs[i].information;
        sums.lean += weight * leans[i];
        sums.square += weight * matches[i].offset * matches[i].offset;
        sums.votes += weight;
    }
    for (const auto& block : sums.of_block) sums.slope += block.slope;
    LinkStatistics link;
    link.rms = sums.votes > 0.0 ? std::sqrt(sums.square / sums.votes) : 0.0;
    link.covariance = covariance_of(sums, options.systematic_lean);
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
    int stable = 0;
    int judged = 0;
    for (const auto& patch : result.patches) {
        stable += patch.state == PatchState::Stable ? 1 : 0;
        judged += patch.state != PatchState::Thin ? 1 : 0;
    }
    result.verdict =
        fmt::format("aligned on {} of {} pieces of ground, {:.1f} mm rms, σ {:.2f} mm and {:.4f}°", stable, judged,
                    1000.0 * result.rms, 1000.0 * worst_sigma(result.covariance.bottomRightCorner<3, 3>()),
                    kDegrees * worst_sigma(result.covariance.topLeftCorner<3, 3>()));
}

} // namespace planum::scans
