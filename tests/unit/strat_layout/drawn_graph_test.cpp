// SPDX-License-Identifier: MIT
#include "strat/layout/drawn_graph.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "strat/layout/dot_writer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::a_matrix;

namespace {

DrawnGraph graph_of(const model::Record& record, const DrawingOptions& options = {}) {
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    return make_drawn_graph({record, matrix, text, options, {}});
}

std::vector<std::string> order_names(const DrawnGraph& graph) {
    std::vector<std::string> names;
    for (const GraphOrder& o : graph.orders)
        names.push_back(graph.boxes[o.later].name + ">" + graph.boxes[o.earlier].name);
    return names;
}

} // namespace

TEST_CASE("Only immediate orders are drawn") {
    const DrawnGraph graph = graph_of(a_matrix().above("1", "2").above("2", "3").above("1", "3").record());
    CHECK(order_names(graph) == std::vector<std::string>{"1>2", "2>3"});
}

TEST_CASE("Units merged by same_as share a box") {
    const DrawnGraph graph =
        graph_of(a_matrix().above("1", "2").relate("2", model::RelationKind::SameAs, "7").record());
    REQUIRE(graph.boxes.size() == 2);
    CHECK(graph.boxes[1].box.lines == std::vector<std::string>{"2 = 7"});
}

TEST_CASE("A name that only uncertain statements put into a box has a question mark") {
    using model::Certainty;
    using model::RelationKind;
    auto builder = a_matrix().above("1", "2").relate("2", RelationKind::SameAs, "7", Certainty::Uncertain);
    builder.relate("2", RelationKind::SameAs, "3").relate("7", RelationKind::SameAs, "8");
    const DrawnBox box = graph_of(builder.record()).boxes[1].box;
    CHECK(box.lines == std::vector<std::string>{"2 = 3 =? 7 = 8"});
    CHECK(box.title == "2 = 3 =? 7 = 8");
    builder.relate("3", RelationKind::SameAs, "8");
    CHECK(graph_of(builder.record()).boxes[1].box.title == "2 = 3 = 7 = 8");
}

TEST_CASE("A box whose units are of different phases or groups stands in none") {
    auto builder = a_matrix().above("1", "2").relate("2", model::RelationKind::SameAs, "3").above("3", "4");
    builder.phase("1", "b", 2).phase("3", "b", 2).phase("4", "a", 1);
    DrawingOptions options;
    options.bands = Bands::Phases;
    CHECK(graph_of(builder.record(), options).boxes[1].band == 0); // 2 has no phase of its own
    builder.phase("2", "a", 1);
    const DrawnGraph graph = graph_of(builder.record(), options);
    CHECK(graph.boxes[1].band == kNoBand);
    CHECK(graph.bands.size() == 2);
}

TEST_CASE("A box of several names them in natural order, and its lines say what was recorded of which") {
    auto builder = a_matrix().relate("5", model::RelationKind::Covers, "6").relate("4", model::RelationKind::Cuts, "6");
    builder.relate("4", model::RelationKind::SameAs, "5").relate("5", model::RelationKind::SameAs, "10");
    model::Record record = builder.record();
    for (const char* area : {"North", "South"}) { // sorted by area, 5 is the last of them
        model::Area fresh;
        fresh.id = {SeededUuids(static_cast<std::uint64_t>(record.areas.size()) + 100).next()};
        fresh.name = area;
        record.areas.push_back(fresh);
    }
    for (model::StratigraphicUnit& unit : record.units) unit.area = record.areas[unit.number == "5" ? 1 : 0].id;
    model::sort_record(record);
    const DrawnGraph graph = graph_of(record);
    const auto box =
        std::find_if(graph.boxes.begin(), graph.boxes.end(), [](const GraphBox& b) { return b.units.size() > 1; });
    REQUIRE(box != graph.boxes.end());
    CHECK(box->box.names == std::vector<std::string>{"4", "5", "10"});
    CHECK(box->box.id == "unit-4");
    REQUIRE(graph.orders.size() == 1);
    CHECK_THAT(graph.orders[0].line.title, Catch::Contains("5 covers 6") && Catch::Contains("4 cuts 6"));
}

TEST_CASE("A folded box of which only a part is drawn says so") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4");
    for (const char* unit : {"1", "2", "3"}) builder.phase(unit, "B", 2);
    DrawingOptions options;
    options.fold = Fold::Phases;
    CHECK(graph_of(builder.record(), options).boxes.front().box.lines.back() == "3 units");
    options.only = {builder.id("2"), builder.id("3"), builder.id("4")};
    CHECK(graph_of(builder.record(), options).boxes.front().box.lines.back() == "2 of 3 units");
    options.only.clear();
    builder.phase("9", "A", 1).relate("3", model::RelationKind::SameAs, "9"); // folds with 3
    for (const GraphBox& b : graph_of(builder.record(), options).boxes) {
        CHECK_THAT(b.box.lines.back(), !Catch::Contains(" of "));
    }
}

