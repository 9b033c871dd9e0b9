// SPDX-License-Identifier: MIT
#include "scans/registration/coarse_alignment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/geometry/fit_rigid.hpp"

namespace planum::scans {

using geometry::Rigid3;

namespace {

constexpr double kSameSpot = 3.0; ///< [px]
constexpr Eigen::Index kRows = 256;

struct Best {
    Eigen::Index at = -1;
    float cosine = -2.0F;
    float second = -2.0F;
};

void offer(Best& best, Eigen::Index at, float cosine, const std::vector<Feature>& features) {
    const auto is_same_spot = [&](Eigen::Index a, Eigen::Index b) {
        const auto& pa = features[static_cast<std::size_t>(a)];
        const auto& pb = features[static_cast<std::size_t>(b)];
        return (pa.pixel - pb.pixel).squaredNorm() < kSameSpot * kSameSpot;
    };
    if (cosine > best.cosine) {
        if (best.at >= 0 && !is_same_spot(best.at, at)) best.second = best.cosine;
        best.cosine = cosine;
        best.at = at;
    } else if (cosine > best.second && !is_same_spot(best.at, at)) {
        best.second = cosine;
    }
}

double ratio_of(const Best& best) {
    if (best.second < -1.0F) return 1.0; // nothing to compare with
    const auto squared = [](float cosine) { return std::max(0.0, 2.0 - 2.0 * static_cast<double>(cosine)); };
    const double second = squared(best.second);
    return second > 0.0 ? std::sqrt(squared(best.cosine) / second) : 1.0;
}

struct Places {
    std::vector<Eigen::Vector3d> target;
    std::vector<Eigen::Vector3d> source;
    std::vector<double> sigma; ///< of their distance [m]
};

Places places_of(const FeatureSet& target, const FeatureSet& source, std::span<const FeatureMatch> matches,
                 const CoarseOptions& options) {
    Places places;
    for (const auto& match : matches) {
        const auto& t = target.features[match.target].x_in_scan;
        const auto& s = source.features[match.source].x_in_scan;
        places.target.push_back(t);
        places.source.push_back(s);
        places.sigma.push_back(std::hypot(options.noise + options.noise_per_range * t.norm(),
                                          options.noise + options.noise_per_range * s.norm()));
    }
    return places;
}

std::vector<std::size_t> inliers_of(const Places& places, const Rigid3& pose, double gate) {
    std::vector<std::size_t> inliers;
    for (std::size_t i = 0; i < places.target.size(); ++i) {
        const double distance = (pose * places.source[i] - places.target[i]).norm();
        if (distance < gate * places.sigma[i]) inliers.push_back(i);
    }
    return inliers;
}

/// Truncated squares: a good fit counts more than one at the gate.
double score_of(const Places& places, const Rigid3& pose, double gate) {
    double score = 0.0;
    for (std::size_t i = 0; i < places.target.size(); ++i) {
        const double off = (pose * places.source[i] - places.target[i]).norm() / (gate * places.sigma[i]);
        if (off < 1.0) score += 1.0 - off * off;
    }
    return score;
}

geometry::RigidFit fit(const Places& places, std::span<const std::size_t> members) {
    std::vector<Eigen::Vector3d> source;
    std::vector<Eigen::Vector3d> target;
    std::vector<double> weights;
    for (const std::size_t i : members) {
        source.push_back(places.source[i]);
        target.push_back(places.target[i]);
        weights.push_back(1.0 / (places.sigma[i] * places.sigma[i]));
    }
    return geometry::fit_rigid(source, target, weights);
}

bool is_congruent(const Places& places, const std::array<std::size_t, 3>& triple, const CoarseOptions& options) {
    for (int k = 0; k < 3; ++k) {
        const std::size_t a = triple[static_cast<std::size_t>(k)];
        const std::size_t b = triple[static_cast<std::size_t>((k + 1) % 3)];
        const double in_target = (places.target[a] - places.target[b]).norm();
        const double in_source = (places.source[a] - places.source[b]).norm();
        if (in_target < options.min_distance || in_source < options.min_distance) return false;
        if (std::abs(in_target - in_source) > options.gate * std::hypot(places.sigma[a], places.sigma[b])) return false;
    }
    return true;
}

/// The pose that brings a triangle onto another: by two directions, faster than least squares.
Rigid3 pose_of(const Places& places, const std::array<std::size_t, 3>& triple) {
    const auto frame = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        Eigen::Matrix3d axes;
        axes.col(0) = (b - a).normalized();
        axes.col(2) = (b - a).cross(c - a).normalized();
        axes.col(1) = axes.col(2).cross(axes.col(0));
        return axes;
    };
    const auto& t = places.target;
    const auto& s = places.source;
    const auto [a, b, c] = triple;
    Rigid3 pose;
    pose.rotation = frame(t[a], t[b], t[c]) * frame(s[a], s[b], s[c]).transpose();
    pose.translation = (t[a] + t[b] + t[c]) / 3.0 - pose.rotation * ((s[a] + s[b] + s[c]) / 3.0);
    return pose;
}

double tilt_of(const Rigid3& pose) { return std::acos(std::clamp(pose.rotation(2, 2), -1.0, 1.0)); }

Rigid3 best_trial(const Places& places, const CoarseOptions& options) {
    std::mt19937_64 random(options.seed);
    const std::size_t size = places.target.size();
    Rigid3 best;
    double best_score = 0.0;
    double needed = options.trials;
    for (int trial = 0; trial < options.trials && trial < needed; ++trial) {
        std::array<std::size_t, 3> triple{};
        for (auto& i : triple) i = static_cast<std::size_t>(random() % size);
        if (triple[0] == triple[1] || triple[1] == triple[2] || triple[0] == triple[2]) continue;
        if (!is_congruent(places, triple, options)) continue;
        const Rigid3 pose = pose_of(places, triple);
        if (!pose.rotation.allFinite() || tilt_of(pose) > options.max_tilt) continue;
        const double score = score_of(places, pose, options.gate);
        if (score <= best_score) continue;
        best_score = score;
        best = pose;
        const double share = score / static_cast<double>(size);
        // Until a triple of inliers was missed with a chance under 1e-4; most triples lie too close or are noisy.
        needed = 20.0 * std::log(1e-4) / std::log1p(-std::min(0.999, share * share * share));
    }
    return best;
}

CoarseResult refused(CoarseResult result, std::string why) {
    result.verdict = std::move(why);
    return result;
}

} // namespace

