// SPDX-License-Identifier: MIT
#include "strat/exchange/readers.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/reader_support.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;
using Texts = std::vector<std::string>;

TEST_CASE("StratiGraph's matrix gives units with kind and phase, relations and radiocarbon dates") {
    const auto read = test::read_all(test::sample("hmatrix-json"));
    const ImportedRecord& record = read.values;
    CHECK(test::relation_texts(record) == Texts{"1 covers 2", "2 covers 3", "3 same_as 4", "1 contemporary 4"});
    REQUIRE(record.units.size() == 4);
    CHECK(record.units[0].phase == "Bronze Age");
    CHECK(record.units[0].values.kind == model::UnitKind::Deposit);
    CHECK(record.units[1].values.kind == model::UnitKind::Cut);
    REQUIRE(record.datings.size() == 1);
    CHECK(record.datings[0].values.label == "A-101");
    CHECK(record.datings[0].values.bp == 3275.0);
    CHECK(record.datings[0].values.bp_error == 75.0);
    CHECK(test::count_notes(read.diagnostics, "unknown-target") == 1);
    CHECK(test::count_notes(read.diagnostics, "unknown-relation") == 1);
    CHECK(test::count_notes(read.diagnostics, "unparsed") == 1);
    CHECK(test::count_notes(read.diagnostics, "not-kept") == 1);
}
