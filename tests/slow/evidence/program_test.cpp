// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "core/model/place.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/evidence_dig.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

// What the in-memory test next door measures on the true ground, here through files, scans and registration.

TEST_CASE("From the files of a dig nothing is proposed the wrong way round, and no true record is contradicted") {
    for (const auto method : {model::DigMethod::Stratigraphic, model::DigMethod::Planum, model::DigMethod::Mixed}) {
        test::EvidenceTally all;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const test::TemporaryFolder folder;
            app::demo::SimulationOptions options;
            options.seed = seed;
            options.method = method;
            const auto dig = test::evidence_of_dig(folder / "dig", options, app::RegisterMethod::Markers,
                                                   {std::getenv("PLANUM_LOUD") != nullptr, false});
            INFO("seed " << seed << ", " << model::to_word(method));
            CHECK(dig.placed == dig.scans);
            CHECK(dig.tally.inverted == 0);
            CHECK(dig.tally.relations > 0);
            for (const std::string& message : dig.false_contradictions) FAIL_CHECK(message);
            all += dig.tally;
        }
        all.print("files, " + std::string(model::to_word(method)));
        CHECK(all.contact_share() >= 0.9);
        CHECK(all.recall() >= 0.7); // two set-ups at the rim do not see all of a pit
    }
}
