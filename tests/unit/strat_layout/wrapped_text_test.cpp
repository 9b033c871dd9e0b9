// SPDX-License-Identifier: MIT
#include "strat/layout/wrapped_text.hpp"

#include "core/base/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::a_matrix;

TEST_CASE("Text is broken between words, and what is too much ends in an ellipsis") {
    const TableTextMeasure measure;
    const TextLook look{9.0, FontWeight::Regular};
    const auto fits = [&](const std::string& s) { return measure.width(s, 9.0, FontWeight::Regular) <= 60.0; };
    CHECK(wrapped("", 60.0, 3, look, measure).empty());
    CHECK(wrapped("short", 60.0, 3, look, measure) == std::vector<std::string>{"short"});
    const std::vector<std::string> lines = wrapped("one two three four five six seven eight", 60.0, 3, look, measure);
    REQUIRE(lines.size() == 3);
    for (const std::string& line : lines) CHECK(fits(line));
    CHECK(lines[0] == "one two");
    CHECK_THAT(lines[2], Catch::EndsWith("…"));
    const std::string cut = shortened("Größenwahnüberschwemmungsgebiet", 60.0, look, measure);
    CHECK(fits(cut));
    CHECK_THAT(cut, Catch::StartsWith("Größen") && Catch::EndsWith("…"));
    CHECK(shortened("é", 0.0, look, measure) == "…");
}

TEST_CASE("What is too much goes from the middle where names differ at their ends") {
    const TableTextMeasure measure;
    const TextLook look{9.0, FontWeight::Regular};
    CHECK(shortened_inside("1017", 60.0, look, measure) == "1017");
    const std::string cut = shortened_inside("Südquadrant Schnitt 4 – 1017", 60.0, look, measure);
    CHECK(measure.width(cut, look.size, look.weight) <= 60.0);
    CHECK_THAT(cut, Catch::StartsWith("Süd") && Catch::Contains("…") && Catch::EndsWith("017"));
    CHECK(shortened_inside("é", 0.0, look, measure) == "…");
}

TEST_CASE("A long name is broken, not cut off, behind a blank or sign where one is near") {
    const TableTextMeasure measure;
    const TextLook look{9.0, FontWeight::Regular};
    for (const std::string name :
         {"", "1017", "Südquadrant/Schnitt-4/1017", "ÄÖÜäöüÄÖÜäöüÄÖÜäöüÄÖÜäöü", "a b c d e f"}) {
        const std::vector<std::string> lines = broken_anywhere(name, 40.0, look, measure);
        REQUIRE_FALSE(lines.empty());
        std::string together;
        for (const std::string& line : lines) {
            CHECK(measure.width(line, look.size, look.weight) <= 40.0);
            together += line;
        }
        CHECK(together == name);
    }
    CHECK(broken_anywhere("Nord-1017", 40.0, look, measure) == std::vector<std::string>{"Nord-", "1017"});
    CHECK(broken_anywhere("ab", 0.0, look, measure) == std::vector<std::string>{"a", "b"});
}

TEST_CASE("A unit with a very long number gets a box of several lines, all of the number in it") {
    std::string number;
    for (int i = 0; i < 75; ++i) number += "12/4";
    const MatrixDrawing drawing = test::drawing_of(a_matrix().above(number, "2").record());
    const DrawnBox& box = drawing.boxes.back();
    REQUIRE(box.names.front() == number);
    CHECK(box.rect.width < 300.0);
    CHECK(text::join(box.lines, "") == number);
}

TEST_CASE("A long name of the site, or one of two lines, widens no page") {
    auto builder = a_matrix().above("1", "2");
    builder.raw().settings.name = "Short";
    const double narrow = test::drawing_of(builder.record()).width;
    std::string name;
    for (int i = 0; i < 40; ++i) name += "Rettungsgrabung ";
    builder.raw().settings.name = name + "\nand more\u202e";
    const MatrixDrawing drawing = test::drawing_of(builder.record());
    CHECK(drawing.width < narrow + 340.0);
    CHECK(drawing.title.find('\n') == std::string::npos);
    CHECK(drawing.title.find("\u202e") == std::string::npos);
    CHECK(std::count_if(drawing.texts.begin(), drawing.texts.end(),
                        [](const DrawnText& t) { return t.role == "title"; }) == 3);
    for (const DrawnText& t : drawing.texts) {
        if (t.role == "title") CHECK(t.at.y < drawing.boxes.front().rect.y);
    }
}

TEST_CASE("A line end in a unit's number is drawn as a blank, a turning sign as what cannot be read") {
    const MatrixDrawing drawing = test::drawing_of(a_matrix().above("1\n2", "A\u202e77").record());
    CHECK(drawing.boxes.front().lines.front() == "1 2");
    CHECK(drawing.boxes.back().lines.front() == "A\uFFFD77");
}

TEST_CASE("All words of the drawing's own come from the table") {
    using model::UnitKind;
    auto builder = a_matrix();
    builder.above("1", "2").above("2", "1").above("3", "3").above("1", "4").relate("4", model::RelationKind::Covers,
                                                                                   "5", model::Certainty::Uncertain);
    builder.kind("1", UnitKind::Cut).kind("2", UnitKind::Deposit).unit("6");
    builder.raw().settings.name = "";
    DrawingOptions options;
    DrawingWords& words = options.words;
    for (std::string* word :
         {&words.mentioned_only, &words.with_finds, &words.inner_cycle, &words.uncertain, &words.through,
          &words.in_cycle, &words.against_bands, &words.untitled, &words.isolated}) {
        *word = "~" + *word;
    }
    for (std::string& word : words.shapes) word = "~" + word;
    const MatrixDrawing drawing = test::drawing_of(builder.record(), options);
    REQUIRE(drawing.texts.size() >= 6);
    for (const DrawnText& t : drawing.texts) CHECK_THAT(t.text, Catch::StartsWith("~"));
    // A table half translated would be seen by nobody who tests in English.
    const DrawingWords english;
    const DrawingWords german = words_in("de");
    for (std::size_t i = 0; i < english.shapes.size(); ++i) CHECK(german.shapes[i] != english.shapes[i]);
    CHECK(german.isolated.find("{}") != std::string::npos);
    CHECK(german.units.find("{}") != std::string::npos);
    options.words = german;
    CHECK(test::drawing_of(a_matrix().above("1", "2").record(), options).description ==
          "Harris-Matrix: 2 Befunde in 2 Kästen, 1 unmittelbare Abfolge; jüngere Befunde stehen über älteren.");
}
