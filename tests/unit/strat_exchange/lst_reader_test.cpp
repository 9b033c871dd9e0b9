// SPDX-License-Identifier: MIT
#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;

TEST_CASE("A .lst dataset: below lists what the unit covers, from both sides") {
    const auto read = test::read_all(test::sample("lst/basp.lst"));
    CHECK(read.values.project_name == "MYDIG");
    REQUIRE(read.values.units.size() == 3);
    CHECK(read.values.units[0].values.title == "Floor of the küche");
    CHECK(read.values.units[2].name.number == "+");
    CHECK(test::relations_of(read.values) == std::vector<std::string>{"11 covers 12", "12 same_as 12a", "12 covers 13",
                                                                      "12 covers 14", "11 covers 12", "+ covers 11"});
    CHECK(read.values.relations[0].side == model::StatementSide::Object);
    CHECK(read.values.relations[0].line == 5);
    CHECK(read.values.relations[0].file == "basp.lst");
    CHECK(read.values.relations[4].side == model::StatementSide::Subject);
    CHECK(read.diagnostics.empty());
}

TEST_CASE("Stratify's .lst: sites as areas, groups are no units, unknown keys are reported") {
    const auto read = test::read_all(test::sample("lst/stratify.lst"));
    REQUIRE(read.values.units.size() == 1);
    CHECK(read.values.units[0].name == UnitName{"TST", "1"});
    CHECK(test::relations_of(read.values) == std::vector<std::string>{"TST::1 covers TST::2"});
    REQUIRE(read.values.groups.size() == 1);
    CHECK(read.values.groups[0].values.number == "TST::House");
    CHECK(read.values.groups[0].values.title == "A house");
    CHECK(read.values.groups[0].members == std::vector<UnitName>{{"TST", "1"}});
    CHECK(test::notes_of(read.diagnostics) == std::vector<std::string>{"stratify.lst:10 unknown-key"});
}