std::vector<FeatureMatch> match_features(const FeatureSet& target, const FeatureSet& source, double ratio) {
    std::vector<Best> of_source(source.features.size());
    std::vector<Best> of_target(target.features.size());
    const Eigen::Index columns = target.descriptors.rows();
    for (Eigen::Index first = 0; first < source.descriptors.rows(); first += kRows) {
        const Eigen::Index rows = std::min(kRows, source.descriptors.rows() - first);
        const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> cosines =
            source.descriptors.middleRows(first, rows) * target.descriptors.transpose();
        for (Eigen::Index r = 0; r < rows; ++r) {
            const auto s = static_cast<std::size_t>(first + r);
            for (Eigen::Index t = 0; t < columns; ++t) {
                const float cosine = cosines(r, t);
                Best& there = of_target[static_cast<std::size_t>(t)];
                Best& here = of_source[s];
                if (cosine <= here.second && cosine <= there.second) continue;
                if (source.features[s].channel != target.features[static_cast<std::size_t>(t)].channel) continue;
                if (cosine > here.second) offer(here, t, cosine, target.features);
                if (cosine > there.second) offer(there, first + r, cosine, source.features);
            }
        }
    }
    std::vector<FeatureMatch> matches;
    for (std::size_t s = 0; s < of_source.size(); ++s) {
        const Best& best = of_source[s];
        if (best.at < 0) continue;
        const auto t = static_cast<std::size_t>(best.at);
        if (of_target[t].at != static_cast<Eigen::Index>(s)) continue;
        const double worse = std::max(ratio_of(best), ratio_of(of_target[t]));
        if (worse > ratio) continue;
        matches.push_back({static_cast<std::uint32_t>(t), static_cast<std::uint32_t>(s), worse});
    }
    return matches;
}

CoarseResult align_features(const FeatureSet& target, const FeatureSet& source, std::span<const FeatureMatch> matches,
                            const CoarseOptions& options) {
    CoarseResult result;
    result.matches = static_cast<int>(matches.size());
    if (result.matches < options.min_inliers) {
        return refused(result, fmt::format("only {} places look alike in both scans, {} are needed", result.matches,
                                           options.min_inliers));
    }
    const Places places = places_of(target, source, matches, options);
    Rigid3 pose = best_trial(places, options);
    std::vector<std::size_t> inliers = inliers_of(places, pose, options.gate);
    geometry::RigidFit fitted;
    for (int round = 0; round < 20 && inliers.size() >= 3; ++round) {
        fitted = fit(places, inliers);
        std::vector<std::size_t> next = inliers_of(places, fitted.target_from_source, options.gate);
        const bool is_done = next == inliers;
        inliers = std::move(next);
        if (is_done) break;
    }
    result.inliers = static_cast<int>(inliers.size());
    result.target_from_source = fitted.target_from_source;
    result.rms = fitted.rms;
    if (result.inliers < options.min_inliers) {
        return refused(result, fmt::format("of {} places that look alike only {} lie the same way to each other, {} "
                                           "are needed",
                                           result.matches, result.inliers, options.min_inliers));
    }
    if (fitted.spread[1] < options.min_spread) {
        return refused(result, fmt::format("the {} places that lie the same way in both scans are all in one spot or "
                                           "line, {:.1f} m wide",
                                           result.inliers, fitted.spread[1]));
    }
    if (tilt_of(fitted.target_from_source) > options.max_tilt)
        return refused(result, "one of the scans would hang askew");
    result.is_accepted = true;
    result.covariance = fitted.covariance;
    result.verdict = fmt::format("{} of {} places that look alike agree within {:.0f} mm", result.inliers,
                                 result.matches, result.rms * 1000.0);
    return result;
}

CoarseResult align_coarsely(const FeatureSet& target, const FeatureSet& source, const CoarseOptions& options) {
    return align_features(target, source, match_features(target, source, options.ratio), options);
}

} // namespace planum::scans
