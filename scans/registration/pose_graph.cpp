// SPDX-License-Identifier: MIT
#include "scans/registration/pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include "core/base/error.hpp"

namespace planum::scans {

using geometry::Matrix6;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr std::ptrdiff_t kFixed = -1;

/// The inverse of the right Jacobian of SO(3): how a small turn on the right changes the logarithm.
Eigen::Matrix3d inverse_right_jacobian(const Eigen::Vector3d& turn) {
    const double angle = turn.norm();
    const Eigen::Matrix3d w = geometry::cross_matrix(turn);
    double of_square = 1.0 / 12.0 + angle * angle / 720.0;
    if (angle > 1e-3) {
        of_square = 1.0 / (angle * angle) - (1.0 + std::cos(angle)) / (2.0 * angle * std::sin(angle));
    }
    return Eigen::Matrix3d::Identity() + 0.5 * w + of_square * w * w;
}

/// Error of a link and its derivatives to the steps of both poses.
struct Linear {
    Vector6 error;
    Matrix6 by_target;
    Matrix6 by_source;
};

Vector6 error_of(const PoseLink& link, const Rigid3& site_from_target, const Rigid3& site_from_source) {
    return geometry::step_between(link.target_from_source, site_from_target.inverse() * site_from_source);
}

Linear linearize(const PoseLink& link, const Rigid3& site_from_target, const Rigid3& site_from_source) {
    Linear l;
    l.error = error_of(link, site_from_target, site_from_source);
    // Turning the target by ω turns the predicted pose by −Rᵀω on the left, the source by +Rᵀω.
    const Eigen::Matrix3d back = site_from_target.rotation.transpose();
    const Eigen::Vector3d turn = l.error.head<3>();
    const Eigen::Matrix3d log_by_left = inverse_right_jacobian(-turn); // the left one
    const Eigen::Vector3d between = site_from_source.translation - site_from_target.translation;
    l.by_target.setZero();
    l.by_source.setZero();
    l.by_source.topLeftCorner<3, 3>() = log_by_left * back;
    l.by_target.topLeftCorner<3, 3>() = -l.by_source.topLeftCorner<3, 3>();
    l.by_source.bottomRightCorner<3, 3>() = back;
    l.by_target.bottomRightCorner<3, 3>() = -back;
    l.by_target.bottomLeftCorner<3, 3>() = back * geometry::cross_matrix(between);
    return l;
}

class Relaxation {
  public:
    Relaxation(std::span<const PoseNode> nodes, std::span<const PoseLink> links, const PoseGraphOptions& options)
        : links_(links), options_(options) {
        for (const auto& node : nodes) {
            poses.push_back(node.site_from_scan);
            column_.push_back(node.is_fixed ? kFixed : 6 * free_++);
        }
    }

    [[nodiscard]] double cost(const std::vector<Rigid3>& at) const {
        double sum = 0.0;
        for (const auto& link : links_) {
            const Vector6 e = error_of(link, at[link.target], at[link.source]);
            sum += rho(e.dot(link.information * e));
        }
        return sum;
    }

    // Returns true if converged.
    bool run(PoseGraphResult& result, Progress& progress) {
        double now = cost(poses);
        double damping = 1e-6;
        for (int i = 0; i < options_.max_iterations && free_ > 0; ++i) {
            progress.check();
            ++result.iterations;
            linear_system();
            bool is_better = false;
            for (int attempt = 0; attempt < 12 && !is_better; ++attempt) {
                const std::vector<Rigid3> trial = stepped(damping);
                const double then = trial.empty() ? now : cost(trial);
                is_better = then < now;
                damping = is_better ? std::max(damping * 0.2, 1e-12) : damping * 8.0;
                if (!is_better) continue;
                const bool is_done = now - then <= options_.tolerance * now;
                poses = trial;
                now = then;
                if (is_done) return true;
            }
            if (!is_better) return true; // no step is downhill: rounding is reached
        }
        return free_ == 0;
    }

