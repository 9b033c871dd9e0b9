// SPDX-License-Identifier: MIT
#include "scans/registration/fine_alignment.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/scans_registration/scan_files.hpp"
#include "tests/unit/scans_registration/synthetic_ground.hpp"

using namespace planum;
using namespace planum::scans;
using geometry::Rigid3;
using geometry::Vector6;
using test::synthetic_ground;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

const Rigid3 kFirst{geometry::exp_rotation({0.0, 0.01, 0.3}), {-2.5, -2.0, 1.6}};
const Rigid3 kSecond{geometry::exp_rotation({0.01, 0.0, 2.2}), {-1.0, 2.0, 1.7}};

FineOptions small_options() {
    FineOptions options;
    options.levels = {{0.30, 0.60, 0.10, 20}, {0.10, 0.30, 0.03, 15}, {0.10, 0.30, 0.0, 20}};
    options.patch = 0.5;
    return options;
}

Rigid3 disturbed(const Rigid3& pose, double metres, double radians, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::Vector3d turn(normal(random), normal(random), normal(random));
    const Eigen::Vector3d shift(normal(random), normal(random), normal(random));
    Vector6 step;
    step << radians * turn.normalized(), metres * shift.normalized();
    return geometry::moved(pose, step);
}

FineResult align(const std::vector<Eigen::Vector3d>& target, const std::vector<Eigen::Vector3d>& source,
                 const Rigid3& start, const FineOptions& options = small_options()) {
    return align_scans(prepare_scan(target, options), prepare_scan(source, options), start, options);
}

} // namespace

TEST_CASE("The motion between two scans of the same ground is recovered, and swapped it is the inverse") {
    const auto target = synthetic_ground(kFirst, {.seed = 1});
    const auto source = synthetic_ground(kSecond, {.seed = 2});
    const Rigid3 truth = kFirst.inverse() * kSecond;
    const Rigid3 start = disturbed(truth, 0.05, 0.5 * kDegree, 3);
    const auto forward = align(target, source, start);
    REQUIRE(forward.is_accepted);
    const Vector6 error = geometry::step_between(truth, forward.target_from_source);
    CHECK(error.tail<3>().norm() < 0.001); // half of the noise of one point
    CHECK(error.head<3>().norm() < 0.02 * kDegree);
    const auto backward = align(source, target, start.inverse());
    REQUIRE(backward.is_accepted);
    const Vector6 closure = geometry::step_between(Rigid3{}, forward.target_from_source * backward.target_from_source);
    CHECK(closure.tail<3>().norm() < 0.001);
    CHECK(closure.head<3>().norm() < 0.02 * kDegree);
}

TEST_CASE("One thread and two give the same bits") {
    auto options = small_options();
    const auto target = synthetic_ground(kFirst, {.seed = 4});
    const auto source = synthetic_ground(kSecond, {.seed = 5});
    const Rigid3 start = disturbed(kFirst.inverse() * kSecond, 0.05, 0.5 * kDegree, 6);
    options.threads = 1;
    const auto one = align(target, source, start, options);
    options.threads = 2;
    const auto two = align(target, source, start, options);
    CHECK(one.target_from_source == two.target_from_source);
    CHECK(one.covariance == two.covariance);
    CHECK(one.verdict == two.verdict);
}

TEST_CASE("What was dug away does not pull the alignment along") {
    const auto target = synthetic_ground(kFirst, {.seed = 7});
    const auto source = synthetic_ground(kSecond, {.dug_depth = 0.03, .seed = 8});
    const Rigid3 truth = kFirst.inverse() * kSecond;
    const auto result = align(target, source, disturbed(truth, 0.05, 0.5 * kDegree, 9));
    REQUIRE(result.is_accepted);
    CHECK(geometry::step_between(truth, result.target_from_source).tail<3>().norm() < 0.001);
    int silent = 0;
    for (const auto& patch : result.patches) {
        const Eigen::Vector3d x = kFirst * patch.center;
        const bool is_floor = std::abs(x.x()) < 1.2 && std::abs(x.y()) < 0.7 && x.z() < -0.3;
        if (is_floor && patch.state != PatchState::Thin) {
            CHECK(patch.weight == 0.0);
            ++silent;
        }
    }
    CHECK(silent > 0);
}

