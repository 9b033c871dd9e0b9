// SPDX-License-Identifier: MIT
#include "scans/registration/scan_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "core/base/error.hpp"
#include "scans/registration/pair_selection.hpp"
#include "scans/registration/pose_graph.hpp"

namespace planum::scans {

using geometry::Matrix6;
using geometry::Rigid3;

namespace {

Matrix6 inverse_of(const Matrix6& covariance) {
    const Matrix6 information = covariance.ldlt().solve(Matrix6::Identity());
    return 0.5 * (information + information.transpose());
}

/// The pose graph of what is used at present. Its last node is the site grid itself.
class Network {
  public:
    Network(std::size_t scans, std::span<const NetworkLink> links, std::span<const NetworkAnchor> anchors,
            Progress& progress)
        : scans_(scans), links_(links), anchors_(anchors), progress_(progress) {
        result.poses.resize(scans);
        result.links.resize(links.size());
        result.anchors.resize(anchors.size());
        for (auto& check : result.links) check.is_used = true;
        for (auto& check : result.anchors) check.is_used = true;
    }

    NetworkResult result;

    /// False if nothing hangs on an anchor.
    bool relax() {
        find_parts();
        nodes_.clear();
        edges_.clear();
        of_edge_.clear();
        node_of_.assign(scans_, 0);
        nodes_.push_back({{}, true});
        for (std::size_t scan = 0; scan < scans_; ++scan) {
            if (!is_anchored(scan)) continue;
            node_of_[scan] = nodes_.size();
            nodes_.push_back({});
        }
        for (const auto& anchor : anchors_) {
            if (anchor.is_held) nodes_[node_of_[anchor.scan]] = {anchor.site_from_scan, true};
        }
        add_edges();
        if (nodes_.size() < 2) return false;
        nodes_ = spread();
        graph_ = relax_poses(nodes_, edges_, {}, progress_);
        note_errors();
        return true;
    }

    /// Leaves out the worst contradiction over the limit; false if there is none.
    bool drop_worst(double most_error) {
        NetworkCheck* worst = nullptr;
        for (NetworkCheck* check : of_edge_) {
            if (check->after <= most_error || (worst != nullptr && check->after <= worst->after)) continue;
            worst = check;
        }
        if (worst == nullptr) return false;
        worst->is_used = false;
        worst->reason = fmt::format("contradicts the other links and markers by {:.1f} standard deviations ({:.1f} mm, "
                                    "{:.3f} degrees)",
                                    worst->after, worst->shift * 1e3, worst->turn * 180.0 / M_PI);
        return true;
    }

    void take_poses() {
        find_own_noise();
        for (std::size_t scan = 0; scan < scans_; ++scan) {
            if (!is_anchored(scan)) continue;
            const std::size_t node = node_of_[scan];
            NetworkPose pose{graph_.site_from_scan[node], graph_.covariance[node], graph_.covariance[node]};
            add_held_share(pose, scan);
            add_own_noise(pose, scan);
            result.poses[scan] = pose;
        }
        result.cost_before = graph_.cost_before;
        result.cost_after = graph_.cost_after;
    }

  private:
    void find_parts() {
        std::vector<PairCandidate> pairs;
        for (std::size_t i = 0; i < links_.size(); ++i) {
            if (result.links[i].is_used) pairs.push_back({links_[i].target, links_[i].source, 0.0});
        }
        part_ = connected_parts(pairs, scans_);
        has_anchor_.assign(scans_, false);
        for (std::size_t i = 0; i < anchors_.size(); ++i) {
            if (result.anchors[i].is_used) has_anchor_[part_[anchors_[i].scan]] = true;
        }
    }

    [[nodiscard]] bool is_anchored(std::size_t scan) const { return has_anchor_[part_[scan]]; }

    void add_edges() {
        for (std::size_t i = 0; i < anchors_.size(); ++i) {
            const NetworkAnchor& anchor = anchors_[i];
            if (anchor.is_held || !result.anchors[i].is_used) continue;
            edges_.push_back({0, node_of_[anchor.scan], anchor.site_from_scan, inverse_of(anchor.covariance)});
            of_edge_.push_back(&result.anchors[i]);
        }
        for (std::size_t i = 0; i < links_.size(); ++i) {
            const NetworkLink& link = links_[i];
            if (!is_in_graph(i)) continue;
            edges_.push_back(
                {node_of_[link.target], node_of_[link.source], link.target_from_source, inverse_of(link.covariance)});
            of_edge_.push_back(&result.links[i]);
        }
    }

    /// Start values along the chain of the links that are surest of the position.
    std::vector<PoseNode> spread() {
        std::vector<PairCandidate> pairs;
        for (const auto& edge : edges_) {
            const double size = edge.information.diagonal().tail<3>().sum();
            pairs.push_back({edge.target, edge.source, size});
        }
        const auto tree = select_pairs(pairs, nodes_.size(), 0, {});
        std::vector<PoseLink> chain;
        for (const auto& edge : edges_) {
            const bool is_in_tree = std::any_of(tree.begin(), tree.end(), [&](const PairCandidate& pair) {
                return pair.target == edge.target && pair.source == edge.source;
            });
            if (is_in_tree) chain.push_back(edge);
        }
        return spread_from_fixed(nodes_, chain);
    }

    void note_errors() {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const LinkError& error = graph_.links[i];
            of_edge_[i]->before = error.before;
            of_edge_[i]->after = error.after;
            of_edge_[i]->shift = error.shift;
            of_edge_[i]->turn = error.turn;
        }
    }

