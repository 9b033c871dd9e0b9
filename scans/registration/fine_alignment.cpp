// SPDX-License-Identifier: MIT
#include "scans/registration/fine_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/registration/link_quality.hpp"

namespace planum::scans {

using geometry::Rigid3;
using geometry::Vector6;

namespace {

constexpr double kConverged = 2e-6; ///< largest last step at the finest level [m], turns at 10 m
/// Share of the voxel that the pose may move, turns at 10 m, before the nearest surfels are looked for again.
constexpr double kNearSearch = 0.02;
/// How much wider the cubes of a level must be than those of the finer cloud to be worth a cloud of their own.
constexpr double kAnotherCloud = 1.4;
constexpr double kSameFacing = 0.9; ///< cosine between normals of the same ground

void check(const FineOptions& options) {
    if (options.levels.empty()) throw Error(ErrorCode::BadInput, "fine alignment without levels");
    double last = std::numeric_limits<double>::infinity();
    for (const auto& level : options.levels) {
        if (!(level.voxel >= 0.0) || level.voxel > last) {
            throw Error(ErrorCode::BadInput, "levels of the fine alignment must go from coarse to fine");
        }
        last = level.voxel;
    }
    if (!(options.patch > 0.0)) throw Error(ErrorCode::BadInput, "patches of the fine alignment need a size");
}

double length_of(const Vector6& step) { return std::max(10.0 * step.head<3>().norm(), step.tail<3>().norm()); }

/// The pose on its way from level to level.
class Alignment {
  public:
    Alignment(const PreparedScan& target, const PreparedScan& source, const Rigid3& start, const FineOptions& options,
              Progress& progress)
        : target_(target), source_(source), options_(options), progress_(progress) {
        result.target_from_source = start;
    }

    bool run() {
        for (std::size_t i = 0; i < options_.levels.size(); ++i) {
            progress_.fraction(static_cast<double>(i) / static_cast<double>(options_.levels.size() + 1));
            const AlignmentLevel& level = options_.levels[i];
            const double enough = std::max(kConverged, 0.02 * level.blur);
            if (!converge(i, {}, {}, enough)) return false;
        }
        return vote();
    }

    FineResult result;
    NormalEquations equations;
    std::vector<SurfelMatch> matches;

  private:
    bool converge(std::size_t level, std::span<const std::uint32_t> patch_of, std::span<const double> weights,
                  double enough) {
        const AlignmentLevel& how = options_.levels[level];
        const SurfelCloud& target = target_.clouds[target_.cloud_of[level]];
        const SurfelCloud& source = source_.clouds[source_.cloud_of[level]];
        const bool is_last = how.blur <= 0.0;
        MatchOptions match{how.max_distance,
                           how.blur,
                           is_last ? kSameFacing : 0.0,
                           4.0,
                           is_last ? MatchWays::Both : MatchWays::Forward,
                           options_.threads,
                           0.0,
                           false};
        const double near = kNearSearch * std::max(target.voxel, source.voxel);
        for (int i = 0; i < how.max_iterations; ++i) {
            progress_.check();
            match.range_offset = result.range_offset;
            match.keep_pairs = searched_level_ == level &&
                               length_of(geometry::step_between(searched_at_, result.target_from_source)) < near;
            if (!match.keep_pairs) searched_at_ = result.target_from_source;
            searched_level_ = level;
            equations = match_surfels(target, source, result.target_from_source, match, patch_of, weights, matches);
            ++result.iterations;
            add_range_prior(equations, result.range_offset, options_.range_offset_sigma);
            const AlignmentVector step = damped_step(equations);
            if (!step.allFinite()) return false;
            result.target_from_source = geometry::moved(result.target_from_source, step.head<6>());
            result.range_offset += step[6];
            if (length_of(step.head<6>()) < enough) break;
        }
        return equations.votes >= 30.0;
    }

    bool vote() {
        const std::size_t last = options_.levels.size() - 1;
        PatchMap map = make_patches(target_.clouds[target_.cloud_of[last]], options_.patch);
        if (!settle_votes(map, BentScans::VoteWhole)) return false;
        link_covariance(map, last);
        if (map.is_bent) add_doubt(map);
        result.patches = std::move(map.patches);
        return true;
    }

