// SPDX-License-Identifier: MIT
#include "core/base/error.hpp"
#include "strat/exchange/json_support.hpp"
#include "strat/exchange/readers.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/real_data.hpp"
#include "tests/unit/strat_exchange/matrix_oracle.hpp"
#include "tests/unit/strat_exchange/reader_support.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::input;
using planum::test::read_with;
using planum::test::relation_texts;
using Texts = std::vector<std::string>;

namespace {

const std::string kGraph = R"({"elements":{"nodes":[
 {"data":{"id":"phase-1","class":"phase","label":"Phase 1","dating":{"minYear":"-50","maxYear":"43","minYearTolValue":20,"minYearTolUnit":"years"}}},
 {"data":{"id":"group-1","class":"group","parent":"phase-1","type":"Pit","label":"1"}},
 {"data":{"id":"subgroup-1","class":"subgroup","parent":"group-1","label":"1"}},
 {"data":{"id":"context-1","class":"context","parent":"subgroup-1","type":"Pit: fill","label":"1"}},
 {"data":{"id":"context-2","class":"context","parent":"nowhere","type":"Post hole","label":"2"}},
 {"data":{"id":"context-+","class":"context","label":"+","siteCode":"HILL"}},
 {"data":{"id":"dating-1","class":"dating","parent":"context-1","type":"Coin","label":"99","included":false,"association":"direct","dating":{"minYear":"98","maxYear":117}}},
 {"data":{"id":"x","class":"ufo"}}
],"edges":[
 {"data":{"source":"context-1","target":"context-2","type":"above"}},
 {"data":{"source":"context-2","target":"group-1","type":"above"}},
 {"data":{"source":"context-2","target":"context-1"},"type":"equal"},
 {"data":{"source":"context-2","target":"context-1","type":"beside"}}
]}})";

} // namespace

TEST_CASE("PHASER's graph gives units with phase and group by their nesting, datings and relations") {
    const auto read = read_with(phaser_json_reader(), {input("p.json", kGraph)});
    const ImportedRecord& record = read.values;
    CHECK(record.project_name == "HILL");
    CHECK(relation_texts(record) == Texts{"1 covers 2", "2 same_as 1"});
    REQUIRE(record.units.size() == 3);
    CHECK(record.units[0].phase == "Phase 1");
    CHECK(record.units[0].values.form == model::UnitForm::Fill);
    CHECK(record.units[1].values.kind == model::UnitKind::Cut);
    CHECK(record.units[2].values.title == "top of the sequence");
    REQUIRE(record.phases.size() == 1);
    CHECK(record.phases[0].values.from == -50);
    CHECK(record.phases[0].values.description == "(begin ±20 years)");
    REQUIRE(record.groups.size() == 2);
    CHECK(record.groups[1].values.number == "1 (subgroup-1)");
    CHECK(record.groups[1].parent == "1");
    CHECK(record.groups[1].members.size() == 1);
    REQUIRE(record.datings.size() == 1);
    CHECK(record.datings[0].values.kind == model::DatingKind::Coin);
    CHECK(record.datings[0].values.label == "Coin 99");
    CHECK(record.datings[0].values.to == 117);
    CHECK(record.datings[0].values.notes == "left out in PHASER");
    CHECK(test::count_notes(read.diagnostics, "unparsed") == 1);
    CHECK(test::count_notes(read.diagnostics, "unknown-relation") == 1);
    CHECK(test::count_notes(read.diagnostics, "unknown-target") == 2);
}