TEST_CASE("A neighbourhood keeps the orders that hold by way of units left out") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4");
    DrawingOptions options;
    options.only = {builder.id("1"), builder.id("3"), builder.id("4")};
    const DrawnGraph graph = graph_of(builder.record(), options);
    CHECK(order_names(graph) == std::vector<std::string>{"1>3", "3>4"});
    CHECK(graph.orders[0].line.through);
    CHECK_FALSE(graph.orders[1].line.through);
}

TEST_CASE("Around a unit means so many immediate orders up and down") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("4", "5");
    DrawingOptions options;
    options.around = builder.id("3");
    options.around_steps = 1;
    CHECK(order_names(graph_of(builder.record(), options)) == std::vector<std::string>{"2>3", "3>4"});
}

TEST_CASE("Around a unit stands what is contemporary with it, too") {
    auto builder = a_matrix().above("1", "2").above("2", "3");
    builder.relate("4", model::RelationKind::Contemporary, "2");
    DrawingOptions options;
    options.around_steps = 1;
    const auto names_around = [&](const char* unit) {
        options.around = builder.id(unit);
        std::vector<std::string> names;
        for (const GraphBox& b : graph_of(builder.record(), options).boxes) names.push_back(b.name);
        return names;
    };
    CHECK(names_around("4") == std::vector<std::string>{"2", "4"});
    CHECK(names_around("2") == std::vector<std::string>{"1", "2", "3", "4"});
}

TEST_CASE("An unknown area is an error that names it") {
    DrawingOptions options;
    options.area = "Trench 9";
    CHECK_THROWS_WITH(graph_of(a_matrix().above("1", "2").record(), options), "no area Trench 9");
}

TEST_CASE("Folded phases become boxes whose orders are reduced again") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("1", "3").above("1", "4").above("4", "3");
    builder.phase("1", "III", 3).phase("2", "II", 2).phase("4", "II", 2).phase("3", "I", 1);
    DrawingOptions options;
    options.fold = Fold::Phases;
    const DrawnGraph graph = graph_of(builder.record(), options);
    CHECK(order_names(graph) == std::vector<std::string>{"III>II", "II>I"});
    CHECK(graph.boxes[1].box.lines == std::vector<std::string>{"II", "2 units"});
}

TEST_CASE("Bands run from the latest phase to the earliest, unasked where most units have one") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("4", "5").above("5", "6");
    builder.phase("1", "b", 2).phase("2", "b", 2).phase("3", "b", 2);
    builder.phase("4", "a", 1).phase("5", "a", 1).phase("6", "a", 1);
    const DrawnGraph graph = graph_of(builder.record());
    REQUIRE(graph.bands.size() == 2);
    CHECK(graph.bands[0].heading == "b");
    CHECK(graph.boxes[0].band == 0);
    CHECK(graph.boxes[5].band == 1);
}

TEST_CASE("Bands whose phases say nothing of their time stand as the orders between their units do") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4");
    builder.phase("1", "modern", 0).phase("2", "medieval", 3).phase("3", "roman", 2).phase("4", "bronze age", 1);
    DrawingOptions options;
    options.bands = Bands::Phases;
    const auto headings = [&](const model::Record& record) {
        std::vector<std::string> all;
        for (const GraphBand& band : graph_of(record, options).bands) all.push_back(band.heading);
        return all;
    };
    const std::vector<std::string> expected{"modern", "medieval", "roman", "bronze age"};
    model::Record record = builder.record();
    for (model::Phase& phase : record.phases) {
        if (phase.number == "modern") phase.rank.reset();
    }
    CHECK(headings(record) == expected);
    for (model::Phase& phase : record.phases) phase.rank.reset();
    CHECK(headings(record) == expected);
    // Two sequences that one order joins: no single strip can be moved to the better.
    auto joined = a_matrix().above("1", "2").above("2", "3").above("4", "5").above("5", "6").above("6", "1");
    for (int i = 1; i <= 6; ++i) joined.phase(std::to_string(i), std::string(1, static_cast<char>('g' - i)), 0);
    model::Record two = joined.record();
    for (model::Phase& phase : two.phases) phase.rank.reset();
    CHECK(headings(two) == std::vector<std::string>{"c", "b", "a", "f", "e", "d"});
    // One order against what is dated does not turn it round.
    model::Record dated =
        a_matrix().above("1", "2").above("3", "4").phase("1", "old", 1).phase("2", "young", 2).record();
    dated.phases.push_back({});
    dated.phases.back().id = {SeededUuids{77}.next()};
    dated.phases.back().number = "undated";
    dated.units[2].phase = dated.phases.back().id;
    const auto found = headings(dated);
    REQUIRE(found.size() == 3);
    CHECK(std::find(found.begin(), found.end(), "young") < std::find(found.begin(), found.end(), "old"));
}

