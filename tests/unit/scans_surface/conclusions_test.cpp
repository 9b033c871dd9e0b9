// SPDX-License-Identifier: MIT
#include "scans/surface/conclusions.hpp"

#include <cstdlib>

#include "scans/surface/questions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/evidence_tally.hpp"

// Small digs against their truth; thirty medium ones stand in tests/slow/evidence.

using namespace planum;
using namespace planum::test;

TEST_CASE("Small digs: nothing is proposed the wrong way round, whatever the method") {
    for (const auto method : {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed}) {
        for (const std::uint64_t seed : {1U, 2U}) {
            INFO(model::to_word(method) << " " << seed);
            const auto dig = demo_dig(seed, method, app::demo::DemoSize::Small);
            auto conclusions = scans::conclude(history_of(dig), known_units(dig));
            scans::keep_useful_questions(conclusions, known_units(dig).size());
            const EvidenceTally t = tally_of(dig, conclusions, std::getenv("PLANUM_LOUD") != nullptr);
            CHECK(t.inverted == 0);
            CHECK(t.relations > 0);
            CHECK(t.recall() >= 0.7);
        }
    }
}

namespace {

// On one surface after the other: 2 m² of unit 0 went, of which so many cells came off the cut 1, the rest off 2.
std::vector<scans::Conclusion> taken_off_cut(std::int64_t off_cut, std::int64_t bare_before) {
    constexpr std::int64_t kAll = 5000;
    scans::AreaHistory history;
    history.methods = {model::DigMethod::Stratigraphic, model::DigMethod::Stratigraphic};
    scans::SurfaceSummary upper;
    upper.showings = {{0, kAll, 0, 0, 0, 10.0, 6.0, 0.0}};
    if (bare_before > 0) upper.showings.push_back({1, bare_before, 0, bare_before, 0, 9.7, 2.0, 0.0});
    scans::SurfaceSummary lower;
    lower.showings = {{1, off_cut, 0, off_cut, 0, 9.7, 6.0, 0.0}};
    scans::SurfaceStep step;
    const auto add = [&](scans::UnitNumber then, std::int64_t cells) {
        if (cells == 0) return;
        scans::Succession s;
        s.first = 0;
        s.then = then;
        s.cells = s.lower = cells;
        s.drop = 0.3;
        s.tolerance = 0.02;
        step.successions.push_back(s);
    };
    add(1, off_cut);
    add(2, kAll - off_cut);
    history.summaries = {upper, lower};
    history.steps = {step};
    history.hides_somewhere = {false};
    return scans::conclude(history,
                           std::vector<scans::KnownUnit>{{{}, model::UnitKind::Unknown, model::UnitForm::None},
                                                         {{}, model::UnitKind::Cut, model::UnitForm::None},
                                                         {{}, model::UnitKind::Unknown, model::UnitForm::None}});
}

} // namespace

TEST_CASE("What nearly all lay in a cut is later than it whatever it is; what went on beside it may be its roof") {
    const auto inside = taken_off_cut(5000, 0);
    REQUIRE(inside.size() == 1);
    CHECK_FALSE(inside[0].is_question);
    CHECK(inside[0].kind == model::RelationKind::Later);
    CHECK((inside[0].unit == 0 && inside[0].other == 1));
    const auto about_cut = [](const std::vector<scans::Conclusion>& all) {
        for (const scans::Conclusion& c : all) {
            if (c.other == 1) return c.is_question;
        }
        return false;
    };
    CHECK(about_cut(taken_off_cut(2500, 0)));   // half of it lay beside
    CHECK(about_cut(taken_off_cut(5000, 600))); // the cut was emptied first
}

namespace {

// On levels, layer 1 lay bare inside layer 0; then it came out under 27 m² of it, of which so many cells are left.
std::vector<scans::Conclusion> spot_that_grew(std::int64_t left) {
    scans::AreaHistory history;
    history.methods = {model::DigMethod::Planum, model::DigMethod::Planum};
    scans::SurfaceSummary upper;
    upper.showings = {{0, 70000, 70000, 0, 0, 10.0, 24.0, 12.0}, {1, 600, 600, 0, 0, 9.99, 2.0, 0.0}};
    upper.edges = {{0, 1, 2.0}}; // the rest of 0 lies against units that stay
    scans::SurfaceSummary lower;
    if (left > 0) lower.showings.push_back({0, left, left, 0, 0, 9.8, 8.0, 6.0});
    lower.showings.push_back({1, 70600 - left, 70600 - left, 0, 0, 9.78, 22.0, 22.0});
    history.summaries = {upper, lower};
    scans::SurfaceStep step;
    scans::Succession grown;
    grown.first = 0;
    grown.then = 1;
    grown.cells = grown.lower = grown.level = 70000 - left;
    grown.drop = 0.22;
    grown.tolerance = 0.02;
    step.successions = {grown};
    step.edges = {{0, 1, 2.0, 1.8, 1.8, 0.0, 0.22}};
    history.steps = {step};
    history.hides_somewhere = {false};
    const scans::KnownUnit layer{{}, model::UnitKind::Deposit, model::UnitForm::Layer};
    return scans::conclude(history, std::vector{layer, layer});
}

} // namespace

TEST_CASE("On levels a layer that came out inside another is covered by it once nothing of the other is left") {
    const auto whole = spot_that_grew(0);
    REQUIRE(whole.size() == 1);
    CHECK_FALSE(whole[0].is_question);
    CHECK(whole[0].unit == 0);
    CHECK(whole[0].kind == model::RelationKind::Covers);
}

TEST_CASE("On levels a spot that grows inside what is still there may be a pit that was undercut, and is asked") {
    const auto part = spot_that_grew(30000);
    REQUIRE(part.size() == 1);
    CHECK(part[0].is_question);
}
