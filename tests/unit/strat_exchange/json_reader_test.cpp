// SPDX-License-Identifier: MIT
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;
using Catch::Matchers::Contains;

namespace {

using Texts = std::vector<std::string>;

std::string failure(std::string_view json) {
    try {
        (void)test::read_all({test::a_file("r.json", json)}, "json");
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("A record in JSON: units by name, statements one by one, what is not understood is reported") {
    const auto read = test::read_all(test::sample("json/small.json"));
    const ImportedRecord& record = read.values;
    CHECK(record.project_name == "Mill");
    REQUIRE(record.units.size() == 1);
    CHECK(record.units[0].name == UnitName{"A", "12"});
    CHECK(record.units[0].values.form == model::UnitForm::Fill);
    CHECK(record.units[0].values.details.at("colour") == "red");
    CHECK(record.units[0].values.details.at("custom") == "weather=rain");
    CHECK(record.areas.at(0).method == model::DigMethod::Planum);
    CHECK(record.phases.at(0).values.from == -3300);
    CHECK(record.periods.at(0).number == "EBA");
    CHECK(record.groups.at(0).members == std::vector<UnitName>{{"A", "12"}, {"A", "13"}});
    CHECK(test::relations_of(record) == Texts{"A::12 fills A::13 ?", "A::12 fills A::13 ?", "A::12 same_as A::15"});
    CHECK(record.relations[0].side == model::StatementSide::Object);
    CHECK(record.relations[0].person == "Anna");
    CHECK(record.relations[2].correlation);
    CHECK(record.levels.size() == 1);
    Texts notes;
    for (const ReadNote& note : read.diagnostics) notes.push_back(note.raw_text + " " + note.code);
    CHECK(notes == Texts{"units[2] unparsed", "phases[0] unparsed", "units[0] unparsed", "units[0] unknown-column",
                         "units[2] unparsed", "relations[1] unknown-relation", "levels[1] unparsed", "finds unparsed"});
}

TEST_CASE("JSON of a later version is refused with both versions") {
    CHECK_THAT(failure(R"({"format": "planum-record", "version": 2})"),
               Contains("r.json: record version 2, this program knows up to 1"));
    CHECK_THAT(failure(R"({"format": "other"})"), Contains("r.json: no record of ours"));
    CHECK_THAT(failure("{\"format\": \"planum-record\", "), Contains("r.json: not valid JSON at line"));
}

TEST_CASE("What is no JSON is refused with the place and what to do") {
    CHECK_THAT(failure(""), Contains("r.json: the file is empty"));
    CHECK_THAT(failure(" \n"), Contains("r.json: the file is empty"));
    CHECK_THAT(failure("{\"a\": 1,\nx}"), Contains("not valid JSON at line 2, column 1"));
    CHECK_THAT(failure("{\"ä\": NaN}"), Contains("line 1, column 7: JSON has no number NaN"));
    CHECK_THAT(failure("{\"a\":\n -Infinity}"), Contains("line 2, column 3: JSON has no number Infinity"));
    CHECK_THAT(failure("{\"a\": 1,\n\"b\": 1e999}"), Contains("line 2, column 6: the number 1e999 is too large"));
}
