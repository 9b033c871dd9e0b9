// SPDX-License-Identifier: MIT
#include "scans/surface/questions.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/support/catch.hpp"

using namespace planum;
using scans::Conclusion;
using scans::Ground;

namespace {

Conclusion proposal(scans::UnitNumber later, scans::UnitNumber earlier,
                    model::EvidenceSource source = model::EvidenceSource::Levels) {
    Conclusion c;
    c.unit = later;
    c.other = earlier;
    c.source = source;
    return c;
}

Conclusion question(scans::UnitNumber first, scans::UnitNumber then, double area,
                    Ground ground = Ground::OnlyAlongOutlines,
                    model::EvidenceSource source = model::EvidenceSource::Levels) {
    Conclusion c = proposal(first, then, source);
    c.is_question = true;
    c.area = area;
    c.ground = ground;
    return c;
}

std::vector<std::pair<int, int>> asked(const std::vector<Conclusion>& all) {
    std::vector<std::pair<int, int>> pairs;
    for (const Conclusion& c : all) {
        if (c.is_question) pairs.emplace_back(c.unit, c.other);
    }
    return pairs;
}

} // namespace

TEST_CASE("What the proposals imply is not asked, in either direction") {
    std::vector<Conclusion> all = {proposal(0, 1), proposal(1, 2), question(0, 2, 1.0), question(2, 0, 1.0),
                                   question(0, 3, 1.0)};
    scans::keep_useful_questions(all, 4);
    CHECK(asked(all) == std::vector<std::pair<int, int>>{{0, 3}});
    CHECK(all.size() == 3);
}

TEST_CASE("What the record answers takes no room from other questions") {
    std::vector<Conclusion> all = {proposal(0, 1, model::EvidenceSource::Levels), question(2, 3, 1.0),
                                   question(4, 1, 0.5), question(5, 4, 0.2)};
    const std::vector<scans::KnownOrder> recorded = {{3, 2}, {4, 0}}; // the second answers 4, 1 with the proposal
    scans::keep_useful_questions(all, 6, recorded);
    CHECK(asked(all) == std::vector<std::pair<int, int>>{{5, 4}});
}

TEST_CASE("Where only some may be asked, those that settle most orders come first") {
    // 0 over 1 over 2 and 3 over 4: asking 2, 3 settles six pairs, 5, 6 settles one.
    std::vector<Conclusion> all = {proposal(0, 1, model::EvidenceSource::StratigraphicSurfaces),
                                   proposal(1, 2, model::EvidenceSource::StratigraphicSurfaces),
                                   proposal(3, 4, model::EvidenceSource::StratigraphicSurfaces)};
    for (int i = 7; i < 14; ++i) all.push_back(proposal(i, i + 1, model::EvidenceSource::StratigraphicSurfaces));
    const auto surfaces = model::EvidenceSource::StratigraphicSurfaces;
    all.push_back(question(5, 6, 9.0, Ground::OnlyAlongOutlines, surfaces));
    all.push_back(question(2, 3, 0.1, Ground::OnlyAlongOutlines, surfaces));
    all.push_back(question(5, 15, 8.0, Ground::OnlyAlongOutlines, surfaces));
    scans::keep_useful_questions(all, 16);
    const auto pairs = asked(all);
    REQUIRE(pairs.size() == 2); // ten proposals
    CHECK(std::find(pairs.begin(), pairs.end(), std::pair<int, int>{2, 3}) != pairs.end());
}

TEST_CASE("Of questions that settle as much, the likelier contact comes first, then the smaller one") {
    std::vector<Conclusion> all;
    for (int i = 0; i < 8; ++i) {
        all.push_back(proposal(20 + 2 * i, 21 + 2 * i));
        all.push_back(question(40 + 2 * i, 41 + 2 * i, 0.01, Ground::RoofOfHollow));
    }
    all.push_back(question(2, 3, 0.5));
    all.push_back(question(4, 5, 0.1));
    scans::keep_useful_questions(all, 60);
    const auto pairs = asked(all);
    REQUIRE(pairs.size() == 8);
    CHECK(pairs[6] == std::pair<int, int>{2, 3});
    CHECK(pairs[7] == std::pair<int, int>{4, 5});

    std::vector<Conclusion> as_likely(all.begin(), all.begin() + 1);
    for (int i = 0; i < 7; ++i) as_likely.push_back(proposal(20 + 2 * i, 21 + 2 * i));
    for (int i = 0; i < 9; ++i) as_likely.push_back(question(40 + 2 * i, 41 + 2 * i, 1.0 - 0.1 * i));
    scans::keep_useful_questions(as_likely, 60);
    CHECK(asked(as_likely).front() == std::pair<int, int>{42, 43}); // the largest of nine is left out
}

TEST_CASE("Few proposals leave room for the largest contacts") {
    std::vector<Conclusion> all = {proposal(0, 1), proposal(1, 2), question(2, 3, 0.1), question(4, 5, 0.5),
                                   question(6, 7, 0.7, Ground::RoofOfHollow)};
    scans::keep_useful_questions(all, 8);
    CHECK(asked(all) == std::vector<std::pair<int, int>>{{4, 5}, {6, 7}});
}

TEST_CASE("No proposals, no questions; nothing at all is fine") {
    std::vector<Conclusion> all = {question(0, 1, 1.0)};
    scans::keep_useful_questions(all, 2);
    CHECK(all.empty());
    scans::keep_useful_questions(all, 0);
    CHECK(all.empty());
}
