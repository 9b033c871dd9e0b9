// SPDX-License-Identifier: MIT
#include "app/drawing/former_places.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "strat/layout/planum_engine.hpp"
#include "strat/layout/svg_writer.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/layout_records.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

bool earlier(const strat::PreviousPosition& a, const strat::PreviousPosition& b) { return a.unit < b.unit; }

} // namespace

TEST_CASE("The places read back from an SVG are those of the drawing") {
    auto builder = test::a_matrix();
    builder.above("1", "2").above("2", "16/9 ö").above("1", "a--b").relate("2", model::RelationKind::SameAs, "7");
    builder.kind("16/9 ö", model::UnitKind::Cut).kind("a--b", model::UnitKind::Structure).unit("alone");
    const model::Record record = builder.record();
    strat::DrawingOptions options;
    options.unit_link = "#{unit}";
    const strat::MatrixDrawing drawing = test::drawing_of(record, options);
    const test::TemporaryFolder folder;
    const auto former = app::former_places(folder.write("former.svg", strat::write_svg(drawing)), record);
    const auto drawn = strat::places_of(drawing);
    auto read = former.units;
    auto real = drawn.units;
    REQUIRE(read.size() == real.size());
    REQUIRE(read.size() == 5);
    std::sort(read.begin(), read.end(), earlier);
    std::sort(real.begin(), real.end(), earlier);
    for (std::size_t i = 0; i < read.size(); ++i) {
        CHECK(read[i].unit == real[i].unit);
        CHECK(read[i].centre.x == Approx(real[i].centre.x).margin(0.011));
        CHECK(read[i].centre.y == Approx(real[i].centre.y).margin(0.011));
    }
    REQUIRE(former.lines.size() == drawn.lines.size());
    REQUIRE(former.lines.size() == 3);
    for (std::size_t i = 0; i < drawn.lines.size(); ++i) {
        CHECK(former.lines[i].later == drawn.lines[i].later);
        CHECK(former.lines[i].earlier == drawn.lines[i].earlier);
        REQUIRE(former.lines[i].points.size() == drawn.lines[i].points.size());
        for (std::size_t k = 0; k < drawn.lines[i].points.size(); ++k) {
            CHECK(former.lines[i].points[k].x == Approx(drawn.lines[i].points[k].x).margin(0.011));
            CHECK(former.lines[i].points[k].y == Approx(drawn.lines[i].points[k].y).margin(0.011));
        }
    }
}

TEST_CASE("By an SVG as by the drawing itself, the units keep their places when one is added") {
    const model::Record before = test::a_trench({.units = 120, .seed = 5});
    const strat::MatrixDrawing first = test::drawing_of(before);
    model::Record after = before;
    model::StratigraphicUnit unit;
    SeededUuids ids{99};
    unit.id = {ids.next()};
    unit.number = "900";
    after.units.push_back(unit);
    model::PhysicalRelation relation;
    relation.id = {ids.next()};
    relation.kind = model::RelationKind::Covers;
    relation.subject = unit.id;
    relation.object = before.units[60].id;
    after.relations.push_back(relation);
    model::sort_record(after);
    const test::TemporaryFolder folder;
    const auto places = app::former_places(folder.write("former.svg", strat::write_svg(first)), after);
    CHECK(strat::write_svg(test::drawing_of(after, {}, places)) ==
          strat::write_svg(test::drawing_of(after, {}, strat::places_of(first))));
}

TEST_CASE("What is no drawing of these units is refused") {
    const model::Record record = test::a_matrix().above("1", "2").record();
    const model::Record other = test::a_matrix().above("8", "9").record();
    const test::TemporaryFolder folder;
    const auto svg = strat::write_svg(test::drawing_of(other));
    CHECK_THROWS_WITH(app::former_places(folder.write("other.svg", svg), record), Catch::Contains("none of the units"));
    CHECK_THROWS_WITH(app::former_places(folder.write("x.svg", "no svg"), record), Catch::Contains("no SVG"));
    CHECK_THROWS_WITH(app::former_places(folder.write("x.html", "<html/>"), record), Catch::Contains("no SVG"));
    CHECK_THROWS_AS(app::former_places(folder.path() / "none.svg", record), Error);
}
