// SPDX-License-Identifier: MIT
#include "strat/layout/graphviz_engine.hpp"

#include "core/base/error.hpp"
#include "strat/layout/svg_writer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;
using planum::test::a_matrix;

namespace {

MatrixDrawing drawn(const model::Record& record, const GraphvizOptions& options = {}) {
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    return GraphvizEngine(options).draw({record, matrix, text, {}, {}}, Progress::none());
}

} // namespace

TEST_CASE("Graphviz in the child process puts later units above earlier ones") {
    const MatrixDrawing drawing =
        drawn(a_matrix().above("1", "2").above("1", "3").above("2", "4").above("3", "4").record());
    REQUIRE(drawing.boxes.size() == 4);
    REQUIRE(drawing.lines.size() == 4);
    for (const DrawnLine& line : drawing.lines) {
        CHECK(drawing.boxes[line.later].rect.bottom() < drawing.boxes[line.earlier].rect.y);
        CHECK(line.points.size() >= 2);
    }
    CHECK(drawing.width > 0.0);
}

TEST_CASE("A matrix without any order needs no Graphviz and still makes a page") {
    const MatrixDrawing drawing = drawn(a_matrix().unit("1").unit("2").record());
    REQUIRE(drawing.boxes.size() == 2);
    CHECK(drawing.boxes[0].rect.right() < drawing.boxes[1].rect.x);
}

TEST_CASE("A layout process that cannot be started is an error that names it") {
    GraphvizOptions options;
    options.executable = "/nonexistent/planum";
    CHECK_THROWS_WITH(drawn(a_matrix().above("1", "2").record(), options), Catch::Contains("/nonexistent/planum"));
}

TEST_CASE("A program that is no layout process is an error, not a drawing") {
    GraphvizOptions options;
    options.executable = "/bin/true";
    CHECK_THROWS_AS(drawn(a_matrix().above("1", "2").record(), options), Error);
    options.executable = "/bin/false";
    CHECK_THROWS_WITH(drawn(a_matrix().above("1", "2").record(), options), Catch::Contains("status 1"));
}

TEST_CASE("A layout that needs more memory than allowed is an error with what to do") {
#if defined(__SANITIZE_ADDRESS__)
    // The sanitizer reserves terabytes of addresses, so the worker cannot limit them.
    WARN("SKIPPED under the address sanitizer: memory limits");
    SUCCEED();
    return;
#endif
    GraphvizOptions options;
    options.limits.megabytes = 1; // not even the program fits
    CHECK_THROWS_WITH(drawn(a_matrix().above("1", "2").record(), options), Catch::Contains("use the engine planum"));
}

TEST_CASE("A layout that takes too long is ended and said") {
    GraphvizOptions options;
    options.limits.seconds = 1;
    options.lines = GraphvizLines::Orthogonal;
    const model::Record record = test::a_trench({.units = 3000, .seed = 3, .width = 600, .layer_reach = 12});
    CHECK_THROWS_WITH(drawn(record, options), Catch::Contains("1 seconds"));
}

TEST_CASE("Stopping ends the layout process") {
    std::stop_source source;
    source.request_stop();
    Progress stopped(source.get_token());
    const model::Record record = a_matrix().above("1", "2").record();
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    CHECK_THROWS_AS(GraphvizEngine().draw({record, matrix, text, {}, {}}, stopped), Error);
}