TEST_CASE("A heap whose foot crept over the ground does not tilt the alignment") {
    const auto target = synthetic_ground(kFirst, {.points = 40000, .seed = 16});
    auto source = synthetic_ground(kSecond, {.points = 40000, .seed = 17});
    const Rigid3 scan_from_site = kSecond.inverse();
    for (auto& x : source) {
        Eigen::Vector3d x_in_site = kSecond * x;
        const double r = (x_in_site.head<2>() - Eigen::Vector2d(2.6, 1.8)).norm();
        x_in_site.z() += 0.010 * std::exp(-0.5 * r * r); // nowhere an edge
        x = scan_from_site * x_in_site;
    }
    const Rigid3 truth = kFirst.inverse() * kSecond;
    auto options = small_options();
    options.patch = 0.25;
    const auto result = align(target, source, disturbed(truth, 0.02, 0.2 * kDegree, 18), options);
    REQUIRE(result.is_accepted);
    const Vector6 error = geometry::step_between(truth, result.target_from_source);
    CHECK(error.tail<3>().norm() < 0.0003); // the heap is 10 mm high
    CHECK(error.head<3>().norm() < 0.008 * kDegree);
}

TEST_CASE("The stated covariance is neither too small nor too large") {
    const Rigid3 truth = kFirst.inverse() * kSecond;
    constexpr int kPairs = 24;
    auto options = small_options();
    options.levels = {{0.10, 0.30, 0.03, 15}, {0.05, 0.30, 0.0, 20}};
    options.patch = 0.25;
    int within = 0;
    double sum = 0.0;
    for (int i = 0; i < kPairs; ++i) {
        const auto seed = static_cast<unsigned>(100 + 2 * i);
        const auto result = align(synthetic_ground(kFirst, {.points = 25000, .seed = seed}),
                                  synthetic_ground(kSecond, {.points = 25000, .seed = seed + 1}), truth, options);
        REQUIRE(result.is_accepted);
        const Vector6 error = geometry::step_between(truth, result.target_from_source);
        const double chi = error.dot(result.information * error);
        within += chi < 12.592 ? 1 : 0; // 95 % of χ² with six numbers
        sum += chi;
    }
    CHECK(within >= 20);       // fewer of 24 at 95 %: one in 160
    CHECK(sum / kPairs > 2.0); // six expected; twice the σ that is right would give 1.5
}

TEST_CASE("Scans that do not belong together are refused with the reason") {
    const auto target = synthetic_ground(kFirst, {.seed = 10});
    const Rigid3 truth = kFirst.inverse() * kSecond;
    SECTION("an empty one") {
        const auto result = align(target, {}, truth);
        CHECK_FALSE(result.is_accepted);
        CHECK_THAT(result.verdict, Catch::Contains("too little common ground"));
    }
    SECTION("far away") {
        Rigid3 far = truth;
        far.translation += Eigen::Vector3d(50.0, 0.0, 0.0);
        CHECK_FALSE(align(target, synthetic_ground(kSecond, {.seed = 11}), far).is_accepted);
    }
    SECTION("a mirror image") {
        const auto mirrored = synthetic_ground(kSecond, {.seed = 12, .is_mirrored = true});
        CHECK_FALSE(align(target, mirrored, truth).is_accepted);
    }
}

TEST_CASE("A bare plane leaves directions open and is refused") {
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> even(-4.0, 4.0);
    std::vector<Eigen::Vector3d> plane;
    for (int i = 0; i < 8000; ++i) plane.emplace_back(even(random), even(random), -1.6);
    std::vector<Eigen::Vector3d> other;
    for (int i = 0; i < 8000; ++i) other.emplace_back(even(random), even(random), -1.6);
    const auto result = align(plane, other, disturbed(Rigid3{}, 0.02, 0.2 * kDegree, 14));
    CHECK_FALSE(result.is_accepted);
    INFO(result.verdict);
    CHECK(result.verdict.starts_with("refused"));
}