    // Columns of the inverse, a pose at a time: 6 solves a pose with the factor at hand.
    std::vector<Matrix6> covariances() {
        std::vector<Matrix6> all(poses.size(), Matrix6::Zero());
        if (free_ == 0) return all;
        linear_system();
        solver_.factorize(information_);
        if (solver_.info() != Eigen::Success) {
            throw Error(ErrorCode::Internal, "pose graph whose information is singular");
        }
        Eigen::MatrixXd unit(information_.rows(), 6);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            if (column_[i] == kFixed) continue;
            unit.setZero();
            unit.middleRows<6>(column_[i]).setIdentity();
            const Eigen::MatrixXd columns = solver_.solve(unit);
            const Matrix6 block = columns.middleRows<6>(column_[i]);
            all[i] = 0.5 * (block + block.transpose());
        }
        return all;
    }

    std::vector<Rigid3> poses;

  private:
    [[nodiscard]] double rho(double square) const {
        const double k = options_.huber;
        if (k <= 0.0 || square <= k * k) return square;
        return 2.0 * k * std::sqrt(square) - k * k;
    }

    [[nodiscard]] double robust_weight(double square) const {
        const double k = options_.huber;
        return k <= 0.0 || square <= k * k ? 1.0 : k / std::sqrt(square);
    }

    void linear_system() {
        triplets_.clear();
        gradient_ = Eigen::VectorXd::Zero(6 * free_);
        for (const auto& link : links_) {
            const Linear l = linearize(link, poses[link.target], poses[link.source]);
            const Matrix6 omega = robust_weight(l.error.dot(link.information * l.error)) * link.information;
            const std::ptrdiff_t a = column_[link.target];
            const std::ptrdiff_t b = column_[link.source];
            if (a != kFixed) {
                put(a, a, l.by_target.transpose() * omega * l.by_target);
                gradient_.segment<6>(a) += l.by_target.transpose() * omega * l.error;
            }
            if (b != kFixed) {
                put(b, b, l.by_source.transpose() * omega * l.by_source);
                gradient_.segment<6>(b) += l.by_source.transpose() * omega * l.error;
            }
            if (a == kFixed || b == kFixed) continue;
            const Matrix6 across = l.by_target.transpose() * omega * l.by_source;
            if (a > b) {
                put(a, b, across);
            } else {
                put(b, a, across.transpose());
            }
        }
        information_.resize(6 * free_, 6 * free_);
        information_.setFromTriplets(triplets_.begin(), triplets_.end());
        if (!is_analyzed_) solver_.analyzePattern(information_);
        is_analyzed_ = true;
    }

    void put(std::ptrdiff_t row, std::ptrdiff_t column, const Matrix6& block) {
        for (std::ptrdiff_t r = 0; r < 6; ++r) {
            for (std::ptrdiff_t c = 0; c < 6; ++c) {
                if (row + r < column + c) continue; // lower triangle
                triplets_.emplace_back(static_cast<int>(row + r), static_cast<int>(column + c), block(r, c));
            }
        }
    }

    // Empty if the damped system cannot be factorized.
    std::vector<Rigid3> stepped(double damping) {
        Sparse damped = information_;
        for (Eigen::Index i = 0; i < damped.rows(); ++i) damped.coeffRef(i, i) *= 1.0 + damping;
        solver_.factorize(damped);
        if (solver_.info() != Eigen::Success) return {};
        const Eigen::VectorXd step = solver_.solve(-gradient_);
        if (!step.allFinite()) return {};
        std::vector<Rigid3> trial = poses;
        for (std::size_t i = 0; i < trial.size(); ++i) {
            if (column_[i] != kFixed) trial[i] = geometry::moved(trial[i], step.segment<6>(column_[i]));
        }
        return trial;
    }

    std::span<const PoseLink> links_;
    const PoseGraphOptions& options_;
    std::vector<std::ptrdiff_t> column_;
    std::ptrdiff_t free_ = 0;
    std::vector<Eigen::Triplet<double>> triplets_;
    Sparse information_;
    Eigen::VectorXd gradient_;
    Eigen::SimplicialLDLT<Sparse, Eigen::Lower> solver_;
    bool is_analyzed_ = false;
};

// The order in which links lead from the fixed poses to the others, and which way.
struct TreeLink {
    std::size_t link = 0;
    bool leads_to_source = true;
};

