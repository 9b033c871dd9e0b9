// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <map>

#include "tests/support/catch.hpp"
#include "tests/support/drawing_laws.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;

TEST_CASE("Ten thousand random matrices, drawn and read back, are their reduced matrices") {
    for (std::uint32_t seed = 1; seed <= 10'000; ++seed) {
        test::RandomMatrixOptions options;
        options.seed = seed;
        options.units = 2 + seed % 60;
        options.relations = options.units * (1 + seed % 5);
        options.cycles = seed % 3 == 0;
        options.contemporaries = seed % 5 == 0;
        options.same_as = seed % 7 == 0;
        options.uncertain = seed % 4 == 0;
        options.phases = seed % 11 == 0 ? 5 : 0;
        const model::Record record = test::a_random_record(options);
        INFO("seed " << seed);
        REQUIRE(test::broken_law(record, test::drawing_of(record)) == "");
    }
}

TEST_CASE("Large trenches, drawn and read back, are their reduced matrices") {
    for (const std::size_t units : {700U, 2000U, 4000U}) {
        const model::Record record =
            test::a_trench({.units = units, .seed = 11, .width = units / 10, .layer_reach = 8});
        INFO(units << " units");
        REQUIRE(test::broken_law(record, test::drawing_of(record)) == "");
    }
}

namespace {

// Of the boxes that had a neighbour on their level, how many still stand between the same two.
double kept_share(const strat::MatrixDrawing& before, const strat::MatrixDrawing& after) {
    std::map<std::string, double> now;
    for (const strat::DrawnBox& b : after.boxes) now[b.id] = b.rect.centre().x;
    std::map<double, std::vector<const strat::DrawnBox*>> rows;
    for (const strat::DrawnBox& b : before.boxes) {
        if (!b.isolated) rows[b.rect.centre().y].push_back(&b);
    }
    std::size_t boxes = 0;
    std::size_t kept = 0;
    for (auto& [y, row] : rows) {
        std::sort(row.begin(), row.end(), [](const auto* a, const auto* b) { return a->rect.x < b->rect.x; });
        for (std::size_t i = 0; i < row.size() && row.size() > 1; ++i) {
            const double x = now.at(row[i]->id);
            ++boxes;
            const bool left = i == 0 || now.at(row[i - 1]->id) < x;
            const bool right = i + 1 == row.size() || now.at(row[i + 1]->id) > x;
            if (left && right) ++kept;
        }
    }
    return static_cast<double>(kept) / static_cast<double>(boxes);
}

} // namespace

TEST_CASE("One unit added to seven hundred leaves nineteen of twenty others between their neighbours") {
    const model::Record record = test::a_trench({.units = 700, .seed = 5, .width = 78, .layer_reach = 8});
    const strat::MatrixDrawing before = test::drawing_of(record);
    const strat::PreviousDrawing places = strat::places_of(before);
    const strat::HarrisMatrix matrix = strat::HarrisMatrix::build(record);
    double sum = 0.0;
    double worst = 1.0;
    constexpr std::uint32_t kTries = 40;
    for (std::uint32_t i = 0; i < kTries; ++i) {
        // Half of them slipped between two units, half of them below one.
        const strat::Order order = matrix.orders()[matrix.reduced()[(i * 23) % matrix.reduced().size()]];
        model::Record more = record;
        SeededUuids ids(1000 + i);
        model::StratigraphicUnit unit;
        unit.id = {ids.next()};
        unit.number = "9000";
        more.units.push_back(unit);
        const auto relate = [&](model::UnitId later, model::UnitId earlier) {
            model::PhysicalRelation relation;
            relation.id = {ids.next()};
            relation.subject = later;
            relation.object = earlier;
            more.relations.push_back(relation);
        };
        relate(record.units[matrix.members(order.later).front()].id, unit.id);
        if (i % 2 == 0) relate(unit.id, record.units[matrix.members(order.earlier).front()].id);
        model::sort_record(more);
        const strat::MatrixDrawing after = test::drawing_of(more, {}, places);
        REQUIRE(test::broken_law(more, after) == "");
        const double share = kept_share(before, after);
        sum += share;
        worst = std::min(worst, share);
    }
    std::printf("kept between their neighbours: mean %.4f, worst of %u %.4f\n", sum / kTries, kTries, worst);
    CHECK(worst >= 0.95);
}

TEST_CASE("Ten thousand groupings get frames that hold their own boxes and nobody else's") {
    for (std::uint32_t seed = 1; seed <= 10'000; ++seed) {
        test::RandomMatrixOptions options;
        options.seed = seed;
        options.units = 2 + seed % 50;
        options.relations = options.units * (1 + seed % 3);
        options.cycles = seed % 3 == 0;
        options.same_as = seed % 7 == 0;
        options.phases = seed % 4 == 0 ? 4 : 0;
        options.groups = 1 + seed % 6;
        const model::Record record = test::a_random_record(options);
        strat::DrawingOptions drawing_options;
        drawing_options.frames = strat::Frames::Groups;
        const strat::MatrixDrawing drawing = test::drawing_of(record, drawing_options);
        INFO("seed " << seed);
        REQUIRE(test::broken_law(record, drawing) == "");
        REQUIRE(test::broken_frame(record, drawing) == "");
    }
}