    /// The part of the links' variance that is the scans' own: no link to the same scan averages it out, and loops
    /// close better than the links state.
    [[nodiscard]] double own_part() const {
        constexpr double kBelieved = 0.5; // before any loop was seen …
        constexpr double kWeight = 6.0;   // … and as firmly as one loop says
        std::vector<double> held(scans_, 0.0);
        std::vector<double> members(scans_, 0.0);
        for (const auto& anchor : anchors_) held[part_[anchor.scan]] += anchor.is_held ? 1.0 : 0.0;
        double freedom = 0.0;
        double cost = 0.0;
        for (std::size_t scan = 0; scan < scans_; ++scan) {
            if (is_anchored(scan)) members[part_[scan]] += 1.0;
        }
        for (std::size_t part = 0; part < scans_; ++part) {
            if (members[part] > 0.0) freedom -= 6.0 * (members[part] - std::max(1.0, held[part]));
        }
        for (std::size_t i = 0; i < links_.size(); ++i) {
            if (!is_in_graph(i)) continue;
            freedom += 6.0;
            cost += result.links[i].after * result.links[i].after;
        }
        freedom = std::max(0.0, freedom);
        return std::clamp(1.0 - (cost + kWeight * (1.0 - kBelieved)) / (freedom + kWeight), 0.0, 1.0);
    }

    /// Half of what its links share, on the site grid about its own origin; the links of a scan averaged by what they
    /// know.
    void find_own_noise() {
        const double part = own_part();
        std::vector<Matrix6> information(scans_, Matrix6::Zero());
        std::vector<double> count(scans_, 0.0);
        for (std::size_t i = 0; i < links_.size(); ++i) {
            if (!is_in_graph(i)) continue;
            const Rigid3& target = graph_.site_from_scan[node_of_[links_[i].target]];
            const Rigid3& source = graph_.site_from_scan[node_of_[links_[i].source]];
            Matrix6 turn = Matrix6::Zero();
            turn.topLeftCorner<3, 3>() = target.rotation;
            turn.bottomRightCorner<3, 3>() = target.rotation;
            const Matrix6 of_source = turn * links_[i].covariance * turn.transpose();
            information[links_[i].source] += inverse_of(of_source);
            information[links_[i].target] +=
                inverse_of(carried_covariance(of_source, source.translation, target.translation));
            count[links_[i].source] += 1.0;
            count[links_[i].target] += 1.0;
        }
        own_noise_.assign(scans_, Matrix6::Zero());
        for (std::size_t scan = 0; scan < scans_; ++scan) {
            if (count[scan] > 0.0) own_noise_[scan] = 0.5 * part * count[scan] * inverse_of(information[scan]);
        }
    }

    [[nodiscard]] bool is_in_graph(std::size_t link) const {
        return result.links[link].is_used && is_anchored(links_[link].target);
    }

    /// Between a scan and what it hangs on lie the noise of both.
    void add_own_noise(NetworkPose& pose, std::size_t scan) const {
        const NetworkAnchor* nearest = nearest_anchor(pose, scan, false);
        if (nearest == nullptr || nearest->scan == scan) return;
        const Eigen::Vector3d& there = graph_.site_from_scan[node_of_[nearest->scan]].translation;
        const Matrix6 both =
            own_noise_[scan] + carried_covariance(own_noise_[nearest->scan], there, pose.site_from_scan.translation);
        pose.covariance += both;
        pose.link_covariance += both;
    }

    [[nodiscard]] const NetworkAnchor* nearest_anchor(const NetworkPose& pose, std::size_t scan, bool is_held) const {
        const NetworkAnchor* nearest = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < anchors_.size(); ++i) {
            const NetworkAnchor& anchor = anchors_[i];
            if ((is_held && !anchor.is_held) || !result.anchors[i].is_used || part_[anchor.scan] != part_[scan]) {
                continue;
            }
            const double distance = (anchor.site_from_scan.translation - pose.site_from_scan.translation).norm();
            if (distance >= least) continue;
            least = distance;
            nearest = &anchor;
        }
        return nearest;
    }

    /// Poses that hang on held ones err with them: with the nearest.
    void add_held_share(NetworkPose& pose, std::size_t scan) const {
        const NetworkAnchor* nearest = nearest_anchor(pose, scan, true);
        if (nearest == nullptr) return;
        pose.covariance += carried_covariance(nearest->covariance, nearest->site_from_scan.translation,
                                              pose.site_from_scan.translation);
    }

    std::size_t scans_;
    std::span<const NetworkLink> links_;
    std::span<const NetworkAnchor> anchors_;
    Progress& progress_;
    std::vector<std::size_t> part_;
    std::vector<bool> has_anchor_; ///< by part
    std::vector<std::size_t> node_of_;
    std::vector<PoseNode> nodes_;
    std::vector<PoseLink> edges_;
    std::vector<NetworkCheck*> of_edge_;
    PoseGraphResult graph_;
    std::vector<Matrix6> own_noise_; ///< of each scan, see find_own_noise
};

} // namespace

Matrix6 carried_covariance(const Matrix6& covariance, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    Matrix6 carry = Matrix6::Identity();
    carry.bottomLeftCorner<3, 3>() = -geometry::cross_matrix(to - from);
    return carry * covariance * carry.transpose();
}

NetworkResult solve_network(std::size_t scans, std::span<const NetworkLink> links,
                            std::span<const NetworkAnchor> anchors, const NetworkOptions& options, Progress& progress) {
    for (const auto& link : links) {
        if (link.target >= scans || link.source >= scans || link.target == link.source) {
            throw Error(ErrorCode::Internal, "a link of the scan network points nowhere");
        }
    }
    progress.step("relaxing all poses");
    Network network(scans, links, anchors, progress);
    bool is_anchored = network.relax();
    while (is_anchored && network.drop_worst(options.most_error)) is_anchored = network.relax();
    if (is_anchored) network.take_poses();
    return std::move(network.result);
}

} // namespace planum::scans
