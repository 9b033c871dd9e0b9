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