    // Patches and pose in turn, until what votes no longer changes.
    bool settle_votes(PatchMap& map, BentScans bent) {
        constexpr int kRounds = 8;
        const std::size_t last = options_.levels.size() - 1;
        // Scans that keep a blur are bent by that much; a step of a thousandth of it says nothing.
        const double enough = std::max(kConverged, 1e-3 * options_.levels[last].blur);
        for (int round = 0; round < kRounds; ++round) {
            const Rigid3 before = result.target_from_source;
            result.scatter = judge_patches(map, matches, bent);
            if (!converge(last, map.patch_of, weights_of(map), enough)) return false;
            if (length_of(geometry::step_between(before, result.target_from_source)) < 2.5 * enough) break;
        }
        return true;
    }

    // Which ground should vote in a bent scan is a choice, and the pose depends on it. The answers of both choices are
    // two samples of what could be meant; their variance is added to what the scatter of the votes shows.
    void add_doubt(PatchMap map) {
        Alignment other = *this;
        if (!other.settle_votes(map, BentScans::AsOthers)) return;
        const Vector6 apart = geometry::step_between(result.target_from_source, other.result.target_from_source);
        result.covariance += 0.5 * apart * apart.transpose();
    }

    void link_covariance(const PatchMap& map, std::size_t level) {
        const LinkStatistics link =
            link_statistics(target_.clouds[target_.cloud_of[level]], source_.clouds[source_.cloud_of[level]],
                            result.target_from_source, result.range_offset, matches, map, options_);
        result.covariance = link.covariance;
        result.covariance.diagonal().head<3>().array() += options_.systematic_rotation * options_.systematic_rotation;
        result.covariance.diagonal().tail<3>().array() += options_.systematic_position * options_.systematic_position;
        result.rms = link.rms;
    }

    const PreparedScan& target_;
    const PreparedScan& source_;
    const FineOptions& options_;
    Progress& progress_;
    Rigid3 searched_at_; ///< where the pairs of `matches` were looked for
    std::size_t searched_level_ = std::numeric_limits<std::size_t>::max();
};

std::vector<Eigen::Vector3d> positions_of(const SurfelCloud& cloud) {
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(cloud.surfels.size());
    for (const auto& surfel : cloud.surfels) positions.push_back(surfel.position);
    return positions;
}

} // namespace

PreparedScan prepare_scan(std::span<const Eigen::Vector3d> x_in_scan, const FineOptions& options) {
    check(options);
    PreparedScan scan;
    for (const auto& x : x_in_scan) scan.points += x.allFinite() ? 1U : 0U;
    // From fine to coarse, each thinned from the one before.
    std::vector<Eigen::Vector3d> points;
    for (auto level = options.levels.rbegin(); level != options.levels.rend(); ++level) {
        // The finer cloud serves a level that asks for nearly the same; in a dense scan its cubes had to grow.
        if (scan.clouds.empty() || level->voxel > kAnotherCloud * scan.clouds.back().voxel) {
            double voxel = level->voxel;
            points = thin_out(scan.clouds.empty() ? x_in_scan : std::span<const Eigen::Vector3d>(points), voxel);
            while (points.size() > options.max_surfels) {
                voxel = voxel > 0.0 ? 1.4 * voxel : 0.005;
                points = thin_out(points, voxel);
            }
            scan.clouds.push_back(make_surfels(points, {0.0, options.neighbours, 0.0005, options.threads}));
            scan.clouds.back().voxel = voxel;
            points = positions_of(scan.clouds.back());
        }
        scan.cloud_of.push_back(scan.clouds.size() - 1);
    }
    std::reverse(scan.cloud_of.begin(), scan.cloud_of.end());
    return scan;
}

FineResult align_scans(const PreparedScan& target, const PreparedScan& source, const Rigid3& start,
                       const FineOptions& options, Progress& progress) {
    check(options);
    if (target.cloud_of.size() != options.levels.size() || source.cloud_of.size() != options.levels.size()) {
        throw Error(ErrorCode::Internal, "scans prepared for another schedule");
    }
    progress.step("fine alignment");
    Alignment alignment(target, source, start, options, progress);
    const bool has_votes = alignment.run();
    FineResult result = std::move(alignment.result);
    judge_link(result, target, source, start, has_votes, options);
    return result;
}

} // namespace planum::scans
