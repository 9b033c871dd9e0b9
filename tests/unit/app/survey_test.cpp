// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "app/survey/code_table.hpp"
#include "app/survey/survey_csv.hpp"
#include "app/survey/survey_dxf.hpp"
#include "app/survey/survey_import.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

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
    CHECK_THROWS_AS(app::read_survey_csv("p1,1,2,3,TOP\n", "a.csv", "name,x,y,z,cod"), Error);
    CHECK(app::read_survey_csv("p1,77,1,2,3,TOP\n", "a.csv", "name,-,x,y,z,code").points[0].x == 1.0);
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

TEST_CASE("A point of a drawing without a height has none, and that is said once for all of them") {
    const auto file = app::read_survey_dxf(
        dxf("0\nPOINT\n8\nOK\n10\n1\n20\n2\n0\nPOINT\n8\nOK\n10\n3\n20\n2\n30\n0.0\n0\nPOINT\n8\nOK\n10\n4\n20\n2\n"),
        "flat.dxf");
    REQUIRE(file.points.size() == 3);
    CHECK_FALSE(file.points[0].z);
    CHECK(file.points[1].z == 0.0);
    REQUIRE(file.notes.size() == 1);
    CHECK_THAT(file.notes[0].message, Catch::Contains("2 of 3 points"));
}

TEST_CASE("In a table a name is a name: without a code nothing becomes a level") {
    const test::TemporaryFolder folder;
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    project.change("units", [&] {
        for (const char* number : {"1", "2"}) {
            model::StratigraphicUnit unit;
            unit.number = number;
            project.file().insert(unit);
        }
    });
    const auto plain = folder.write("plain.csv", "name,x,y,z\nT1,100,200,9.5\nB2,101,200,9.4\n");
    CHECK(app::import_survey(project, {plain}, {}).new_levels == 0);
    const auto coded = folder.write("coded.csv", "name,x,y,z,code\nT1,100,200,9.5,\nB2,101,200,9.4,UK2\n");
    CHECK(app::import_survey(project, {coded}, {}).new_levels == 1);
    CHECK(project.record().levels.at(0).role == model::LevelRole::Base);
    const auto text =
        folder.write("plan.dxf", dxf("0\nTEXT\n8\n0\n10\n1\n20\n2\n30\n3\n1\nOK 1\n0\nTEXT\n8\n0\n10\n1\n20\n"
                                     "2\n1\nOK 2\n0\nTEXT\n8\n0\n10\n1\n20\n2\n1\ntext\n"));
    const auto report = app::import_survey(project, {text}, {});
    CHECK(report.new_levels == 1);
    CHECK(std::count_if(report.notes.begin(), report.notes.end(),
                        [](const auto& note) { return note.code == "no-height"; }) == 2);
}

TEST_CASE("A find may be described as text, and a day that is none is refused") {
    const test::TemporaryFolder folder;
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    const auto file = folder.write("f.csv", "name,x,y,z,code,text\n17,1,2,3,FIND,text\n");
    app::SurveyOptions options;
    options.day = "1 June";
    CHECK_THROWS_AS(app::import_survey(project, {file}, options), Error);
    options.day = "2025-06-01";
    CHECK(app::import_survey(project, {file}, options).new_finds == 1);
    CHECK(project.record().finds.at(0).description == "text");
}

TEST_CASE("With an area said, the unit of the same number in another area is not meant") {
    const test::TemporaryFolder folder;
    model::ProjectSettings settings;
    settings.numbers = model::NumberScope::Area;
    app::Project project = app::Project::create(folder / "site.gpkg", settings, {});
    project.change("unit", [&] {
        model::Area area;
        area.name = "A";
        model::StratigraphicUnit unit;
        unit.number = "5";
        unit.area = project.file().insert(area);
        project.file().insert(unit);
    });
    const auto file = folder.write("f.csv", "name,x,y,z,code\np,1,2,3,OK5\n");
    app::SurveyOptions options;
    options.area = "B";
    CHECK(app::import_survey(project, {file}, options).new_levels == 0);
    options.area = "A";
    CHECK(app::import_survey(project, {file}, options).new_levels == 1);
}

TEST_CASE("Drawings that cannot be read are refused in a sentence") {
    CHECK(app::is_dxf(dxf("")));
    CHECK_FALSE(app::is_dxf("name,x,y,z,code\n"));
    CHECK_THROWS_AS(app::read_survey_dxf("AutoCAD Binary DXF\r\n\x1a", "a.dxf"), Error);
    CHECK_THROWS_AS(app::read_survey_dxf(dxf(""), "a.dxf"), Error);
    CHECK_THROWS_AS(app::read_survey_dxf("0\nSECTION\n2\nENTITIES\nhello\nx\n", "a.dxf"), Error);
    const auto unplaced =
        app::read_survey_dxf(dxf("0\nPOINT\n8\nOK\n10\nnan\n20\n2\n0\nPOINT\n10\n1\n20\n1\n30\n1\n"), "a.dxf");
    CHECK(unplaced.points.size() == 1);
    CHECK(unplaced.notes.size() == 1);
}
