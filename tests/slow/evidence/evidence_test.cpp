// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "core/model/place.hpp"
#include "scans/surface/questions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/evidence_tally.hpp"

// What is proposed from surfaces and outlines, against the truth of thirty digs. PLANUM_LOUD=1 names what is wrong.

using namespace planum;
using namespace planum::test;

namespace {

EvidenceTally tally_digs(model::DigMethod method, int first, int last, const GroundNoise& noise = {}) {
    EvidenceTally all;
    for (int seed = first; seed <= last; ++seed) {
        const auto dig = demo_dig(static_cast<std::uint64_t>(seed), method);
        auto conclusions = scans::conclude(history_of(dig, noise), known_units(dig));
        scans::keep_useful_questions(conclusions, known_units(dig).size());
        all += tally_of(dig, conclusions, std::getenv("PLANUM_LOUD") != nullptr);
    }
    return all;
}

} // namespace

TEST_CASE("On stratigraphic surfaces nothing is proposed the wrong way round, and little is missed") {
    const EvidenceTally t = tally_digs(model::DigMethod::Stratigraphic, 1, 10);
    t.print("stratigraphic");
    CHECK(t.inverted == 0);
    CHECK(t.contact_share() >= 0.9);
    CHECK(t.recall() >= 0.95);
    CHECK(t.questions_per_relation() <= 0.2);
}

TEST_CASE("On artificial levels nothing is proposed the wrong way round either") {
    for (const auto method : {model::DigMethod::Planum, model::DigMethod::Mixed}) {
        const EvidenceTally t = tally_digs(method, 1, 10);
        t.print(std::string(model::to_word(method)));
        CHECK(t.inverted == 0);
        CHECK(t.contact_share() >= 0.9);
        CHECK(t.recall() >= 0.7);
        CHECK(t.questions_per_relation() <= 1.0);
    }
}

TEST_CASE("With outlines of every day displaced by a further 3 cm nothing is inverted, and most is still found") {
    GroundNoise noise;
    noise.outline_shift = 0.03;
    for (const auto method : {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed}) {
        const EvidenceTally t = tally_digs(method, 1, 10, noise);
        t.print("displaced, " + std::string(model::to_word(method)));
        CHECK(t.inverted == 0);
        CHECK(t.contact_share() >= 0.9);
        CHECK(t.recall() >= 0.7);
    }
}
