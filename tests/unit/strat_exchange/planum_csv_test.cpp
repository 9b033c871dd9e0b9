// SPDX-License-Identifier: MIT
#include "strat/exchange/planum_csv.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

using Texts = std::vector<std::string>;

const ImportedUnit& unit(const ImportedRecord& record, std::string_view number) {
    const auto it = std::find_if(record.units.begin(), record.units.end(),
                                 [&](const ImportedUnit& u) { return u.name.number == number; });
    REQUIRE(it != record.units.end());
    return *it;
}

} // namespace

TEST_CASE("Our tables are read together in any order and with any delimiter") {
    auto files = test::sample("planum-csv");
    std::reverse(files.begin(), files.end());
    CHECK(test::format_of(files) == "planum-csv");
    const auto read = test::read_all(files);
    const ImportedRecord& record = read.values;
    CHECK(record.units.size() == 4);
    CHECK(unit(record, "12").values.form == model::UnitForm::Fill);
    CHECK(unit(record, "12").values.details.at("munsell") == "10YR 3/2");
    CHECK(unit(record, "12").values.details.at("custom") == "weather=rain");
    CHECK(unit(record, "13").values.kind == model::UnitKind::Cut);
    CHECK(unit(record, "13").values.status == model::UnitStatus::PartlyExcavated);
    CHECK(unit(record, "15").values.details.at("custom") == "kind=thing");
    CHECK(record.groups.size() == 2);
    CHECK(record.phases.size() == 2);
    CHECK(record.periods.size() == 1);
    CHECK(record.finds.size() == 2);
    CHECK(record.finds[0].values.found_on == "2025-06-01");
    CHECK(record.samples.at(0).values.volume == 10.5);
    CHECK(record.datings.at(1).values.kind == model::DatingKind::Coin);
    CHECK(record.levels.size() == 5);
    CHECK(test::relations_of(record) ==
          Texts{"12 fills 13", "13 cuts 14", "12 covers 14", "13 covers 14", "13 same_as 13a ?", "15 covers 16 ?"});
    CHECK(record.relations[0].person == "Anna");
    CHECK(record.relations[2].side == model::StatementSide::Object);
    auto notes = test::notes_of(read.diagnostics);
    std::sort(notes.begin(), notes.end());
    CHECK(notes == Texts{"finds.csv:3 unparsed", "finds.csv:3 unparsed", "levels.csv:4 unparsed",
                         "relations.csv:6 unknown-relation", "units.csv:1 unknown-column", "units.csv:5 unknown-status",
                         "units.csv:5 unknown-type", "units.csv:5 unparsed"});
}

TEST_CASE("Long names that differ only at their ends are different units") {
    const std::string a(300, 'a');
    const std::string b = std::string(250, 'a') + "b";
    const auto read = test::read_all({{"r.csv", "unit,relation,other\n1,covers," + a + "\n2,covers," + b + "\n"}});
    CHECK(test::relations_of(read.values) == Texts{"1 covers " + a, "2 covers " + b});
    CHECK(read.diagnostics.empty());
}

TEST_CASE("A unit whose number has a comma is one unit, an unknown text with a comma is a list") {
    const auto read = test::read_all({{"r.csv", "unit,relation,other\n1,covers,\"2, 3\"\n1,covers,\"4, 5\"\n"},
                                      {"u.csv", "unit,title\n1,a\n\"4, 5\",b\n"}});
    CHECK(test::relations_of(read.values) == Texts{"1 covers 2", "1 covers 3", "1 covers 4, 5"});
}

TEST_CASE("A number without its area belongs to the area of the unit beside it") {
    const auto read = test::read_all({{"r.csv", "unit,area,relation,other,other_area\n1,A,covers,2,\n1,A,covers,3,B\n"
                                                "C::4,,covers,5,\n"}});
    CHECK(test::relations_of(read.values) == Texts{"A::1 covers A::2", "A::1 covers B::3", "C::4 covers C::5"});
}

TEST_CASE("Relation words of four languages are understood") {
    const auto read =
        test::read_all({{"r.csv", "unit,relation,other\n1,liegt unter,2\n1,Taglia,3\n1,sous,4\n1,after,5\n"}});
    CHECK(test::relations_of(read.values) == Texts{"2 covers 1", "1 cuts 3", "4 covers 1", "1 later 5"});
}

TEST_CASE("Dates in the ways of the four countries") {
    CHECK(iso_date("2025-06-01") == "2025-06-01");
    CHECK(iso_date("1.6.2025") == "2025-06-01");
    CHECK(iso_date("01/06/2025") == "2025-06-01");
    CHECK_FALSE(iso_date("31.13.2025"));
    CHECK_FALSE(iso_date("June"));
}
