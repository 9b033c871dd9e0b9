// SPDX-License-Identifier: MIT
#include "strat/layout/rank_phase.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "strat/layout/drawing_colours.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/drawn_boxes.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::a_matrix;
using planum::test::box_named;
using planum::test::broken_law;
using planum::test::drawing_of;

TEST_CASE("Contemporary units stand on one level unless an order contradicts") {
    using model::RelationKind;
    auto builder = a_matrix().above("1", "2").above("2", "3").above("1", "4").above("4", "5").above("3", "5");
    builder.relate("3", RelationKind::Contemporary, "4");
    const MatrixDrawing drawing = drawing_of(builder.record());
    CHECK(box_named(drawing, "3").rect.y == box_named(drawing, "4").rect.y);
    builder.relate("1", RelationKind::Contemporary, "5");
    CHECK(broken_law(builder.record(), drawing_of(builder.record())).empty());
}

TEST_CASE("A unit that is contemporary with another and in no order stands beside it") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("1", "4").above("4", "5").above("1", "6");
    builder.relate("9", model::RelationKind::Contemporary, "2");
    const model::Record record = builder.record();
    const MatrixDrawing drawing = drawing_of(record);
    const DrawRect& lone = box_named(drawing, "9").rect;
    const DrawRect& partner = box_named(drawing, "2").rect;
    CHECK_FALSE(box_named(drawing, "9").isolated);
    CHECK(lone.y == partner.y);
    for (const DrawnBox& other : drawing.boxes) { // nobody between them
        const double x = other.rect.centre().x;
        const bool between = x > std::min(lone.right(), partner.right()) && x < std::max(lone.x, partner.x);
        if (other.rect.y == lone.y) CHECK_FALSE(between);
    }
    CHECK(broken_law(record, drawing).empty());
}

TEST_CASE("Parts that only something contemporary joins stand on its level") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("11", "12");
    builder.relate("3", model::RelationKind::Contemporary, "11");
    const MatrixDrawing drawing = drawing_of(builder.record());
    CHECK(box_named(drawing, "3").rect.y == box_named(drawing, "11").rect.y);
    CHECK(broken_law(builder.record(), drawing).empty());
}

TEST_CASE("With phases, too, a unit in no order and no phase stands beside what it is contemporary with") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4");
    for (const char* unit : {"1", "2"}) builder.phase(unit, "B", 2);
    for (const char* unit : {"3", "4"}) builder.phase(unit, "A", 1);
    builder.relate("9", model::RelationKind::Contemporary, "3");
    DrawingOptions options;
    options.bands = Bands::Phases;
    const MatrixDrawing drawing = drawing_of(builder.record(), options);
    CHECK(box_named(drawing, "9").rect.y == box_named(drawing, "3").rect.y);
    CHECK(broken_law(builder.record(), drawing).empty());
}

TEST_CASE("Natural ground lies on the last level, topsoil on the first") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("1", "9").above("8", "4");
    builder.kind("9", model::UnitKind::Natural);
    model::Record record = builder.record();
    for (model::StratigraphicUnit& unit : record.units) {
        if (unit.number == "8") unit.title = "Topsoil";
    }
    const MatrixDrawing drawing = drawing_of(record);
    CHECK(box_named(drawing, "9").rect.bottom() == box_named(drawing, "4").rect.bottom());
    CHECK(box_named(drawing, "8").rect.y == box_named(drawing, "1").rect.y);
}

TEST_CASE("Bands enclose their units and nobody else's") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("3", "4").above("1", "5");
    builder.phase("1", "III", 3).phase("2", "II", 2).phase("3", "II", 2).phase("4", "I", 1).phase("5", "I", 1);
    const model::Record record = builder.record();
    DrawingOptions options;
    options.bands = Bands::Phases;
    const MatrixDrawing drawing = drawing_of(record, options);
    CHECK(broken_law(record, drawing).empty());
    REQUIRE(drawing.bands.size() == 3);
    const auto inside = [&](const std::string& unit, std::size_t band) {
        const DrawRect& r = box_named(drawing, unit).rect;
        return r.y > drawing.bands[band].rect.y && r.bottom() < drawing.bands[band].rect.bottom();
    };
    CHECK(inside("1", 0));
    CHECK(inside("2", 1));
    CHECK(inside("3", 1));
    CHECK(inside("4", 2));
    CHECK(inside("5", 2));
}

