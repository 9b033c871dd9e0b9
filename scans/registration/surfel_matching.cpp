// SPDX-License-Identifier: MIT
#include "scans/registration/surfel_matching.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "scans/registration/fixed_blocks.hpp"

namespace planum::scans {

using geometry::Rigid3;

namespace {

/// Close to the end only the distance between the planes counts: what little pull there is along them comes from the
/// pattern of the points, and two scans from one place have almost the same. Before, the distance in space counts.
struct PairGeometry {
    Eigen::Vector3d arm;    ///< from the source's origin, in target axes
    Eigen::Vector3d apart;  ///< source minus target
    Eigen::Vector3d longer; ///< what apart grows by if all ranges do, per metre
    bool is_plane = false;
    Eigen::Vector3d normal;         ///< of both planes, their mean …
    double precision = 0.0;         ///< … and the inverse variance of the distance along it; only of planes
    Eigen::Matrix3d inverse_spread; ///< only of distances in space
    double chi = 0.0;
};

PairGeometry geometry_of(const Surfel& target, const Surfel& source, const Rigid3& pose, double blur,
                         double range_offset) {
    PairGeometry pair;
    pair.arm = pose.rotation * source.position;
    pair.longer = pair.arm.normalized() - target.position.normalized();
    pair.apart = pair.arm + pose.translation - target.position - range_offset * pair.longer;
    Eigen::Matrix3d spread = target.covariance;
    spread.noalias() += pose.rotation * source.covariance * pose.rotation.transpose();
    spread.diagonal().array() += blur * blur;
    if (blur > 0.0) {
        pair.inverse_spread = spread.inverse();
        pair.chi = pair.apart.dot(pair.inverse_spread * pair.apart);
        return pair;
    }
    Eigen::Vector3d normal = pose.rotation * source.normal;
    if (normal.dot(target.normal) < 0.0) normal = -normal;
    pair.is_plane = true;
    pair.normal = (normal + target.normal).normalized();
    pair.precision = 1.0 / pair.normal.dot(spread * pair.normal);
    const double distance = pair.normal.dot(pair.apart);
    pair.chi = pair.precision * distance * distance;
    return pair;
}

// Upper triangle only.
void add(NormalEquations& sum, const PairGeometry& pair, double weight) {
    if (pair.is_plane) {
        AlignmentVector slope;
        slope << pair.arm.cross(pair.normal), pair.normal, -pair.normal.dot(pair.longer);
        const double precision = weight * pair.precision;
        sum.gradient.noalias() += precision * pair.normal.dot(pair.apart) * slope;
        sum.information.selfadjointView<Eigen::Upper>().rankUpdate(slope, precision);
        return;
    }
    const Eigen::Matrix3d turn = -geometry::cross_matrix(pair.arm);
    const Eigen::Matrix3d m = weight * pair.inverse_spread;
    const Eigen::Matrix3d turned = turn.transpose() * m;
    sum.information.topLeftCorner<3, 3>().noalias() += turned * turn;
    sum.information.block<3, 3>(0, 3) += turned;
    sum.information.block<3, 3>(3, 3) += m;
    sum.gradient.head<3>().noalias() += turned * pair.apart;
    sum.gradient.segment<3>(3).noalias() += m * pair.apart;
}

// The nearest flat surfel of the other cloud, if there is one within reach.
bool find(const Surfel& surfel, const SurfelCloud& other, const Rigid3& other_from_surfel, const MatchOptions& options,
          std::uint32_t& index) {
    if (!surfel.is_flat) return false;
    const auto near = other.index.nearest(other_from_surfel * surfel.position);
    index = near.index;
    return near.squared_distance <= options.max_distance * options.max_distance && other.surfels[near.index].is_flat;
}

PairGeometry judge(SurfelMatch& match, const Surfel& target, const Surfel& source, const Rigid3& pose,
                   const MatchOptions& options) {
    const PairGeometry pair = geometry_of(target, source, pose, options.blur, options.range_offset);
    const double facing = std::abs(target.normal.dot(pose.rotation * source.normal));
    const bool agrees = pair.chi < options.gate * options.gate && facing > options.least_facing;
    match.kind = agrees ? MatchKind::Agree : MatchKind::Disagree;
    match.offset = target.normal.dot(pair.apart);
    const double across = pair.is_plane ? target.normal.dot(pair.normal) : 0.0;
    const double precision =
        pair.is_plane ? across * across * pair.precision : target.normal.dot(pair.inverse_spread * target.normal);
    match.variance = facing * facing / (precision * match.share);
    return pair;
}

void find_pairs(const SurfelCloud& target, const SurfelCloud& source, const Rigid3& target_from_source,
                const MatchOptions& options, std::vector<SurfelMatch>& matches) {
    const std::size_t forward = source.surfels.size();
    const Rigid3 source_from_target = target_from_source.inverse();
    for_blocks(matches.size(), options.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            SurfelMatch& match = matches[i];
            const bool found =
                i < forward ? find(source.surfels[i], target, target_from_source, options, match.target)
                            : find(target.surfels[i - forward], source, source_from_target, options, match.source);
            (i < forward ? match.source : match.target) = static_cast<std::uint32_t>(i < forward ? i : i - forward);
            if (found) match.kind = MatchKind::Disagree; // until judged
        }
    });
}

