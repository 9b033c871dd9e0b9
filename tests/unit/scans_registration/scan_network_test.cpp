// SPDX-License-Identifier: MIT
#include "scans/registration/scan_network.hpp"

#include <random>

#include <Eigen/Cholesky>

#include "scans/registration/pair_selection.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;
using geometry::Matrix6;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

constexpr double kShift = 0.001; ///< σ of a link [m]
constexpr double kTurn = 0.0001; ///< [rad]

Matrix6 link_covariance() {
    Matrix6 covariance = Matrix6::Zero();
    covariance.diagonal().head<3>().setConstant(kTurn * kTurn);
    covariance.diagonal().tail<3>().setConstant(kShift * kShift);
    return covariance;
}

/// Five scans in a ring, every neighbour and next but one linked with noise of the stated size.
struct Ring {
    std::vector<Rigid3> truth;
    std::vector<NetworkLink> links;
};

Ring a_ring(unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Ring ring;
    for (int i = 0; i < 5; ++i) {
        const double angle = 1.2566 * i;
        ring.truth.push_back({geometry::exp_rotation({0.01, 0.0, angle}),
                              {500.0 + 6.0 * std::cos(angle), 700.0 + 6.0 * std::sin(angle), 100.0}});
    }
    for (std::size_t i = 0; i < 5; ++i) {
        for (const std::size_t step : {1U, 2U}) {
            const std::size_t j = (i + step) % 5;
            Vector6 noise;
            for (int k = 0; k < 6; ++k) noise[k] = (k < 3 ? kTurn : kShift) * normal(random);
            const Rigid3 right = ring.truth[i].inverse() * ring.truth[j];
            ring.links.push_back({i, j, geometry::moved(right, noise), link_covariance()});
        }
    }
    return ring;
}

double chi_square(const NetworkPose& pose, const Rigid3& truth) {
    const Vector6 error = geometry::step_between(truth, pose.site_from_scan);
    return error.dot(pose.covariance.ldlt().solve(error));
}

} // namespace

TEST_CASE("Scans that hang on one marked scan are placed, and their covariance is honest") {
    double sum = 0.0;
    int count = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const Ring ring = a_ring(seed);
        std::mt19937_64 random(1000 + seed);
        std::normal_distribution<double> normal;
        Vector6 noise;
        for (int k = 0; k < 6; ++k) noise[k] = 2.0 * (k < 3 ? kTurn : kShift) * normal(random);
        const NetworkAnchor anchor{2, geometry::moved(ring.truth[2], noise), 4.0 * link_covariance(), false};
        const auto result = solve_network(5, ring.links, std::vector{anchor});
        for (std::size_t i = 0; i < 5; ++i) {
            REQUIRE(result.poses[i]);
            sum += chi_square(*result.poses[i], ring.truth[i]);
            ++count;
        }
        CHECK(result.cost_after <= result.cost_before);
    }
    CHECK(sum / count > 4.5); // six expected; 200 values, not independent, of variance 12
    CHECK(sum / count < 7.5);
}

TEST_CASE("Noise that all links of a scan share is stated though no loop shows it") {
    // Every scan errs by itself, as where few walls are seen: the links agree with each other perfectly.
    const Matrix6 own = 0.5 * link_covariance();
    double sum = 0.0;
    int count = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Ring ring = a_ring(seed);
        std::mt19937_64 random(2000 + seed);
        std::normal_distribution<double> normal;
        std::vector<Rigid3> seen;
        for (const auto& pose : ring.truth) {
            Vector6 noise;
            for (int k = 0; k < 6; ++k) noise[k] = std::sqrt(0.5) * (k < 3 ? kTurn : kShift) * normal(random);
            seen.push_back(geometry::moved(pose, noise));
        }
        for (auto& link : ring.links) {
            const Rigid3& target = ring.truth[link.target];
            Matrix6 turn = Matrix6::Zero();
            turn.topLeftCorner<3, 3>() = target.rotation.transpose();
            turn.bottomRightCorner<3, 3>() = target.rotation.transpose();
            link.target_from_source = seen[link.target].inverse() * seen[link.source];
            link.covariance = turn *
                              (own + carried_covariance(own, target.translation, ring.truth[link.source].translation)) *
                              turn.transpose();
        }
        const NetworkAnchor held{0, ring.truth[0], Matrix6::Zero(), true};
        const auto result = solve_network(5, ring.links, std::vector{held});
        for (std::size_t i = 1; i < 5; ++i) {
            REQUIRE(result.poses[i]);
            sum += chi_square(*result.poses[i], ring.truth[i]);
            ++count;
        }
    }
    CHECK(sum / count < 7.5); // six expected
    CHECK(sum / count > 2.5); // twice the σ that is right would give 1.5
}

TEST_CASE("Held scans do not move, and what hangs on them errs with them") {
    const Ring ring = a_ring(3);
    const NetworkAnchor held{0, ring.truth[0], 9.0 * link_covariance(), true};
    const auto result = solve_network(5, ring.links, std::vector{held});
    REQUIRE(result.poses[0]);
    CHECK(result.poses[0]->site_from_scan == ring.truth[0]);
    REQUIRE(result.poses[3]);
    const Matrix6 more = result.poses[3]->covariance - result.poses[3]->link_covariance;
    CHECK(more.diagonal().tail<3>().minCoeff() >= 9.0 * kShift * kShift * 0.999);
}

TEST_CASE("A link that contradicts the rest is left out and named, the others stay") {
    Ring ring = a_ring(4);
    ring.links[3].target_from_source.translation.x() += 0.10;
    const NetworkAnchor anchor{0, ring.truth[0], link_covariance(), false};
    const auto result = solve_network(5, ring.links, std::vector{anchor});
    for (std::size_t i = 0; i < ring.links.size(); ++i) CHECK(result.links[i].is_used == (i != 3));
    CHECK_THAT(result.links[3].reason, Catch::Contains("contradicts"));
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK((result.poses[i]->site_from_scan.translation - ring.truth[i].translation).norm() < 5.0 * kShift);
    }
}

TEST_CASE("What hangs on no anchor stays without a pose") {
    const Ring ring = a_ring(5);
    const auto alone =
        solve_network(6, ring.links, std::vector{NetworkAnchor{5, ring.truth[0], link_covariance(), false}});
    for (std::size_t i = 0; i < 5; ++i) CHECK_FALSE(alone.poses[i]);
    CHECK(alone.poses[5]);
    const auto nothing = solve_network(5, ring.links, {});
    for (const auto& pose : nothing.poses) CHECK_FALSE(pose);
}

TEST_CASE("Chosen pairs keep together what can hang together, and stay few") {
    std::vector<PairCandidate> all;
    std::mt19937_64 random(6);
    for (std::size_t a = 0; a < 12; ++a) {
        for (std::size_t b = a + 1; b < 12; ++b) {
            if ((a < 6) == (b < 6)) all.push_back({a, b, static_cast<double>(random() % 100)});
        }
    }
    const std::vector<std::size_t> hubs{0};
    const auto chosen = select_pairs(all, 12, 4, hubs);
    CHECK(connected_parts(chosen, 12) == connected_parts(all, 12));
    CHECK(chosen.size() < all.size());
    CHECK(chosen.size() >= 10);
    CHECK(select_pairs(all, 12, 0, {}).size() == 10); // a spanning tree of each half
}