std::vector<TreeLink> spanning_tree(std::span<const PoseNode> nodes, std::span<const PoseLink> links,
                                    std::vector<bool>& reached) {
    std::vector<std::vector<std::size_t>> links_of(nodes.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
        links_of[links[i].target].push_back(i);
        links_of[links[i].source].push_back(i);
    }
    reached.assign(nodes.size(), false);
    std::deque<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].is_fixed) continue;
        reached[i] = true;
        open.push_back(i);
    }
    std::vector<TreeLink> tree;
    for (; !open.empty(); open.pop_front()) {
        for (const auto at : links_of[open.front()]) {
            const bool leads_to_source = links[at].target == open.front();
            const std::size_t other = leads_to_source ? links[at].source : links[at].target;
            if (reached[other]) continue;
            reached[other] = true;
            tree.push_back({at, leads_to_source});
            open.push_back(other);
        }
    }
    return tree;
}

void check_links(std::span<const PoseNode> nodes, std::span<const PoseLink> links) {
    for (std::size_t i = 0; i < links.size(); ++i) {
        const auto& link = links[i];
        if (link.target >= nodes.size() || link.source >= nodes.size() || link.target == link.source) {
            throw Error(ErrorCode::BadInput,
                        fmt::format("link {} joins poses {} and {} of {}", i, link.target, link.source, nodes.size()));
        }
        if (!link.information.allFinite() || !link.target_from_source.rotation.allFinite() ||
            !link.target_from_source.translation.allFinite()) {
            throw Error(ErrorCode::BadInput, fmt::format("link {} has a number that is not finite", i));
        }
    }
}

void check_reach(std::span<const PoseNode> nodes, std::span<const PoseLink> links) {
    std::vector<bool> reached;
    (void)spanning_tree(nodes, links, reached);
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost != reached.end()) {
        throw Error(ErrorCode::BadInput,
                    fmt::format("no chain of links leads from a fixed pose to pose {}", lost - reached.begin()));
    }
}

} // namespace

double link_error(const PoseLink& link, const Rigid3& site_from_target, const Rigid3& site_from_source) {
    const Vector6 e = error_of(link, site_from_target, site_from_source);
    return std::sqrt(std::max(0.0, e.dot(link.information * e)));
}

std::vector<PoseNode> spread_from_fixed(std::span<const PoseNode> nodes, std::span<const PoseLink> links) {
    check_links(nodes, links);
    std::vector<PoseNode> spread(nodes.begin(), nodes.end());
    std::vector<bool> reached;
    for (const auto& step : spanning_tree(nodes, links, reached)) {
        const PoseLink& link = links[step.link];
        if (step.leads_to_source) {
            spread[link.source].site_from_scan = spread[link.target].site_from_scan * link.target_from_source;
        } else {
            spread[link.target].site_from_scan = spread[link.source].site_from_scan * link.target_from_source.inverse();
        }
    }
    return spread;
}

PoseGraphResult relax_poses(std::span<const PoseNode> nodes, std::span<const PoseLink> links,
                            const PoseGraphOptions& options, Progress& progress) {
    check_links(nodes, links);
    check_reach(nodes, links);
    progress.step("global relaxation");
    Relaxation relaxation(nodes, links, options);
    PoseGraphResult result;
    result.cost_before = relaxation.cost(relaxation.poses);
    for (const auto& link : links) {
        result.links.push_back({link_error(link, relaxation.poses[link.target], relaxation.poses[link.source])});
    }
    result.has_converged = relaxation.run(result, progress);
    result.cost_after = relaxation.cost(relaxation.poses);
    for (std::size_t i = 0; i < links.size(); ++i) {
        const Rigid3& target = relaxation.poses[links[i].target];
        const Rigid3& source = relaxation.poses[links[i].source];
        const Vector6 e = error_of(links[i], target, source);
        result.links[i].after = link_error(links[i], target, source);
        result.links[i].turn = e.head<3>().norm();
        result.links[i].shift = e.tail<3>().norm();
    }
    if (options.with_covariances) result.covariance = relaxation.covariances();
    result.site_from_scan = std::move(relaxation.poses);
    return result;
}

} // namespace planum::scans