// Where one scan is much denser than the other, its many surfels meet few of the other, again and again, and would seem
// to say far more than these few know.
void share_errors(const SurfelCloud& target, const SurfelCloud& source, std::vector<SurfelMatch>& matches) {
    std::vector<std::uint32_t> target_uses(target.surfels.size(), 0);
    std::vector<std::uint32_t> source_uses(source.surfels.size(), 0);
    for (const auto& match : matches) {
        if (match.kind == MatchKind::None) continue;
        ++target_uses[match.target];
        ++source_uses[match.source];
    }
    const auto along = [](const Surfel& surfel) { return surfel.normal.dot(surfel.covariance * surfel.normal); };
    for (auto& match : matches) {
        if (match.kind == MatchKind::None) continue;
        const double t = along(target.surfels[match.target]);
        const double s = along(source.surfels[match.source]);
        match.share = (t + s) / (target_uses[match.target] * t + source_uses[match.source] * s);
    }
}

void mirror(AlignmentMatrix& m) {
    m.triangularView<Eigen::StrictlyLower>() = m.transpose().eval().triangularView<Eigen::StrictlyLower>();
}

} // namespace

NormalEquations& NormalEquations::operator+=(const NormalEquations& other) {
    information += other.information;
    gradient += other.gradient;
    cost += other.cost;
    votes += other.votes;
    return *this;
}

NormalEquations equations_of(const Surfel& target, const Surfel& source, const Rigid3& target_from_source, double blur,
                             double range_offset) {
    NormalEquations sum;
    add(sum, geometry_of(target, source, target_from_source, blur, range_offset), 1.0);
    mirror(sum.information);
    return sum;
}

NormalEquations match_surfels(const SurfelCloud& target, const SurfelCloud& source, const Rigid3& target_from_source,
                              const MatchOptions& options, std::span<const std::uint32_t> patch_of,
                              std::span<const double> patch_weight, std::vector<SurfelMatch>& matches) {
    const std::size_t forward = source.surfels.size();
    const std::size_t size = forward + (options.ways == MatchWays::Both ? target.surfels.size() : 0);
    if (target.surfels.empty() || source.surfels.empty()) {
        matches.assign(size, {});
        return {};
    }
    if (!options.keep_pairs || matches.size() != size) {
        matches.assign(size, {});
        find_pairs(target, source, target_from_source, options, matches);
        if (options.ways == MatchWays::Both) share_errors(target, source, matches);
    }
    // Of Geman-McClure: 0.7 of the gate. A third, as it was, threw away a quarter of what sound ground says.
    const double width = 0.5 * options.gate * options.gate;
    std::vector<NormalEquations> sums(block_count(size));
    for_blocks(size, options.threads, [&](std::size_t block, std::size_t begin, std::size_t end) {
        NormalEquations sum;
        for (std::size_t i = begin; i < end; ++i) {
            SurfelMatch& match = matches[i];
            if (match.kind == MatchKind::None) continue;
            const Surfel& t = target.surfels[match.target];
            const PairGeometry pair = judge(match, t, source.surfels[match.source], target_from_source, options);
            match.weight = 0.0;
            if (match.kind == MatchKind::Disagree) continue;
            match.weight = width * width / ((width + pair.chi) * (width + pair.chi));
            const double weight =
                match.weight * match.share * (patch_of.empty() ? 1.0 : patch_weight[patch_of[match.target]]);
            if (weight <= 0.0) continue;
            add(sum, pair, weight);
            sum.cost += weight * pair.chi;
            sum.votes += weight;
        }
        sums[block] = sum;
    });
    NormalEquations total;
    for (const auto& sum : sums) total += sum;
    mirror(total.information);
    return total;
}

} // namespace planum::scans
