// SPDX-License-Identifier: MIT
#include "scans/registration/link_quality.hpp"

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

} // namespace

Vector6 damped_step(const NormalEquations& equations) {
    Matrix6 damped = equations.information;
    damped.diagonal() *= 1.0 + 1e-9;
    damped.diagonal().array() += 1e-9 * equations.information.trace() / 6.0 + 1e-30;
    return -damped.ldlt().solve(equations.gradient);
}

LinkStatistics link_statistics(const SurfelCloud& target, const SurfelCloud& source, const Rigid3& target_from_source,
                               std::span<const SurfelMatch> matches, const PatchMap& map, int threads) {
    std::vector<NormalEquations> pairs(matches.size());
    for_blocks(matches.size(), threads, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (matches[i].kind != MatchKind::Agree) continue;
            pairs[i] = equations_of(target.surfels[matches[i].target], source.surfels[matches[i].source],
                                    target_from_source, 0.0);
        }
    });
    Matrix6 bread = Matrix6::Zero();
    std::vector<Vector6> patch_gradient(map.patches.size(), Vector6::Zero());
    double square = 0.0;
    double votes = 0.0;
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (matches[i].kind != MatchKind::Agree) continue;
        const auto patch = map.patch_of[matches[i].target];
        const double weight = matches[i].weight * map.patches[patch].weight;
        bread += weight * pairs[i].information;
        patch_gradient[patch] += weight * pairs[i].gradient;
        square += weight * matches[i].offset * matches[i].offset;
        votes += weight;
    }
    LinkStatistics link;
    link.rms = votes > 0.0 ? std::sqrt(square / votes) : 0.0;
    Matrix6 meat = Matrix6::Zero();
    double voting = 0.0;
    for (const auto& gradient : patch_gradient) {
        meat += gradient * gradient.transpose();
        voting += gradient.squaredNorm() > 0.0 ? 1.0 : 0.0;
    }
    const Eigen::LDLT<Matrix6> solver(bread);
    if (voting < 12.0 || is_open(bread) || solver.info() != Eigen::Success || !solver.isPositive()) {
        link.covariance.setConstant(std::numeric_limits<double>::infinity());
        return link;
    }
    const Matrix6 stated = solver.solve(Matrix6::Identity());
    const Matrix6 seen = stated * meat * stated * (voting / (voting - 6.0));
    link.covariance = 0.5 * (seen + seen.transpose());
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
