// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/unit/strat_exchange/support.hpp"

using namespace planum;
using namespace planum::strat;

namespace {

using Texts = std::vector<std::string>;

} // namespace

TEST_CASE("hm tables: the ini says which file is which and whether it has a header") {
    auto files = test::sample("hm");
    std::reverse(files.begin(), files.end()); // in any order
    CHECK(test::format_of(files) == "hm");
    const auto read = test::read_all(files);
    const ImportedRecord& record = read.values;
    REQUIRE(record.units.size() == 3);
    CHECK(record.units[0].values.details.at("position") == "surface");
    CHECK(record.units[1].values.kind == model::UnitKind::Interface);
    CHECK(record.units[1].values.details.at("custom") == "url=[[img/2.png]]");
    CHECK(record.units[0].phase == "1");
    CHECK(record.units[0].period == "2");
    auto relations = test::relations_of(record);
    std::sort(relations.begin(), relations.end());
    CHECK(relations == Texts{"1 covers 2", "2 covers 3", "2 same_as 2b"});
    REQUIRE(record.periods.size() == 2);
    CHECK(record.periods[0].title == "Period 1");
    CHECK(record.periods[0].description == "early");
    CHECK(record.phases.size() == 1);
    REQUIRE(record.datings.size() == 2);
    CHECK(record.datings[0].values.label == "LAB-1");
    CHECK(record.datings[0].values.association == "direct");
    CHECK(record.datings[0].values.notes == "later than LAB-2 of 3");
    CHECK(record.datings[1].values.kind == model::DatingKind::AnteQuem);
    auto notes = test::notes_of(read.diagnostics);
    std::sort(notes.begin(), notes.end());
    CHECK(notes == Texts{"contexts.csv:4 unknown-type", "date-order.csv:2 kept-as-text",
                         "date-order.csv:3 empty-target", "periods.csv:0 not-kept", "phases.csv:0 not-kept",
                         "radiocarbon.csv:0 repeated", "radiocarbon.csv:4 rejected-dating"});
}

TEST_CASE("hm observations alone are read") {
    const auto read = test::read_all({{"obs.csv", "younger,older,url\n1,2,\n2,,\n"}});
    CHECK(test::relations_of(read.values) == Texts{"1 covers 2"});
    CHECK(read.values.units.empty());
    CHECK(test::notes_of(read.diagnostics) == Texts{"obs.csv:3 empty-target"});
}

TEST_CASE("hm tables: a data package names the tables, which then need neither headings nor telling names") {
    const auto read = test::read_all({{"a.csv", "1,deposit,other,,,\n"},
                                      {"b.csv", "1,2,\n"},
                                      {"datapackage.json", R"({"resources": [{"name": "contexts", "path": "data/a.csv"},
                                                {"name": "observations", "path": "data/b.csv"}]})"}});
    CHECK(read.values.units.size() == 1);
    CHECK(test::relations_of(read.values) == Texts{"1 covers 2"});
    CHECK(read.diagnostics.empty());
}

TEST_CASE("ArkMatrix tagged: the last field is the tag, commas in between belong to the value") {
    const auto read = test::read_all(test::sample("arkmatrix/tagged.csv"));
    const ImportedRecord& record = read.values;
    CHECK(record.project_name == "HILL12");
    REQUIRE(record.units.size() == 2);
    CHECK(record.units[0].values.form == model::UnitForm::Fill);
    CHECK(record.units[0].values.description == "brown, sandy, loose");
    CHECK(record.units[1].values.status == model::UnitStatus::Void);
    CHECK(test::relations_of(record) == Texts{"1 covers 2", "2 covers 3", "5 same_as 6", "3 contemporary 4"});
    REQUIRE(record.groups.size() == 2);
    CHECK(record.groups[0].values.number == "S1");
    CHECK(record.groups[0].parent == "1");
    CHECK(record.groups[0].members == std::vector<UnitName>{{"", "1"}});
    CHECK(record.groups[1].values.type == "group");
    CHECK(test::notes_of(read.diagnostics) == Texts{"tagged.csv:12 unknown-tag"});
}

TEST_CASE("ArkMatrix simple: an empty first cell goes on from the second cell above") {
    const auto read = test::read_all(test::sample("arkmatrix/simple.csv"));
    CHECK(test::relations_of(read.values) == Texts{"1 covers 2", "2 covers 3", "5 covers 6"});
    REQUIRE(read.values.units.size() == 1);
    CHECK(read.values.units[0].name.number == "8");
}

TEST_CASE("Excavation books: verbs, numbers unique per book, heights in centimetres") {
    const auto read = test::read_all(test::sample("urkesh/books.csv"));
    const ImportedRecord& record = read.values;
    REQUIRE(record.units.size() == 3);
    CHECK(record.units[0].name == UnitName{"A1", "f2"});
    CHECK(record.units[0].phase == "s1");
    CHECK(record.units[1].values.kind == model::UnitKind::Cut);
    CHECK(record.units[2].values.form == model::UnitForm::Masonry);
    CHECK(test::relations_of(record) == Texts{"A1::f1 covers A1::f2", "A1::f2 covers A1::f3", "A1::f2 same_as A1::f7",
                                              "A1::f2 same_as B1::f9", "A1::f6 fills A1::f5", "A1::f5 cuts A1::f2",
                                              "B1::f9 abuts B1::f8"});
    CHECK(record.relations[0].side == model::StatementSide::Object);
    REQUIRE(record.levels.size() == 2);
    CHECK(record.levels[0].values.z == Approx(92.11));
    CHECK(record.levels[1].values.role == model::LevelRole::Base);
    CHECK(test::notes_of(read.diagnostics) == Texts{"books.csv:2 conflicting-value", "books.csv:2 unknown-relation",
                                                    "books.csv:3 unparsed", "books.csv:3 unparsed"});
}
