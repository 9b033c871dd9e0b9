// SPDX-License-Identifier: MIT
#include "tests/support/catch.hpp"
#include "tests/support/registered_dig.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

TEST_CASE("Every scan of a simulated dig is placed, by the markers of the first alone") {
    constexpr model::DigMethod kMethods[] = {model::DigMethod::Stratigraphic, model::DigMethod::Planum,
                                             model::DigMethod::Mixed};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const test::TemporaryFolder folder;
        app::demo::SimulationOptions options;
        options.seed = seed;
        options.method = kMethods[(seed - 1) % 3];
        const auto dig = test::register_dig(folder / "dig", options);
        INFO("seed " << seed);
        CHECK(dig.report.state == "accepted");
        CHECK(dig.placed == dig.scans);
        CHECK(test::largest_of(dig.relative) < 0.001);
        CHECK(test::median_of(dig.relative) < 0.0003);
        CHECK(test::largest_of(dig.absolute) < 0.003);
        for (const double chi : dig.link_chi) CHECK(chi < 40.0); // 1 - 4e-7 of χ² with six numbers
    }
}
