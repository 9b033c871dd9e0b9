// SPDX-License-Identifier: MIT
#include "scans/registration/markers.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using namespace planum::scans;
using Eigen::Vector3d;
using geometry::Rigid3;

namespace {

std::vector<Marker> pegs() {
    return {{"A", {104, 201, 50.2}}, {"B", {97, 205, 51.0}},  {"C", {94, 196, 50.1}},
            {"D", {102, 193, 51.6}}, {"E", {107, 206, 50.7}}, {"F", {99, 199, 52.3}}};
}

const Rigid3 kTruth{geometry::exp_rotation({0.01, -0.02, 2.1}), {101.0, 198.0, 51.7}};

std::vector<Marker> seen_from(const Rigid3& site_from_scan, const std::vector<Marker>& survey, double sigma,
                              unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<Marker> seen;
    for (const auto& marker : survey) {
        const Vector3d error(noise(random), noise(random), noise(random));
        seen.push_back({marker.name, site_from_scan.inverse() * marker.position + sigma * error});
    }
    return seen;
}

const MarkerResidual& of(const MarkerPlacement& placement, const std::string& name) {
    return *std::find_if(placement.residuals.begin(), placement.residuals.end(),
                         [&](const MarkerResidual& r) { return r.name == name; });
}

} // namespace

TEST_CASE("Markers without error give the pose back") {
    const auto placement = place_by_markers(pegs(), seen_from(kTruth, pegs(), 0.0, 1));
    REQUIRE(placement.is_placed);
    CHECK(placement.used == 6);
    CHECK(geometry::step_between(kTruth, placement.site_from_scan).norm() < 1e-9);
    for (const auto& entry : placement.residuals) CHECK(entry.residual.norm() < 1e-9);
}

TEST_CASE("Pose errors lie inside the stated bounds as often as they should") {
    int inside = 0;
    constexpr int kRuns = 400;
    for (unsigned run = 0; run < kRuns; ++run) {
        auto survey = pegs();
        const auto seen = seen_from(kTruth, survey, 0.001, 2 * run);
        survey = seen_from(Rigid3{}, survey, 0.001, 2 * run + 1);
        const auto placement = place_by_markers(survey, seen);
        REQUIRE(placement.is_placed);
        const auto error = geometry::step_between(kTruth, placement.site_from_scan);
        if (std::abs(error[3]) < 1.96 * std::sqrt(placement.covariance(3, 3))) ++inside;
    }
    CHECK(inside >= 0.92 * kRuns);
    CHECK(inside <= 0.99 * kRuns);
}

TEST_CASE("A marker that was knocked over is named and left out") {
    auto seen = seen_from(kTruth, pegs(), 0.001, 3);
    seen[3].position.z() += 0.05;
    const auto placement = place_by_markers(pegs(), seen);
    REQUIRE(placement.is_placed);
    CHECK(placement.used == 5);
    CHECK_FALSE(of(placement, "D").is_used);
    CHECK_THAT(of(placement, "D").reason, Catch::Contains("off its place"));
    CHECK_THAT(placement.verdict, Catch::Contains("D left out"));
    CHECK(geometry::step_between(kTruth, placement.site_from_scan).tail<3>().norm() < 0.01);
}

TEST_CASE("Of four markers one wrong one is found, of three it is only said that they do not fit") {
    auto survey = pegs();
    survey.resize(4);
    auto seen = seen_from(kTruth, survey, 0.0005, 4);
    seen[1].position.x() -= 0.3;
    const auto placement = place_by_markers(survey, seen);
    REQUIRE(placement.is_placed);
    CHECK_FALSE(of(placement, "B").is_used);
    seen.pop_back();
    const auto refused = place_by_markers(survey, seen);
    CHECK_FALSE(refused.is_placed);
    CHECK_THAT(refused.verdict, Catch::Contains("nobody can say which"));
}

