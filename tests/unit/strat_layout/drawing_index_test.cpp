// SPDX-License-Identifier: MIT
#include <algorithm>

#include "strat/layout/drawing_index.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;

TEST_CASE("The middle of every box and of every stroke leads back to its unit and its order") {
    const model::Record record = test::a_trench({.units = 300, .seed = 4, .width = 40, .layer_reach = 8});
    const MatrixDrawing drawing = test::drawing_of(record);
    const DrawingIndex index(drawing);
    for (std::size_t b = 0; b < drawing.boxes.size(); ++b) {
        REQUIRE(index.box_at(drawing.boxes[b].rect.centre()) == b);
        for (const model::UnitId unit : drawing.boxes[b].units) REQUIRE(index.box_of(unit) == b);
    }
    for (std::size_t l = 0; l < drawing.lines.size(); ++l) {
        const std::vector<DrawPoint>& points = drawing.lines[l].points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const DrawPoint middle{(points[i - 1].x + points[i].x) / 2.0, (points[i - 1].y + points[i].y) / 2.0};
            const std::vector<std::size_t> found = index.lines_at(middle, 2.0);
            REQUIRE(std::find(found.begin(), found.end(), l) != found.end());
        }
        const std::vector<std::size_t>& below = index.lines_below(drawing.lines[l].later);
        const std::vector<std::size_t>& above = index.lines_above(drawing.lines[l].earlier);
        REQUIRE(std::find(below.begin(), below.end(), l) != below.end());
        REQUIRE(std::find(above.begin(), above.end(), l) != above.end());
    }
}

TEST_CASE("What lies beside every box and every line is nothing") {
    const MatrixDrawing drawing = test::drawing_of(test::a_matrix().above("1", "2").record());
    const DrawingIndex index(drawing);
    CHECK_FALSE(index.box_at({1.0, 1.0}).has_value());
    CHECK(index.lines_at({1.0, 1.0}, 4.0).empty());
    CHECK_FALSE(index.box_of(model::UnitId{}).has_value());
    const DrawPoint beside{drawing.lines[0].points[0].x + 3.0, drawing.lines[0].points[0].y + 4.0};
    CHECK(index.lines_at(beside, 2.0).empty());
    CHECK(index.lines_at(beside, 4.0) == std::vector<std::size_t>{0});
}
