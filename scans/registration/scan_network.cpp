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
        for (std::size_t scan = 0; scan < scans_; ++scan) {
            if (!is_anchored(scan)) continue;
            const std::size_t node = node_of_[scan];
            NetworkPose pose{graph_.site_from_scan[node], graph_.covariance[node], graph_.covariance[node]};
            add_held_share(pose, scan);
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
            if (!result.links[i].is_used || !is_anchored(link.target)) continue;
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

    /// Poses that hang on held ones err with them: with the nearest.
    void add_held_share(NetworkPose& pose, std::size_t scan) const {
        const NetworkAnchor* nearest = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& anchor : anchors_) {
            if (!anchor.is_held || part_[anchor.scan] != part_[scan]) continue;
            const double distance = (anchor.site_from_scan.translation - pose.site_from_scan.translation).norm();
            if (distance >= least) continue;
            least = distance;
            nearest = &anchor;
        }
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