TEST_CASE("Two markers with swapped names are recognised") {
    auto seen = seen_from(kTruth, pegs(), 0.001, 5);
    std::swap(seen[0].name, seen[4].name);
    const auto placement = place_by_markers(pegs(), seen);
    REQUIRE(placement.is_placed);
    CHECK(of(placement, "A").reason == "swapped with E");
    CHECK(of(placement, "E").reason == "swapped with A");
}

TEST_CASE("A marker under the name of another place is recognised") {
    auto seen = seen_from(kTruth, pegs(), 0.001, 6);
    seen.pop_back();    // F is not seen
    seen[2].name = "F"; // C goes by its name
    const auto placement = place_by_markers(pegs(), seen);
    REQUIRE(placement.is_placed);
    CHECK_THAT(of(placement, "F").reason, Catch::Contains("lies where C was surveyed"));
}

TEST_CASE("Too few, doubled and unknown markers are refused with a sentence") {
    auto seen = seen_from(kTruth, pegs(), 0.001, 7);
    seen.resize(4);
    seen[0].name = "Z";
    seen[1].name = "C";
    const auto placement = place_by_markers(pegs(), seen);
    CHECK_FALSE(placement.is_placed);
    CHECK_THAT(placement.verdict, Catch::Contains("1 of the scan's 4 markers"));
    CHECK_THAT(placement.verdict, Catch::Contains("Z: not in the survey"));
    CHECK_THAT(placement.verdict, Catch::Contains("C: measured more than once"));
    CHECK_FALSE(place_by_markers({}, {}).is_placed);
}

TEST_CASE("Markers on a line are refused because the turn about it is open") {
    std::vector<Marker> line;
    for (int i = 0; i < 5; ++i) line.push_back({std::to_string(i), Vector3d(2.0 * i, 1.0 * i, 0.1 * i)});
    const auto placement = place_by_markers(line, seen_from(kTruth, line, 0.001, 8));
    CHECK_FALSE(placement.is_placed);
    CHECK_THAT(placement.verdict, Catch::Contains("line"));
}

TEST_CASE("Two halves that contradict each other are not decided by chance") {
    auto survey = pegs();
    auto seen = seen_from(kTruth, survey, 0.0003, 9);
    for (std::size_t i = 3; i < 6; ++i) seen[i].position += Vector3d(0.4, 0.1, 0.0);
    const auto placement = place_by_markers(survey, seen);
    CHECK_FALSE(placement.is_placed);
    CHECK_THAT(placement.verdict, Catch::Contains("neither set is larger"));
}

TEST_CASE("A mirrored scan does not fit the survey") {
    auto seen = seen_from(kTruth, pegs(), 0.001, 10);
    for (auto& marker : seen) marker.position.x() *= -1.0;
    const auto placement = place_by_markers(pegs(), seen);
    CHECK_FALSE(placement.is_placed);
}

TEST_CASE("Twenty markers with five wrong ones are sorted out") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> place(-15.0, 15.0);
    std::vector<Marker> survey;
    for (int i = 0; i < 20; ++i) {
        survey.push_back({"M" + std::to_string(i), {place(random), place(random), 0.2 * place(random)}});
    }
    auto seen = seen_from(kTruth, survey, 0.001, 12);
    for (std::size_t i = 0; i < 5; ++i) seen[4 * i].position.y() += 0.05 + 0.1 * static_cast<double>(i);
    const auto placement = place_by_markers(survey, seen);
    REQUIRE(placement.is_placed);
    CHECK(placement.used == 15);
    for (std::size_t i = 0; i < 20; ++i) CHECK(placement.residuals[i].is_used == (i % 4 != 0));
}

TEST_CASE("A sigma of zero is refused, a coordinate that is no number leaves its marker out") {
    CHECK_THROWS_AS(place_by_markers(pegs(), pegs(), {0.0, 0.001}), Error);
    auto seen = seen_from(kTruth, pegs(), 0.001, 13);
    seen[5].position.x() = std::numeric_limits<double>::quiet_NaN();
    const auto placement = place_by_markers(pegs(), seen);
    REQUIRE(placement.is_placed);
    CHECK(placement.used == 5);
}
