// SPDX-License-Identifier: MIT
#include "strat/layout/drawing_evidence.hpp"

#include <algorithm>

#include "strat/layout/drawing_colours.hpp"
#include "strat/layout/drawing_style.hpp"
#include "strat/layout/drawn_graph.hpp"
#include "strat/layout/planum_engine.hpp"
#include "strat/layout/svg_writer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using namespace planum::strat;
using model::EvidenceVerdict;
using planum::test::a_matrix;

namespace {

// 1 over 2 over 3: two lines.
MatrixDrawing drawn() {
    const model::Record record =
        a_matrix().relate("1", model::RelationKind::Covers, "2").relate("2", model::RelationKind::Covers, "3").record();
    const HarrisMatrix matrix = HarrisMatrix::build(record);
    const TableTextMeasure text;
    return PlanumEngine().draw({record, matrix, text, {}, {}}, Progress::none());
}

} // namespace

TEST_CASE("Lines of a drawing say what the evidence says, and the key what that means") {
    MatrixDrawing drawing = drawn();
    REQUIRE(drawing.lines.size() == 2);
    const double height = drawing.height;
    const std::size_t texts = drawing.texts.size();
    show_evidence(drawing, {EvidenceVerdict::Confirmed, EvidenceVerdict::Contradicted}, {}, TableTextMeasure());
    CHECK(style_of(drawing.lines[0]).colour == style_of(EvidenceVerdict::Confirmed).colour);
    CHECK(style_of(drawing.lines[1]).dash == Dash::Dashed);
    CHECK(drawing.height > height);
    REQUIRE(drawing.texts.size() == texts + 2); // nothing is untestable here
    for (std::size_t i = texts; i < drawing.texts.size(); ++i) {
        const DrawnText& said = drawing.texts[i];
        CHECK(said.at.y > height - style::kPageMargin); // below all that was there
        CHECK(said.at.y < drawing.height);
        CHECK(said.at.x + said.width <= drawing.width);
    }
    const std::string svg = write_svg(drawing);
    CHECK_THAT(svg, Catch::Contains(">contradicted<"));
    CHECK_THAT(svg, Catch::Contains("#1b7f4b"));
}

TEST_CASE("Verdicts of other lines change nothing of a drawing") {
    MatrixDrawing drawing = drawn();
    const std::string before = write_svg(drawing);
    show_evidence(drawing, {EvidenceVerdict::Confirmed}, {}, TableTextMeasure());
    CHECK(write_svg(drawing) == before);
}