TEST_CASE("Phases for every unit or two are no bands unless asked for") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("4", "5");
    builder.phase("1", "e", 5).phase("2", "d", 4).phase("3", "c", 3).phase("4", "b", 2).phase("5", "a", 1);
    CHECK(graph_of(builder.record()).bands.empty());
    DrawingOptions options;
    options.bands = Bands::Phases;
    CHECK(graph_of(builder.record(), options).bands.size() == 5);
}

TEST_CASE("Phases that many orders run against are no bands unless asked for") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("4", "5").above("5", "6");
    builder.phase("1", "a", 1).phase("2", "a", 1).phase("3", "a", 1);
    builder.phase("4", "b", 2).phase("5", "b", 2).phase("6", "b", 2);
    CHECK(graph_of(builder.record()).bands.empty());
    DrawingOptions options;
    options.bands = Bands::Phases;
    CHECK(graph_of(builder.record(), options).bands.size() == 2);
    // One in twenty may.
    for (int i = 0; i < 20; ++i) {
        const std::string number = std::to_string(100 + i);
        builder.above("3", number).phase(number, "a", 1);
    }
    CHECK(graph_of(builder.record()).bands.size() == 2);
}

TEST_CASE("An order is uncertain only if nothing certain says it") {
    using model::Certainty;
    using model::RelationKind;
    auto builder = a_matrix().relate("1", RelationKind::Covers, "2", Certainty::Uncertain);
    CHECK(graph_of(builder.record()).orders.at(0).line.uncertain);
    builder.relate("1", RelationKind::Cuts, "2");
    CHECK_FALSE(graph_of(builder.record()).orders.at(0).line.uncertain);
}

TEST_CASE("Cycles stay in the drawing, all of their orders, marked") {
    const DrawnGraph graph =
        graph_of(a_matrix().above("1", "2").above("2", "3").above("3", "1").above("3", "4").record());
    CHECK(graph.orders.size() == 4);
    CHECK(graph.orders[0].line.in_cycle);
    CHECK(graph.boxes[0].box.in_cycle);
    CHECK_FALSE(graph.boxes[3].box.in_cycle);
}

TEST_CASE("A contradiction that no line can show marks its box and says what it is") {
    using model::RelationKind;
    auto builder = a_matrix().relate("1", RelationKind::SameAs, "2").above("2", "1").above("3", "2").above("4", "4");
    const DrawnGraph graph = graph_of(builder.record());
    REQUIRE(graph.boxes.size() == 3);
    CHECK(graph.boxes[0].box.inner_cycle);
    CHECK(graph.boxes[0].box.in_cycle);
    CHECK(graph.boxes[0].box.title == "1 = 2; contradiction: 2 covers 1");
    CHECK_FALSE(graph.boxes[1].box.in_cycle);
    CHECK(graph.boxes[2].box.title == "4; contradiction: 4 covers 4");
    CHECK_THAT(graph.description, Catch::Contains("1 = 2: 2 covers 1"));
    // What the outline has more stays clear of the label.
    const DrawnBox& box = graph.boxes[0].box;
    CHECK(outline_of(box).strokes.size() > outline_of(graph.boxes[1].box).strokes.size());
    const double label = box.rect.centre().x - box.line_widths.front() / 2.0;
    for (const auto& stroke : outline_of(box).strokes) {
        for (const DrawPoint& p : stroke) CHECK(p.x < label);
    }
}

TEST_CASE("A cycle inside a folded box, or through units left out, is not hidden") {
    auto builder = a_matrix().above("1", "2").above("2", "1").above("3", "4").above("4", "5").above("5", "3");
    builder.phase("1", "a", 1).phase("2", "a", 1).phase("3", "b", 2).phase("4", "b", 2).phase("5", "c", 3);
    DrawingOptions folded;
    folded.fold = Fold::Phases;
    const DrawnGraph graph = graph_of(builder.record(), folded);
    REQUIRE(graph.boxes.size() == 3);
    CHECK(graph.boxes[0].box.inner_cycle);
    CHECK_THAT(graph.boxes[0].box.title, Catch::EndsWith("; contradiction: 1 covers 2, 2 covers 1"));
    CHECK(graph.boxes[1].box.inner_cycle); // 3 over 4, and the way back leads over 5
    CHECK_FALSE(graph.boxes[2].box.inner_cycle);
    CHECK(graph.boxes[2].box.in_cycle);
    DrawingOptions part;
    part.only = {builder.id("4")};
    const DrawnGraph alone = graph_of(builder.record(), part);
    REQUIRE(alone.boxes.size() == 1);
    CHECK(alone.boxes[0].box.in_cycle);
    CHECK(alone.boxes[0].box.title == "4; in a cycle with units that are not drawn");
}

TEST_CASE("DOT quotes what would end a string") {
    CHECK(dot_quoted("a\"b\\c") == "\"a\\\"b\\\\c\"");
    const std::string dot = write_dot(graph_of(a_matrix().above("1", "2").record()));
    CHECK_THAT(dot, Catch::Contains("\"1\" -> \"2\""));
}
