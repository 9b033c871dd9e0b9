// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>
#include <vector>

#include "core/model/place.hpp"
#include "scans/surface/questions.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/evidence_tally.hpp"

// What is proposed from surfaces and outlines, against the truth of thirty digs. PLANUM_LOUD=1 names what is wrong.

using namespace planum;
using namespace planum::test;

namespace {

EvidenceTally tally_digs(model::DigMethod method, int first, int last, const GroundNoise& noise = {},
                         bool kinds_are_known = true) {
    EvidenceTally all;
    for (int seed = first; seed <= last; ++seed) {
        const auto dig = demo_dig(static_cast<std::uint64_t>(seed), method);
        std::vector<scans::KnownUnit> units = known_units(dig);
        for (scans::KnownUnit& unit : units) {
            if (kinds_are_known || unit.kind == model::UnitKind::Cut) continue;
            unit.kind = model::UnitKind::Unknown;
            unit.form = model::UnitForm::None;
        }
        auto conclusions = scans::conclude(history_of(dig, noise), units);
        scans::keep_useful_questions(conclusions, units.size());
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

// As `region import --create-units` makes them from outlines alone.
TEST_CASE("Of units of which only cuts are known as such nothing is proposed the wrong way round") {
    for (const auto method : {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed}) {
        const EvidenceTally t = tally_digs(method, 1, 10, {}, false);
        t.print("kinds unknown, " + std::string(model::to_word(method)));
        CHECK(t.inverted == 0);
        CHECK(t.contact_share() >= 0.9);
        // On levels the rules go by what units are.
        if (method == model::DigMethod::Stratigraphic) CHECK(t.recall() >= 0.8);
    }
}
