// SPDX-License-Identifier: MIT
#include "app/drawing/compare_readings.hpp"

#include <algorithm>

#include "strat/layout/planum_engine.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using strat::Mark;

namespace {

Mark mark_of(const app::Comparison& comparison, model::UnitId unit) {
    for (const strat::UnitMark& m : comparison.units) {
        if (m.unit == unit) return m.mark;
    }
    return Mark::None;
}

Mark mark_of(const app::Comparison& comparison, model::UnitId later, model::UnitId earlier) {
    for (const strat::OrderMark& m : comparison.orders) {
        if (m.later == later && m.earlier == earlier) return m.mark;
    }
    return Mark::None;
}

} // namespace

TEST_CASE("Two readings differ in what came, what went and what became something else") {
    auto builder = test::a_matrix();
    builder.above("1", "2").above("2", "3").above("3", "4").above("5", "6");
    const model::Record before = builder.record();
    builder.above("7", "1"); // a new unit
    builder.raw().relations[1].certainty = model::Certainty::Uncertain;
    std::erase_if(builder.raw().relations, [&](const auto& r) { return r.subject == builder.id("3"); });
    const model::Record after = builder.record();
    const app::Comparison comparison = app::compare_readings(before, after);
    CHECK(mark_of(comparison, builder.id("7")) == Mark::Added);
    CHECK(mark_of(comparison, builder.id("1")) == Mark::Changed);
    CHECK(mark_of(comparison, builder.id("4")) == Mark::Changed);
    CHECK(mark_of(comparison, builder.id("5")) == Mark::None);
    CHECK(mark_of(comparison, builder.id("7"), builder.id("1")) == Mark::Added);
    CHECK(mark_of(comparison, builder.id("2"), builder.id("3")) == Mark::Changed);
    CHECK(mark_of(comparison, builder.id("3"), builder.id("4")) == Mark::Removed);
    CHECK(mark_of(comparison, builder.id("1"), builder.id("2")) == Mark::None);
    CHECK(comparison.both.relations.size() == 5);
    CHECK(app::compare_readings(after, after).units.empty());
}

TEST_CASE("A same-as that a reading gave up contradicts nothing in the comparison") {
    auto builder = test::a_matrix();
    builder.above("2", "1").above("3", "2").relate("1", model::RelationKind::SameAs, "2");
    const model::Record before = builder.record();
    builder.raw().relations.pop_back();
    const model::Record after = builder.record();
    for (const bool given_up : {true, false}) {
        const app::Comparison comparison =
            given_up ? app::compare_readings(before, after) : app::compare_readings(after, before);
        const strat::HarrisMatrix matrix = strat::HarrisMatrix::build(comparison.both);
        strat::DrawingOptions options;
        options.marks = comparison.units;
        options.order_marks = comparison.orders;
        const strat::TableTextMeasure text;
        const strat::MatrixDrawing drawing =
            strat::PlanumEngine().draw({comparison.both, matrix, text, options, {}}, Progress::none());
        CHECK(drawing.boxes.front().inner_cycle == !given_up);
    }
}

TEST_CASE("A relation turned round is no cycle in a comparison, but a cycle of the reading stays one") {
    auto builder = test::a_matrix();
    builder.above("1", "2").above("3", "4").above("4", "3");
    const model::Record before = builder.record();
    std::swap(builder.raw().relations[0].subject, builder.raw().relations[0].object);
    const model::Record after = builder.record();
    const app::Comparison comparison = app::compare_readings(before, after);
    const strat::HarrisMatrix matrix = strat::HarrisMatrix::build(comparison.both);
    strat::DrawingOptions options;
    options.marks = comparison.units;
    options.order_marks = comparison.orders;
    const strat::TableTextMeasure text;
    const strat::MatrixDrawing drawing =
        strat::PlanumEngine().draw({comparison.both, matrix, text, options, {}}, Progress::none());
    REQUIRE(drawing.lines.size() == 4);
    for (const strat::DrawnLine& line : drawing.lines) {
        const bool turned =
            drawing.boxes[line.later].names.front() == "1" || drawing.boxes[line.later].names.front() == "2";
        CHECK(line.in_cycle == !turned);
        if (turned) CHECK(line.mark != Mark::None);
    }
    CHECK(std::count_if(drawing.boxes.begin(), drawing.boxes.end(), [](const auto& b) { return b.in_cycle; }) == 2);
}