TEST_CASE("Points that are not finite are left out, strays that are too far are named") {
    auto points = synthetic_ground(kFirst, {.points = 100});
    points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
    CHECK(prepare_scan(points).points == 100);
    points.emplace_back(1e9, 0.0, 0.0);
    CHECK_THROWS_AS(prepare_scan(points), Error);
}

TEST_CASE("Ground with few points votes in larger pieces") {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 60; ++i) {
        for (int k = 0; k < 60; ++k) points.emplace_back(0.02 * i + 0.01, 0.02 * k + 0.01, -1.6); // a dense floor …
    }
    for (int i = 0; i < 12; ++i) {
        for (int k = 0; k < 8; ++k) points.emplace_back(20.0, 0.15 * i - 1.0, 0.15 * k); // … and a wall far away
    }
    const PatchMap map = make_patches(make_surfels(points, {0.0, 12, 0.0005, 1}), 0.25);
    std::vector<int> members(map.patches.size(), 0);
    for (const auto patch : map.patch_of) ++members[patch];
    int on_wall = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const bool is_wall = map.patches[i].center.x() > 10.0;
        const Eigen::Vector3d& center = map.patches[i].center;
        const bool is_inside = is_wall ? std::abs(center.y()) < 0.5 && center.z() > 0.25 && center.z() < 0.75 : true;
        on_wall += is_wall ? 1 : 0;
        if (is_inside && is_wall) CHECK(members[i] >= 12); // in pieces of 25 cm there would be 4
        if (!is_wall) CHECK(members[i] <= 169);            // 13 × 13 in one of 25 cm
    }
    CHECK(on_wall > 0);
}

TEST_CASE("Points that stand for many do not count as many") {
    // A row of dense source points over one target point each metre: all share the error of the few.
    std::vector<Eigen::Vector3d> few;
    std::vector<Eigen::Vector3d> many;
    for (int x = 0; x < 12; ++x) {
        for (int y = 0; y < 12; ++y) few.emplace_back(0.2 * x, 0.2 * y, -1.5);
    }
    for (int x = 0; x < 120; ++x) {
        for (int y = 0; y < 120; ++y) many.emplace_back(0.02 * x, 0.02 * y, -1.5);
    }
    const SurfelCloud target = make_surfels(few, {0.0, 12, 0.002, 1});
    const SurfelCloud source = make_surfels(many, {0.0, 12, 0.002, 1});
    MatchOptions options;
    options.max_distance = 0.5;
    options.ways = MatchWays::Both;
    std::vector<SurfelMatch> matches;
    (void)match_surfels(target, source, Rigid3{}, options, {}, {}, matches);
    double precision = 0.0;
    for (const auto& match : matches) {
        if (match.kind == MatchKind::Agree) precision += 1.0 / match.variance;
    }
    // The 144 points of the target, each good to 2 mm, are all that is known of its height.
    CHECK(precision < 144.0 / (0.002 * 0.002));
    CHECK(precision > 0.5 * 144.0 / (0.002 * 0.002));
}

TEST_CASE("Scans that are bent say so in their σ") {
    // The scanner drove: the ground of one scan rises and falls by 2 cm over some metres.
    const auto target = synthetic_ground(kFirst, {.points = 40000, .seed = 30});
    auto source = synthetic_ground(kSecond, {.points = 40000, .seed = 31});
    for (auto& x : source) x.z() += 0.02 * std::sin(0.9 * x.x()) * std::cos(0.7 * x.y());
    const Rigid3 truth = kFirst.inverse() * kSecond;
    auto options = small_options();
    options.levels = {{0.10, 0.30, 0.03, 15}, {0.05, 0.30, 0.0, 20}};
    options.patch = 0.25;
    const auto result = align(target, source, disturbed(truth, 0.02, 0.2 * kDegree, 32), options);
    const Vector6 error = geometry::step_between(truth, result.target_from_source);
    INFO(result.verdict << ", off by " << 1e3 * error.tail<3>().norm() << " mm");
    CHECK(error.dot(result.covariance.ldlt().solve(error)) < 22.46); // 99.9 % of χ² with six numbers
}