TEST_CASE("PHASER's tables are read with any delimiter, nearest container first, in any order") {
    const std::vector<InputFile> files = {
        input("strat.csv",
              "siteCode\tsourceID\tstratRelationship\ttargetID\nH\t1\tabove\t2\nH\t3\tbelow\t2\nH\t1\tbelow\t+\n"),
        input("contexts.csv",
              "siteCode contextID contextType cud description withinPeriod withinPhase withinGroup withinSubgroup\n"
              "H 1 Layer \"\" \"a b\" \"\" \"\" \"\" s1\nH 2 Cut \"\" \"\" \"\" P9 \"\" \"\"\n"),
        input("subgroups.csv",
              "siteCode;subgroupID;subgroupType;cud;description;withinPeriod;withinPhase;withinGroup\nH;s1;;;;;;g1\n"),
        input("groups.csv", "siteCode|groupID|groupType|cud|description|withinPeriod|withinPhase\nH|g1|Pit||||P1\n"),
        input("phases.csv", "siteCode,phaseID,minYear,maxYear,description,withinPeriod\nH,P1,100,-50,old,R\n"),
        input("periods.csv", "periodID,minYear,maxYear,description,uri\nR,-100,400,Roman,\n"),
        input("datings.csv", "siteCode,datingID,datingType,minYear,maxYear,description,withinPeriod,withinContext\nH,"
                             "d1,C14,-40,20,,,1\nH,d2,Pot,1,2,,,\n"),
    };
    CHECK(phaser_csv_reader().recognise(files).files.size() == files.size());
    for (const bool reversed : {false, true}) {
        std::vector<InputFile> given = files;
        if (reversed) std::reverse(given.begin(), given.end());
        const auto read = read_with(phaser_csv_reader(), given);
        const ImportedRecord& record = read.values;
        CHECK(relation_texts(record) == Texts{"1 covers 2", "2 covers 3", "+ covers 1"});
        REQUIRE(record.units.size() == 2);
        CHECK(record.units[0].phase == "P1");
        CHECK(record.units[0].period == "R");
        CHECK(record.units[0].values.description == "a b");
        CHECK(record.units[1].phase == "P9");
        CHECK(record.phases.size() == 2);
        REQUIRE(record.periods.size() == 1);
        CHECK(record.periods[0].title == "Roman");
        REQUIRE(record.datings.size() == 1);
        CHECK(record.datings[0].values.kind == model::DatingKind::Radiocarbon);
        CHECK(test::count_notes(read.diagnostics, "swapped-years") == 1);
        CHECK(test::count_notes(read.diagnostics, "empty-target") == 1);
    }
}

TEST_CASE("PHASER's older single table repeats the context in every row") {
    const auto read = read_with(
        phaser_csv_reader(), {input("old.csv", "siteCode,contextNo,contextType,stratRelationship,relatedContextNo\n"
                                               "H,1,Layer,above,2\nH,1,Layer,below,+\nH,2,Cut,,\nH,2,Cut,above,\n")});
    CHECK(relation_texts(read.values) == Texts{"1 covers 2", "+ covers 1"});
    CHECK(read.values.units.size() == 2);
    CHECK(test::count_notes(read.diagnostics, "empty-target") == 1);
}

TEST_CASE("JSON that is damaged, too deep or of another kind is refused with the file's name") {
    const auto& reader = phaser_json_reader();
    CHECK_THROWS_WITH(read_with(reader, {input("a.json", "{\"elements\":")}),
                      Catch::StartsWith("a.json: not valid JSON at line"));
    CHECK_THROWS_WITH(read_with(reader, {input("a.json", "[1e999]")}), Catch::StartsWith("a.json: "));
    CHECK_THROWS_WITH(read_with(reader, {input("a.json", "[]")}), Catch::StartsWith("a.json: no list elements.nodes"));
    CHECK_THROWS_WITH(read_with(reader, {input("a.json", std::string(5'000'000, '['))}),
                      Catch::Contains("nested more than 100"));
    CHECK_THROWS_WITH(read_with(reader, {input("a.json", "")}), Catch::StartsWith("a.json: "));
    for (std::size_t size = 1; size < kGraph.size(); size += 3) {
        CHECK_THROWS_AS(read_with(reader, {input("a.json", kGraph.substr(0, size))}), Error);
    }
}

TEST_CASE("PHASER's test data is read as counted") {
    const auto file = test::real_data("matrix/phaser/CTD2021-phaser-with-Dating-test-data.json");
    if (!file) return;
    const auto read = read_with(phaser_json_reader(), {load_input_file(*file)});
    CHECK(test::count_matrix(read.values) == test::MatrixCounts{20, 19, 0, 0, 0, 0, 0, 0, 0, 0, 0, 19, 16, 1});
    CHECK(read.values.phases.size() == 6);
    CHECK(read.values.groups.size() == 8);
    CHECK(read.values.datings.size() == 9);
    CHECK(read.diagnostics.empty());
}
