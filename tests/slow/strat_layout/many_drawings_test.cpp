// SPDX-License-Identifier: MIT
#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;

TEST_CASE("Ten thousand random matrices, drawn and read back, are their reduced matrices") {
    for (std::uint32_t seed = 1; seed <= 10'000; ++seed) {
        test::RandomMatrixOptions options;
        options.seed = seed;
        options.units = 2 + seed % 60;
        options.relations = options.units * (1 + seed % 5);
        options.cycles = seed % 3 == 0;
        options.contemporaries = seed % 5 == 0;
        options.same_as = seed % 7 == 0;
        options.uncertain = seed % 4 == 0;
        options.phases = seed % 11 == 0 ? 5 : 0;
        const model::Record record = test::a_random_record(options);
        INFO("seed " << seed);
        REQUIRE(test::broken_law(record, test::drawing_of(record)) == "");
    }
}

TEST_CASE("Large trenches, drawn and read back, are their reduced matrices") {
    for (const std::size_t units : {700U, 2000U, 4000U}) {
        const model::Record record =
            test::a_trench({.units = units, .seed = 11, .width = units / 10, .layer_reach = 8});
        INFO(units << " units");
        REQUIRE(test::broken_law(record, test::drawing_of(record)) == "");
    }
}
