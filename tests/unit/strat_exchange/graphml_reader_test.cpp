// SPDX-License-Identifier: MIT
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

namespace {

std::string shape_node(std::string_view id, std::string_view label, std::string_view shape = "rectangle",
                       std::string_view y = "0") {
    return "<node id=\"" + std::string(id) + "\"><data key=\"d0\"><y:ShapeNode><y:Geometry height=\"20\" y=\"" +
           std::string(y) + "\"/><y:NodeLabel>" + std::string(label) + "</y:NodeLabel><y:Shape type=\"" +
           std::string(shape) + "\"/></y:ShapeNode></data></node>\n";
}

std::string edge(std::string_view from, std::string_view to, std::string_view line = "line",
                 std::string_view source_arrow = "none", std::string_view extra = "") {
    return "<edge source=\"" + std::string(from) + "\" target=\"" + std::string(to) +
           "\"><data key=\"d1\"><y:PolyLineEdge><y:LineStyle type=\"" + std::string(line) + "\"/><y:Arrows source=\"" +
           std::string(source_arrow) + "\" target=\"standard\"/>" + std::string(extra) +
           "</y:PolyLineEdge></data></edge>\n";
}

std::string graphml(std::string_view body) {
    return "<?xml version=\"1.0\"?><graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\" xmlns:y=\"y\">"
           "<key id=\"d0\" for=\"node\" yfiles.type=\"nodegraphics\"/><key id=\"d5\" for=\"node\" "
           "attr.name=\"description\"/>"
           "<key id=\"d6\" for=\"edge\" attr.name=\"relation\"/><graph id=\"G\">" +
           std::string(body) + "</graph></graphml>";
}

} // namespace

TEST_CASE("A matrix drawn in yEd gives units by their labels, groups and one relation for each edge") {
    const InputFile file = input(
        "m.graphml",
        graphml(shape_node("n0", "1\nfloor") + shape_node("n1", "2", "ellipse") +
                "<node id=\"g\"><data key=\"d0\"><y:ProxyAutoBoundsNode><y:Realizers><y:GroupNode><y:NodeLabel>House"
                "</y:NodeLabel></y:GroupNode></y:Realizers></y:ProxyAutoBoundsNode></data><graph id=\"g:\">" +
                shape_node("g::n0", "3") + "</graph></node>" + edge("n0", "n1") + edge("n1", "g::n0", "dashed") +
                edge("n0", "n1", "line", "standard") + edge("n0", "g") + edge("n0", "nowhere") +
                edge("n1", "n0", "line", "none", "<y:EdgeLabel>cut by</y:EdgeLabel>")));
    CHECK(graphml_reader().recognise(std::span(&file, 1)).confidence == Confidence::Certain);
    const auto read = read_with(graphml_reader(), {file});
    CHECK(relation_texts(read.values) == Texts{"1 covers 2", "2 later 3", "1 contemporary 2", "1 cuts 2"});
    REQUIRE(read.values.units.size() == 3);
    CHECK(read.values.units[0].values.title == "floor");
    REQUIRE(read.values.groups.size() == 1);
    CHECK(read.values.groups[0].values.number == "House");
    CHECK(read.values.groups[0].members == std::vector<UnitName>{{"", "3"}});
    CHECK(test::count_notes(read.diagnostics, "group-relation") == 1);
    CHECK(test::count_notes(read.diagnostics, "unknown-target") == 1);
}

TEST_CASE("An Extended Matrix gives epochs by the swim lanes, and its paradata are counted, not read") {
    const std::string table =
        "<node id=\"t\"><data key=\"d0\"><y:TableNode configuration=\"YED_TABLE_NODE\"><y:Geometry y=\"100\"/>"
        "<y:NodeLabel>Forum [ID:7]</y:NodeLabel>"
        "<y:NodeLabel>Imperial [start:-50;end:120]<y:LabelModel/><y:ModelParameter><y:RowNodeLabelModelParameter "
        "id=\"r0\"/>"
        "</y:ModelParameter></y:NodeLabel>"
        "<y:NodeLabel>Republic [start:-300;end:-50]<y:ModelParameter><y:RowNodeLabelModelParameter id=\"r1\"/>"
        "</y:ModelParameter></y:NodeLabel>"
        "<y:Table><y:Insets top=\"30\"/><y:Rows><y:Row id=\"r0\" height=\"200\"/><y:Row id=\"r1\" "
        "height=\"300\"/></y:Rows>"
        "</y:Table></y:TableNode></data><graph id=\"t:\">" +
        shape_node("a", "US01", "rectangle", "140") + shape_node("b", "USV02", "parallelogram", "340") +
        shape_node("c", "D.1", "diamond", "340") + "</graph></node>";
    const auto read = read_with(graphml_reader(),
                                {input("em.graphml", graphml(table + edge("a", "b") + edge("a", "b", "double_line") +
                                                             edge("a", "b", "dashed") + edge("b", "c", "dashed")))});
    CHECK(read.values.project_name == "Forum");
    REQUIRE(read.values.phases.size() == 2);
    CHECK(read.values.phases[0].values.number == "Imperial");
    CHECK(read.values.phases[0].values.from == -50);
    CHECK(read.values.phases[1].values.to == -50);
    REQUIRE(read.values.units.size() == 2);
    CHECK(read.values.units[0].phase == "Imperial");
    CHECK(read.values.units[1].phase == "Republic");
    CHECK(read.values.units[1].values.details.at("custom") == "unit_type=USVs");
    CHECK(relation_texts(read.values) == Texts{"US01 later USV02", "US01 contemporary USV02"});
    CHECK(test::count_notes(read.diagnostics, "extended-matrix-link") == 1);
}

TEST_CASE("GraphML that is cut, has a DOCTYPE or is something else is refused with the file's name") {
    const std::string whole = graphml(shape_node("n0", "1") + shape_node("n1", "2") + edge("n0", "n1"));
    for (std::size_t size = 0; size < whole.size(); size += 5) {
        CHECK_THROWS_WITH(read_with(graphml_reader(), {input("m.graphml", whole.substr(0, size))}),
                          Catch::StartsWith("m.graphml: "));
    }
    CHECK_THROWS_WITH(read_with(graphml_reader(), {input("m.graphml", "<!DOCTYPE x [<!ENTITY a \"b\">]><graphml/>")}),
                      Catch::Contains("DOCTYPE"));
    CHECK_THROWS_WITH(read_with(graphml_reader(), {input("m.graphml", "<svg/>")}),
                      Catch::Contains("XML of another kind"));
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<node><graph>";
    CHECK_THROWS_AS(read_with(graphml_reader(), {input("m.graphml", deep)}), Error);
}

TEST_CASE("The drawing that yEd made of the demo matrix has its units and orders") {
    const auto file = test::real_data("matrix/hmc/demo.yed.graphml");
    const auto original = test::real_data("matrix/hmc/demo.matrix.xml");
    if (!file || !original) return;
    const auto drawn = test::count_matrix(read_with(graphml_reader(), {load_input_file(*file)}).values);
    const auto project = test::count_matrix(read_with(hmcx_reader(), {load_input_file(*original)}).values);
    CHECK(drawn.units == project.units);
    CHECK(drawn.orders == project.orders);
    CHECK(drawn.contemporary == project.contemporary);
    CHECK(drawn.depth == project.depth);
}

TEST_CASE("HMC's own GraphML is left to its reader") {
    const InputFile file =
        input("matrix.xml", "<graphml><graph><node id=\"1\"><data><hmcnode/></data></node></graph></graphml>");
    CHECK(graphml_reader().recognise(std::span(&file, 1)).confidence == Confidence::No);
}