TEST_CASE("What no relation joins to a unit with a phase stands below all phases") {
    auto builder = a_matrix().above("1", "2").above("2", "3").above("11", "12");
    builder.phase("1", "II", 2).phase("2", "II", 2).phase("3", "I", 1);
    builder.relate("7", model::RelationKind::Contemporary, "9");
    DrawingOptions options;
    options.bands = Bands::Phases;
    const MatrixDrawing drawing = drawing_of(builder.record(), options);
    REQUIRE(drawing.bands.size() == 2);
    for (const char* unit : {"7", "9", "11", "12"}) {
        CHECK(box_named(drawing, unit).rect.y > drawing.bands.back().rect.bottom());
    }
    CHECK(broken_law(builder.record(), drawing).empty());
}

TEST_CASE("No line runs along the edge of a band") {
    auto builder = a_matrix();
    for (int i = 1; i <= 12; ++i) builder.phase(std::to_string(i), "P" + std::to_string((i - 1) / 4), -(i - 1) / 4);
    for (int i = 1; i <= 8; ++i) builder.above(std::to_string(i), std::to_string(i + 4));
    builder.above("1", "6").above("1", "7").above("4", "6").above("5", "11").above("8", "10");
    DrawingOptions options;
    options.bands = Bands::Phases;
    const model::Record record = builder.record();
    const MatrixDrawing drawing = drawing_of(record, options);
    REQUIRE(drawing.bands.size() == 3);
    CHECK(broken_law(record, drawing).empty());
    for (const DrawnBand& band : drawing.bands) {
        for (const DrawnLine& line : drawing.lines) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                if (line.points[i].y != line.points[i - 1].y) continue;
                CHECK(std::abs(line.points[i].y - band.rect.y) > 4.0);
                CHECK(std::abs(line.points[i].y - band.rect.bottom()) > 4.0);
            }
        }
    }
}

TEST_CASE("An order against the phases is drawn upwards, not left out") {
    auto builder = a_matrix().above("1", "2").above("2", "3");
    builder.phase("1", "old", 1).phase("2", "young", 2).phase("3", "old", 1);
    const model::Record record = builder.record();
    DrawingOptions options;
    options.bands = Bands::Phases;
    const MatrixDrawing drawing = drawing_of(record, options);
    CHECK(broken_law(record, drawing).empty());
    CHECK(std::count_if(drawing.lines.begin(), drawing.lines.end(), [](const DrawnLine& l) { return l.upwards; }) == 1);
    // The key shows it with its head, which stands on its line and nowhere else.
    const auto sample = std::find_if(drawing.legend.begin(), drawing.legend.end(),
                                     [](const LegendSample& s) { return s.line.upwards; });
    REQUIRE(sample != drawing.legend.end());
    const auto [low, high] = std::minmax_element(sample->line.points.begin(), sample->line.points.end(),
                                                 [](const DrawPoint& a, const DrawPoint& b) { return a.x < b.x; });
    for (const DrawPoint& p : arrow_head(sample->line)) {
        CHECK(p.x > low->x);
        CHECK(p.x < high->x);
        CHECK(p.y > sample->line.points.front().y - 20.0);
    }
}

TEST_CASE("A fill stands right above its cut, however long the way below it is") {
    auto builder = a_matrix();
    builder.above("1", "2").above("2", "3").above("3", "9"); // fill 2 and cut 3 of a pit
    builder.above("1", "4").above("4", "5").above("5", "6").above("6", "7").above("7", "9");
    const model::Record record = builder.record();
    const MatrixDrawing drawing = drawing_of(record);
    CHECK(broken_law(record, drawing).empty());
    std::map<std::string, double> y;
    for (const DrawnBox& box : drawing.boxes) y[box.names.front()] = box.rect.y;
    CHECK(y["3"] - y["2"] == y["5"] - y["4"]);
}

TEST_CASE("Many pits between one surface and one ground stand on several levels") {
    auto builder = a_matrix();
    for (int i = 2; i < 42; ++i) builder.above("1", std::to_string(i)).above(std::to_string(i), "99");
    for (int i = 50; i < 54; ++i) builder.above(std::to_string(i), std::to_string(i + 1));
    builder.above("1", "50").above("54", "99");
    const model::Record record = builder.record();
    const MatrixDrawing drawing = drawing_of(record);
    CHECK(broken_law(record, drawing).empty());
    std::map<double, int> on_level;
    for (const DrawnBox& box : drawing.boxes) ++on_level[box.rect.y];
    for (const auto& [level, boxes] : on_level) CHECK(boxes <= 20);
}
