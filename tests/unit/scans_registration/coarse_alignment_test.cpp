// SPDX-License-Identifier: MIT
#include "scans/registration/coarse_alignment.hpp"

#include <numbers>
#include <random>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/scans_registration/textured_room.hpp"

using namespace planum;
using namespace planum::scans;
using geometry::Rigid3;
using geometry::Vector6;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Places within 20 m with a word for each; features of the same word look alike.
FeatureSet features_at(const std::vector<Eigen::Vector3d>& places, const std::vector<unsigned>& words) {
    FeatureSet set;
    set.descriptors.resize(static_cast<Eigen::Index>(places.size()), kDescriptorSize);
    for (std::size_t i = 0; i < places.size(); ++i) {
        set.features.push_back({{10.0 * static_cast<double>(i), 0.0}, places[i], 4.0F, Channel::Reflectance});
        std::mt19937 random(words[i]);
        for (Eigen::Index k = 0; k < kDescriptorSize; ++k) {
            set.descriptors(static_cast<Eigen::Index>(i), k) = static_cast<float>(random() % 1000);
        }
        set.descriptors.row(static_cast<Eigen::Index>(i)).normalize();
    }
    return set;
}

struct Pair {
    FeatureSet target;
    FeatureSet source;
    Rigid3 truth;
};

/// `good` features that both see, with σ 2 cm, and `bad` ones that only look alike.
Pair a_pair(int good, int bad, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> even(-15.0, 15.0);
    std::uniform_real_distribution<double> up(-2.0, 3.0);
    std::normal_distribution<double> noise(0.0, 0.02);
    const auto place = [&] { return Eigen::Vector3d(even(random), even(random), up(random)); };
    const auto off = [&] { return Eigen::Vector3d(noise(random), noise(random), noise(random)); };
    Pair pair;
    pair.truth = {geometry::exp_rotation({0.01, -0.02, 0.2 * even(random)}), 0.5 * place()};
    std::vector<Eigen::Vector3d> in_target;
    std::vector<Eigen::Vector3d> in_source;
    std::vector<unsigned> words;
    for (int i = 0; i < good + bad; ++i) {
        const Eigen::Vector3d x = place();
        in_source.push_back(x + off());
        in_target.push_back(i < good ? Eigen::Vector3d(pair.truth * x + off()) : place());
        words.push_back(seed * 1000 + static_cast<unsigned>(i));
    }
    pair.target = features_at(in_target, words);
    pair.source = features_at(in_source, words);
    return pair;
}

Rigid3 standing(double x, double y, double heading) {
    return {geometry::exp_rotation({0.004, -0.006, heading}), {x, y, 1.7}};
}

} // namespace

TEST_CASE("Features that fit together place a scan, whatever the rest looks like") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const Pair pair = a_pair(25, 75, seed);
        const auto result = align_coarsely(pair.target, pair.source);
        INFO(seed << ": " << result.verdict);
        REQUIRE(result.is_accepted);
        CHECK(result.inliers >= 23);
        const Vector6 error = geometry::step_between(pair.truth, result.target_from_source);
        CHECK(error.tail<3>().norm() < 0.03); // 2 cm · √2 · √(3 / 25) and four times that with the rotation
        CHECK(error.head<3>().norm() < 0.2 * kDegree);
    }
}

TEST_CASE("In 200 random pairings of scans that do not belong together none is accepted") {
    int accepted = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const Pair pair = a_pair(0, 100, seed);
        accepted += align_coarsely(pair.target, pair.source).is_accepted ? 1 : 0;
    }
    CHECK(accepted == 0);
}

TEST_CASE("The same seed gives the same bits") {
    const Pair pair = a_pair(20, 60, 7);
    const auto one = align_coarsely(pair.target, pair.source);
    const auto two = align_coarsely(pair.target, pair.source);
    CHECK(one.target_from_source == two.target_from_source);
    CHECK(one.verdict == two.verdict);
}

TEST_CASE("Too few features, or all in one spot, place nothing and say why") {
    const auto few = align_coarsely(a_pair(6, 0, 1).target, a_pair(6, 0, 1).source);
    CHECK_FALSE(few.is_accepted);
    CHECK_THAT(few.verdict, Catch::Contains("look alike"));
    CHECK_FALSE(align_coarsely({}, {}).is_accepted);
    std::vector<Eigen::Vector3d> line;
    std::vector<unsigned> words;
    for (unsigned i = 0; i < 30; ++i) {
        line.emplace_back(0.5 * i, 0.0, 0.0);
        words.push_back(i);
    }
    const auto result = align_coarsely(features_at(line, words), features_at(line, words));
    CHECK_FALSE(result.is_accepted);
}

TEST_CASE("Only the best match in both directions that is clearly better than the next counts") {
    const std::vector<Eigen::Vector3d> places{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const FeatureSet target = features_at(places, {1, 2, 2});
    const FeatureSet source = features_at(places, {1, 2, 3});
    const auto matches = match_features(target, source, 0.8);
    REQUIRE(matches.size() == 1); // word 2 has two equal partners, word 3 none
    CHECK(matches[0].target == 0);
    CHECK(matches[0].source == 0);
}

TEST_CASE("A room scanned from two places comes together by its patterns") {
    const Rigid3 first = standing(-2.0, -1.0, 0.4);
    const Rigid3 second = standing(1.0, 1.0, 2.9);
    const auto target = find_features(test::room_panorama(first), Channel::Reflectance);
    const auto source = find_features(test::room_panorama(second), Channel::Reflectance);
    const auto result = align_coarsely(target, source);
    INFO(result.verdict);
    REQUIRE(result.is_accepted);
    const Vector6 error = geometry::step_between(first.inverse() * second, result.target_from_source);
    CHECK(error.tail<3>().norm() < 0.05); // a pixel is 6 cm at the far wall
    CHECK(error.head<3>().norm() < 0.5 * kDegree);
}

TEST_CASE("Another room and a mirror image are refused") {
    const auto target = find_features(test::room_panorama(standing(-2.0, -1.0, 0.4)), Channel::Reflectance);
    const Rigid3 second = standing(1.0, 1.0, 2.9);
    const auto other = find_features(test::room_panorama(second, {.pattern = 77}), Channel::Reflectance);
    CHECK_FALSE(align_coarsely(target, other).is_accepted);
    const auto mirrored = find_features(test::room_panorama(second, {.is_mirrored = true}), Channel::Reflectance);
    CHECK_FALSE(align_coarsely(target, mirrored).is_accepted);
}

TEST_CASE("A feature is found where it is, also across the seam, and nothing is found where there is nothing") {
    const auto features = find_features(test::room_panorama(standing(0.0, 0.0, 0.0)), Channel::Reflectance);
    REQUIRE(features.features.size() > 100);
    int near_seam = 0;
    for (const auto& feature : features.features) {
        near_seam += feature.pixel.x() < 5.0 || feature.pixel.x() > 715.0 ? 1 : 0;
        CHECK(feature.x_in_scan.norm() > 1.0);
    }
    CHECK(near_seam > 0);
    PanoramaBuilder empty({}, {true, false, false, false});
    CHECK(find_features(empty.finish(Progress::none()), Channel::Reflectance).features.empty());
    PanoramaBuilder bare({}, {});
    CHECK_THROWS_AS(find_features(bare.finish(Progress::none()), Channel::Reflectance), Error);
}