TEST_CASE("The real pair comes near its reference") {
    const auto folder = test::real_data("scans/pairs");
    if (!folder) return;
    FineOptions options;
    // The scanner drove while it turned: each scan is itself bent by a decimetre or two, which no pose mends.
    options.levels = {{1.0, 2.0, 0.5, 20}, {0.3, 0.6, 0.2, 15}};
    options.neighbours = 10;
    options.patch = 2.0;
    const auto target = prepare_scan(test::read_ply_points(*folder / "small_gicp_target.ply"), options);
    const auto source = prepare_scan(test::read_ply_points(*folder / "small_gicp_source.ply"), options);
    const auto reference = test::read_matrix(*folder / "small_gicp_T_target_source.txt");
    const auto result = align_scans(target, source, Rigid3{}, options);
    REQUIRE(result.is_accepted);
    const Vector6 error = geometry::step_between(reference, result.target_from_source);
    CHECK(error.tail<3>().norm() < 0.015); // the reference is good to about 10 mm
    CHECK(error.head<3>().norm() < 0.7 * kDegree);
}

TEST_CASE("Ranges that are all too long are found and do not lean scans that face each other") {
    const auto lengthened = [](std::vector<Eigen::Vector3d> points) {
        for (auto& x : points) x += 0.004 * x.normalized();
        return points;
    };
    const auto target = lengthened(synthetic_ground(kFirst, {.points = 40000, .seed = 20}));
    const auto source = lengthened(synthetic_ground(kSecond, {.points = 40000, .seed = 21}));
    const Rigid3 truth = kFirst.inverse() * kSecond;
    auto options = small_options();
    options.levels = {{0.10, 0.30, 0.03, 15}, {0.05, 0.30, 0.0, 20}};
    options.patch = 0.25;
    const auto start = disturbed(truth, 0.02, 0.2 * kDegree, 22);
    const auto result = align(target, source, start, options);
    REQUIRE(result.is_accepted);
    CHECK(result.range_offset > 0.003);
    CHECK(result.range_offset < 0.005);
    const Vector6 error = geometry::step_between(truth, result.target_from_source);
    CHECK(error.dot(result.information * error) < 22.46); // 99.9 % of χ² with six numbers
    options.range_offset_sigma = 0.0;
    const auto without = align(target, source, start, options);
    CHECK(without.range_offset == 0.0);
    const Vector6 leaning = geometry::step_between(truth, without.target_from_source);
    CHECK(leaning.head<3>().norm() > 3.0 * error.head<3>().norm());
}

TEST_CASE("Scans of a trench on two days meet again from 5 cm and 0.5° off") {
    const auto folder = test::real_data("scans/trench");
    if (!folder) return;
    const auto load = [&](const char* stem) {
        return prepare_scan(test::read_ptx_points(*folder / (std::string(stem) + ".ptx")));
    };
    const auto pose = [&](const char* stem) {
        return test::read_matrix(*folder / (std::string(stem) + ".true_site_from_scan.txt"));
    };
    const auto [first, second] = GENERATE(std::pair("2012-05-01/station1", "2012-05-02/station1"),
                                          std::pair("2012-05-01/station2", "2012-05-02/station0"),
                                          std::pair("2012-05-01/station2", "2012-05-02/station1"));
    INFO(first << " and " << second);
    const Rigid3 truth = pose(first).inverse() * pose(second);
    const auto result = align_scans(load(first), load(second), disturbed(truth, 0.05, 0.5 * kDegree, 15));
    REQUIRE(result.is_accepted);
    const Vector6 error = geometry::step_between(truth, result.target_from_source);
    CHECK(error.tail<3>().norm() < 0.0002);
    CHECK(error.head<3>().norm() < 0.003 * kDegree);
}
