// SPDX-License-Identifier: MIT
#include "scans/registration/pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Cholesky>

#include "core/base/error.hpp"
#include "core/geometry/fit_rigid.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/scans_registration/g2o_file.hpp"

using namespace planum;
using namespace planum::scans;
using geometry::Matrix6;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

Vector6 noise(std::mt19937_64& random, double turn, double shift) {
    std::normal_distribution<double> normal;
    Vector6 step;
    for (int i = 0; i < 6; ++i) step[i] = (i < 3 ? turn : shift) * normal(random);
    return step;
}

struct Ring {
    std::vector<Rigid3> truth;
    std::vector<PoseNode> nodes;
    std::vector<PoseLink> links;
};

// Eight stations around a trench, each linked to the next two.
Ring a_ring(unsigned seed, double turn, double shift) {
    std::mt19937_64 random(seed);
    Ring ring;
    for (int i = 0; i < 8; ++i) {
        const double at = 0.785 * i;
        ring.truth.push_back({geometry::exp_rotation({0.01, 0.02, at}), {5.0 * std::cos(at), 5.0 * std::sin(at), 1.7}});
        ring.nodes.push_back(
            {geometry::moved(ring.truth.back(), noise(random, i == 0 ? 0.0 : 0.05, i == 0 ? 0.0 : 0.2)), i == 0});
    }
    Matrix6 information = Matrix6::Zero();
    information.diagonal().head<3>().setConstant(1.0 / (turn * turn));
    information.diagonal().tail<3>().setConstant(1.0 / (shift * shift));
    for (std::size_t i = 0; i < 8; ++i) {
        for (const std::size_t next : {(i + 1) % 8, (i + 2) % 8}) {
            const Rigid3 exact = ring.truth[i].inverse() * ring.truth[next];
            ring.links.push_back({i, next, geometry::moved(exact, noise(random, turn, shift)), information});
        }
    }
    return ring;
}

} // namespace

TEST_CASE("Links without error put every pose where it belongs") {
    auto ring = a_ring(1, 1e-12, 1e-12);
    for (auto& link : ring.links) link.information.setIdentity();
    const auto result = relax_poses(ring.nodes, ring.links);
    CHECK(result.has_converged);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(geometry::step_between(ring.truth[i], result.site_from_scan[i]).norm() < 1e-6);
    }
}

TEST_CASE("Fixed poses stay to the last bit, the cost falls, and the order of links does not matter") {
    auto ring = a_ring(2, 1e-4, 1e-3);
    ring.nodes[5] = {ring.truth[5], true};
    const auto result = relax_poses(ring.nodes, ring.links);
    CHECK(result.site_from_scan[0] == ring.nodes[0].site_from_scan);
    CHECK(result.site_from_scan[5] == ring.nodes[5].site_from_scan);
    CHECK(result.cost_after < result.cost_before);
    CHECK(result.covariance[5] == Matrix6::Zero());
    auto turned = ring.links;
    std::reverse(turned.begin(), turned.end());
    const auto other = relax_poses(ring.nodes, turned);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(geometry::step_between(result.site_from_scan[i], other.site_from_scan[i]).norm() < 1e-7);
    }
}

TEST_CASE("Marginal covariances are what repeating the measurement shows") {
    constexpr int kRuns = 300;
    double mahalanobis = 0.0;
    for (unsigned run = 0; run < kRuns; ++run) {
        const auto ring = a_ring(100 + run, 1e-4, 1e-3);
        const auto result = relax_poses(ring.nodes, ring.links);
        const Vector6 error = geometry::step_between(ring.truth[4], result.site_from_scan[4]);
        mahalanobis += error.dot(result.covariance[4].ldlt().solve(error)) / kRuns;
    }
    // χ² with six degrees of freedom: mean 6, its mean over 300 runs has a σ of 0.2.
    CHECK(mahalanobis > 5.0);
    CHECK(mahalanobis < 7.0);
}

TEST_CASE("A wrong link pulls least squares, with Huber it hardly does") {
    auto ring = a_ring(3, 1e-4, 1e-3);
    ring.links[3].target_from_source.translation += Eigen::Vector3d(0.5, 0.0, 0.0);
    PoseGraphOptions options;
    const auto pulled = relax_poses(ring.nodes, ring.links, options);
    options.huber = 3.0;
    const auto robust = relax_poses(ring.nodes, ring.links, options);
    double worst_pulled = 0.0;
    double worst_robust = 0.0;
    for (std::size_t i = 0; i < 8; ++i) {
        worst_pulled =
            std::max(worst_pulled, geometry::step_between(ring.truth[i], pulled.site_from_scan[i]).tail<3>().norm());
        worst_robust =
            std::max(worst_robust, geometry::step_between(ring.truth[i], robust.site_from_scan[i]).tail<3>().norm());
    }
    CHECK(worst_pulled > 0.05);
    CHECK(worst_robust < 0.01);
    CHECK(robust.links[3].after > 100.0);
}

TEST_CASE("A pose without a chain to a fixed one is named") {
    auto ring = a_ring(4, 1e-4, 1e-3);
    ring.nodes.push_back({});
    CHECK_THROWS_WITH(relax_poses(ring.nodes, ring.links), Catch::Contains("pose 8"));
    ring.nodes.pop_back();
    ring.links[0].source = 77;
    CHECK_THROWS_AS(relax_poses(ring.nodes, ring.links), Error);
}

TEST_CASE("Known pose graphs relax to one optimum from two starts") {
    const auto folder = test::real_data("scans/g2o");
    if (!folder) return;
    const auto name = GENERATE("smallGrid3D.g2o", "sphere2500.g2o");
    INFO(name);
    const auto graph = test::read_g2o(*folder / name);
    REQUIRE(graph.nodes.size() >= 125);
    PoseGraphOptions options;
    options.with_covariances = false;
    const auto given = relax_poses(graph.nodes, graph.links, options);
    const auto tree = relax_poses(spread_from_fixed(graph.nodes, graph.links), graph.links, options);
    CHECK(given.has_converged);
    CHECK(tree.has_converged);
    CHECK(given.cost_after == Approx(tree.cost_after).epsilon(0.001));
    CHECK(given.cost_after < 0.1 * given.cost_before);
}
