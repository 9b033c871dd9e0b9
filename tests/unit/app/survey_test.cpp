// SPDX-License-Identifier: MIT
#include <string>

#include "app/survey/code_table.hpp"
#include "app/survey/survey_csv.hpp"
#include "app/survey/survey_dxf.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using app::SurveyMeaning;

namespace {

std::string dxf(const std::string& entities) {
    return "  0\nSECTION\n  2\nENTITIES\n" + entities + "  0\nENDSEC\n  0\nEOF\n";
}

} // namespace

TEST_CASE("Codes are read with and without a number, in any case, and the project's own come first") {
    app::CodeTable codes;
    const auto read = [&](const char* code) { return codes.read(code).value_or(app::ReadCode{}); };
    CHECK(read("ok1042").meaning == SurveyMeaning::Top);
    CHECK(read("ok1042").number == "1042");
    CHECK(read("UK: 16/9").number == "16/9");
    CHECK(read("Fund 17").meaning == SurveyMeaning::Find);
    CHECK(read("CUT").number.empty());
    CHECK_FALSE(codes.read("TREE"));
    CHECK_FALSE(codes.read(""));
    CHECK_FALSE(codes.read("topsoil"));
    codes.add_table("code;meaning\nok;base\nRim;cut\n", "codes.csv");
    CHECK(read("OK 5").meaning == SurveyMeaning::Base);
    CHECK(read("rim-5").meaning == SurveyMeaning::Cut);
    CHECK_THROWS_AS(codes.add_table("x,y\n", "codes.csv"), Error);
}

TEST_CASE("Points come from tables with headings, without, and apart by blanks") {
    const auto named =
        app::read_survey_csv("Code;Hochwert;Rechtswert;Höhe;Nr\nOK 1;200,5;100,25;9,5;p1\n", "a.csv", "");
    REQUIRE(named.points.size() == 1);
    CHECK(named.points[0].x == 100.25);
    CHECK(named.points[0].y == 200.5);
    CHECK(named.points[0].z == 9.5);
    CHECK(named.points[0].name == "p1");
    const auto plain = app::read_survey_csv("p1,100,200,9.5,TOP1\np2,101,200,,FIND\n", "a.csv", "");
    REQUIRE(plain.points.size() == 2);
    CHECK_FALSE(plain.points[1].z);
    const auto blanks = app::read_survey_csv("p1   100.0 200.0  9.5 TOP1\n p2 101 200 9.6 UK1 \n", "a.txt", "");
    REQUIRE(blanks.points.size() == 2);
    CHECK(blanks.points[1].code == "UK1");
    const auto swapped = app::read_survey_csv("p1,200,100,9.5,TOP1\n", "a.csv", "name,y,x,z,code");
    CHECK(swapped.points[0].x == 100.0);
    CHECK_THROWS_AS(app::read_survey_csv("", "a.csv", ""), Error);
    CHECK_THROWS_AS(app::read_survey_csv("p1,1,2,3,TOP\n", "a.csv", "name,z,code"), Error);
}

TEST_CASE("Points of a drawing have the layer for a code and the nearest text of it for a name") {
    const auto file = app::read_survey_dxf(dxf("0\nPOINT\n8\nOK\n10\n1\n20\n2\n30\n3\n0\nPOINT\n8\nOK\n10\n5\n20\n2\n30"
                                               "\n3\n0\nTEXT\n8\nOK\n10\n5.1\n20\n2\n1\n1042\n"
                                               "0\nTEXT\n8\nFIND\n10\n1.1\n20\n2\n1\n99\n0\nLINE\n8\nOK\n10\n0\n20\n0\n"
                                               "0\nINSERT\n8\n0\n2\nFUND\n10\n7\n20\n8\n30\n9\n0\nATTRIB\n2\nNR\n1\nF3"
                                               "\n0\nATTRIB\n2\nUS\n1\n12\n0\nSEQEND\n"),
                                           "a.dxf");
    REQUIRE(file.points.size() == 4);
    CHECK(file.points[0].name.empty()); // the text beside it is of another layer
    CHECK(file.points[1].name == "1042");
    CHECK(file.points[2].code == "FUND");
    CHECK(file.points[2].name == "F3");
    CHECK(file.points[2].unit == "12");
    CHECK(file.points[2].z == 9.0);
    CHECK(file.points[3].name == "99");
}

TEST_CASE("Drawings that cannot be read are refused in a sentence") {
    CHECK(app::is_dxf(dxf("")));
    CHECK_FALSE(app::is_dxf("name,x,y,z,code\n"));
    CHECK_THROWS_AS(app::read_survey_dxf("AutoCAD Binary DXF\r\n\x1a", "a.dxf"), Error);
    CHECK_THROWS_AS(app::read_survey_dxf(dxf(""), "a.dxf"), Error);
    CHECK_THROWS_AS(app::read_survey_dxf("0\nSECTION\n2\nENTITIES\nhello\nx\n", "a.dxf"), Error);
    const auto unplaced =
        app::read_survey_dxf(dxf("0\nPOINT\n8\nOK\n10\nnan\n20\n2\n0\nPOINT\n10\n1\n20\n1\n"), "a.dxf");
    CHECK(unplaced.points.size() == 1);
    CHECK(unplaced.notes.size() == 1);
}
