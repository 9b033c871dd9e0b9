// SPDX-License-Identifier: MIT

// stratigraphr, Stratify and PolyChron: tables with a header of their own.

#include "core/base/error.hpp"
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

TEST_CASE("stratigraphr's lists are read from the unit of the row, NA as nothing") {
    const auto read =
        read_with(stratigraphr_reader(), {input("s.csv", "context,type,above,below,equal,phase,structure,note\n"
                                                         "1,Deposit,NA,\"2,3\",NA,I,,loose\n"
                                                         "2,Structural,1,,3,II,Wall A,\n"
                                                         "3,Cut,1,nat,,II,Wall A,NA\n")});
    CHECK(relation_texts(read.values) ==
          Texts{"1 covers 2", "1 covers 3", "1 covers 2", "2 same_as 3", "1 covers 3", "3 covers nat"});
    CHECK(read.values.relations[2].side == model::StatementSide::Object);
    REQUIRE(read.values.units.size() == 3);
    CHECK(read.values.units[0].phase == "I");
    CHECK(read.values.units[0].values.details.at("custom") == "note=loose");
    CHECK(read.values.units[1].values.kind == model::UnitKind::Structure);
    CHECK(read.values.units[2].values.kind == model::UnitKind::Cut);
    REQUIRE(read.values.groups.size() == 1);
    CHECK(read.values.groups[0].members.size() == 2);
    CHECK(read.values.phases.size() == 2);
    CHECK(read.diagnostics.empty());
}

TEST_CASE("Stratify's table knows groups, parts and a first row that is no unit") {
    const auto read = read_with(stratify_csv_reader(),
                                {input("s.csv", "Unitname;Unitclass;Earlier than;Later than;Equal to;Contemporary "
                                                "with;Part of;Location;Conditions;Unittype;Period;Phase;\n"
                                                "DUMMY;context;;;;;;;;;;;\n"
                                                "T\xFC"
                                                "r;context;;2, 3;;;House;north;dry;Mauer;Roman;2;\n"
                                                "2;context;T\xFC"
                                                "r;;4;3;;;;Grube;;;\n"
                                                "House;group;9;;;;Town;;;;;;\n")});
    CHECK(relation_texts(read.values) ==
          Texts{"Tür later 2", "Tür later 3", "Tür later 2", "2 same_as 4", "2 contemporary 3"});
    REQUIRE(read.values.units.size() == 2);
    CHECK(read.values.units[0].name.number == "Tür");
    CHECK(read.values.units[0].period == "Roman");
    CHECK(read.values.units[0].values.form == model::UnitForm::Masonry);
    CHECK(read.values.units[0].values.details.at("conditions") == "dry");
    CHECK(read.values.units[1].values.kind == model::UnitKind::Cut);
    REQUIRE(read.values.groups.size() == 1);
    CHECK(read.values.groups[0].parent == "Town");
    CHECK(read.values.groups[0].members == std::vector<UnitName>{{"", "Tür"}});
    REQUIRE(test::count_notes(read.diagnostics, "group-relation") == 1);
}

TEST_CASE("PolyChron's five tables are read together in any order") {
    const std::vector<InputFile> files = {
        input("equal.csv", "context_1,context_2\nc,d\n"),
        input("order2.csv", "above,below\nII,I\n"),
        input("dates.csv", "context,date,error\na,3400,80\nb,x,1\n"),
        input("strat.csv", "above,below\na,b\nb,c\nlonely,\n"),
        input("sets.csv", "context,Group\na,II\nb,I\nc,I\n"),
        input("more.csv", "above,below,relationship\nIII,II,gap\n"),
    };
    CHECK(polychron_reader().recognise(files).files.size() == 6);
    CHECK(polychron_reader().recognise(files).confidence == Confidence::Certain);
    for (const bool reversed : {false, true}) {
        std::vector<InputFile> given = files;
        if (reversed) std::reverse(given.begin(), given.end());
        const auto read = read_with(polychron_reader(), given);
        CHECK(test::count_matrix(read.values).orders == 2);
        CHECK(test::count_matrix(read.values).same_as == 1);
        CHECK(test::count_matrix(read.values).units == 5);
        REQUIRE(read.values.datings.size() == 1);
        CHECK(read.values.datings[0].values.bp == 3400.0);
        CHECK(read.values.datings[0].values.bp_error == 80.0);
        REQUIRE(read.values.phases.size() == 3);
        for (const ImportedPhase& phase : read.values.phases) {
            CHECK(phase.values.rank == static_cast<std::int64_t>(phase.values.number.size()));
        }
        CHECK(test::count_notes(read.diagnostics, "unparsed") == 1);
    }
}

TEST_CASE("A circle among PolyChron's groups leaves them without ranks and is said") {
    const auto read = read_with(polychron_reader(), {input("g.csv", "above,below,relationship\n1,2,gap\n2,1,\n")});
    CHECK(test::count_notes(read.diagnostics, "group-cycle") == 1);
    for (const ImportedPhase& phase : read.values.phases) CHECK_FALSE(phase.values.rank);
}

TEST_CASE("Tables with other columns are refused by name and with the columns looked for") {
    for (const Reader* reader :
         {&stratigraphr_reader(), &stratify_csv_reader(), &polychron_reader(), &phaser_csv_reader()}) {
        INFO(reader->format);
        CHECK_THROWS_WITH(read_with(*reader, {input("x.csv", "a,b\n1,2\n")}),
                          Catch::StartsWith("x.csv: the first line"));
        CHECK_THROWS_WITH(read_with(*reader, {input("x.csv", "")}), Catch::StartsWith("x.csv: "));
        CHECK_THROWS_WITH(read_with(*reader, {input("x.csv", std::string("\0\1\2\3", 4))}),
                          Catch::StartsWith("x.csv: "));
        const InputFile other = input("x.csv", "a,b\n1,2\n");
        CHECK(reader->recognise(std::span(&other, 1)).confidence == Confidence::No);
    }
}

TEST_CASE("Shubayqa 1 and Harris's figure 12 are read as counted") {
    if (const auto file = test::real_data("matrix/stratigraphr/shub1.csv")) {
        const auto read = read_with(stratigraphr_reader(), {load_input_file(*file)});
        CHECK(test::count_matrix(read.values) == test::MatrixCounts{30, 42, 3, 0, 0, 0, 3, 0, 0, 0, 5, 36, 18, 0});
        CHECK(read.diagnostics.empty());
    }
    if (const auto file = test::real_data("matrix/stratigraphr/harris12.csv")) {
        const auto read = read_with(stratigraphr_reader(), {load_input_file(*file)});
        CHECK(read.values.units.size() == 10);
        CHECK(test::count_matrix(read.values).same_as == 1);
        CHECK(test::count_matrix(read.values).cycle_groups == 0);
    }
}

TEST_CASE("PolyChron's own demo is read whole") {
    const auto folder = test::real_data("matrix/polychron/demo");
    if (!folder) return;
    std::vector<InputFile> files;
    for (const char* name : {"1-strat.csv", "2-dates.csv", "3-context-grouping.csv",
                             "4-group-ordering-with-relationship.csv", "5-context-equality.csv"}) {
        files.push_back(load_input_file(*folder / name));
    }
    const auto read = read_with(polychron_reader(), files);
    CHECK(test::count_matrix(read.values).units == 7);
    CHECK(test::count_matrix(read.values).orders == 6);
    CHECK(read.values.datings.size() == 7);
    REQUIRE(read.values.phases.size() == 2);
    CHECK(read.diagnostics.empty());
}
