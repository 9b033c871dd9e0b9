// SPDX-License-Identifier: MIT
#include "strat/layout/box_label.hpp"
#include "strat/layout/svg_writer.hpp"

#include <fstream>
#include <set>

#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/graphviz_engine.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::a_matrix;

namespace {

MatrixDrawing drawn(const model::Record& record, const DrawingOptions& options = {}) {
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    return GraphvizEngine().draw({record, matrix, text, options, {}}, Progress::none());
}

} // namespace

TEST_CASE("SVG names each unit and each order by id, class and title") {
    auto builder = a_matrix().relate("1042", model::RelationKind::Cuts, "1017");
    builder.kind("1042", model::UnitKind::Cut);
    const std::string svg = write_svg(drawn(builder.record()));
    CHECK_THAT(svg, Catch::Contains("<g id=\"unit-1042\" class=\"unit cut\"><title>1042</title>"));
    CHECK_THAT(svg, Catch::Contains("class=\"order cuts\" data-later=\"unit-1042\" data-earlier=\"unit-1017\""));
    CHECK_THAT(svg, Catch::Contains("<title>1042 cuts 1017</title>"));
    CHECK_THAT(svg, Catch::Contains("textLength="));
}

TEST_CASE("SVG of hostile names and titles is valid XML") {
    auto builder = a_matrix().above("<1&\"2'>", " 16/9").above("B. 36", "1297+").unit("\x01\x1f");
    DrawingOptions options;
    options.title = "</title><script>\"&'";
    options.unit_link = "u/{unit}.html?a=1&b=\"2\"&c={uuid}";
    const test::TemporaryFolder folder;
    const auto file = folder.write("hostile.svg", write_svg(drawn(builder.record(), options)));
    CHECK(std::system(("xmllint --noout " + file.string()).c_str()) == 0);
}

TEST_CASE("Different names give different ids") {
    CHECK(xml_id("unit-", "1 2") != xml_id("unit-", "1_2"));
    CHECK(xml_id("unit-", "1 2") == "unit-1_x202");
    CHECK(xml_id("unit-", "1_x202") != "unit-1_x202");
    // Two ids and `--` between them are the id of an order.
    CHECK(xml_id("unit-", "a--unit-b") == "unit-a-_x2dunit-b");
    CHECK(xml_id("unit-", "-1") == "unit-_x2d1");
    CHECK(xml_id("unit-", "1-") == "unit-1_x2d");
    CHECK(xml_id("unit-", "1-2") == "unit-1-2");
}

TEST_CASE("Orders between hostile names have ids of their own") {
    const MatrixDrawing drawing =
        drawn(a_matrix().above("a--unit-b", "c").above("a", "b--unit-c").above("a--unit-b--unit-c", "a").record());
    std::set<std::string> ids;
    for (const DrawnLine& line : drawing.lines) ids.insert(line.id);
    CHECK(ids.size() == 3);
}

TEST_CASE("Each unit in a box of several has its own id and link in SVG") {
    auto builder = a_matrix().above("1", "2").relate("2", model::RelationKind::SameAs, "16/9 ö");
    DrawingOptions options;
    options.unit_link = "units.html#{unit}";
    const std::string svg = write_svg(drawn(builder.record(), options));
    CHECK_THAT(svg, Catch::Contains("<a xlink:href=\"units.html#1\" href=\"units.html#1\"><g id=\"unit-1\""));
    CHECK_THAT(svg, Catch::Contains("<g id=\"unit-2\" class=\"unit unknown\" "
                                    "data-units=\"unit-2 unit-16_x2f9_x20_xc3_xb6\">"));
    CHECK_THAT(svg, Catch::Contains("href=\"units.html#16%2F9%20%C3%B6\"><tspan id=\"unit-16_x2f9_x20_xc3_xb6\" "
                                    "class=\"unit-name\">16/9 ö</tspan></a>"));
    CHECK_THAT(svg, !Catch::Contains("<a xlink:href=\"units.html#2\" href=\"units.html#2\"><g"));
    const test::TemporaryFolder folder;
    CHECK(std::system(("xmllint --noout " + folder.write("joined.svg", svg).string()).c_str()) == 0);
}

TEST_CASE("A name that goes on over several lines of a joined box keeps its id and its link") {
    const std::string number(120, '8');
    auto builder = a_matrix().above("1", "2").relate("2", model::RelationKind::SameAs, number);
    builder.relate("2", model::RelationKind::SameAs, "90");
    DrawingOptions options;
    options.unit_link = "units.html#{unit}";
    const std::string svg = write_svg(drawn(builder.record(), options));
    for (const std::string& id : {"unit-" + number, std::string("unit-90")}) {
        CHECK_THAT(svg, Catch::Contains("<tspan id=\"" + id + "\" class=\"unit-name\">"));
    }
    const test::TemporaryFolder folder;
    CHECK(std::system(("xmllint --noout " + folder.write("long.svg", svg).string()).c_str()) == 0);
    // All parts of the long name are links to it, and make it up again.
    std::string together;
    const std::string link = "href=\"units.html#" + number + "\"><tspan";
    for (std::size_t at = svg.find(link); at != std::string::npos; at = svg.find(link, at + 1)) {
        const std::size_t begin = svg.find('>', at + link.size()) + 1;
        together += svg.substr(begin, svg.find('<', begin) - begin);
    }
    CHECK(together == number);
}

TEST_CASE("What a comparison marks is told apart without colour, in a cycle, too") {
    const auto style = [](Mark mark, bool in_cycle, bool through) {
        DrawnLine line;
        line.mark = mark;
        line.in_cycle = in_cycle;
        line.through = through;
        return style_of(line);
    };
    CHECK(style(Mark::Removed, false, false).dash != style(Mark::None, false, true).dash);
    CHECK(style(Mark::Removed, false, false).dash != style(Mark::Changed, false, false).dash);
    CHECK(style(Mark::Added, true, false).colour == kAlarm);
    CHECK(style(Mark::Added, true, false).width > 1.5 * style(Mark::None, true, false).width);
}

TEST_CASE("The same record gives the same bytes") {
    const model::Record record = test::a_trench({.units = 40});
    CHECK(write_svg(drawn(record)) == write_svg(drawn(record)));
}
