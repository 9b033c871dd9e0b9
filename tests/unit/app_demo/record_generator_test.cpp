// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/suspect_tally.hpp"

using namespace planum;
using app::MistakeKind;

TEST_CASE("The same options give the same record") {
    app::RecordOptions options;
    options.units = 120;
    const auto a = app::generate_record(options);
    const auto b = app::generate_record(options);
    CHECK(a.record.units == b.record.units);
    CHECK(a.record.relations == b.record.relations);
    CHECK(a.record.statements == b.record.statements);
    CHECK(a.record.levels == b.record.levels);
    CHECK(a.formed == b.formed);
    options.seed = 2;
    CHECK_FALSE(app::generate_record(options).record.relations == a.record.relations);
}

TEST_CASE("A generated record has no cycle, and every relation agrees with the truth") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        app::RecordOptions options;
        options.seed = seed;
        const auto g = app::generate_record(options);
        const auto matrix = strat::HarrisMatrix::build(g.record);
        CHECK(matrix.stats().cycle_groups == 0);
        CHECK(matrix.stats().self == 0);
        const model::RecordIndex index(g.record);
        for (const auto& r : g.record.relations) {
            if (model::time_meaning(r.kind) != model::TimeMeaning::SubjectLater) continue;
            CHECK(g.formed[index.find(r.subject)] > g.formed[index.find(r.object)]);
        }
    }
}

TEST_CASE("A generated record has the rates it was asked for") {
    app::RecordOptions options;
    options.units = 1000;
    for (const double rate : {1.6, 5.0}) {
        options.relations_per_unit = rate;
        const auto g = app::generate_record(options);
        const double units = static_cast<double>(g.record.units.size());
        CHECK(units == Approx(1000.0).margin(20.0));
        CHECK(static_cast<double>(g.record.relations.size()) / units == Approx(rate).epsilon(0.25));
    }
    options.relations_per_unit = 1.6;
    const auto g = app::generate_record(options);
    const auto stats = strat::HarrisMatrix::build(g.record).stats();
    CHECK(static_cast<double>(stats.redundant) / static_cast<double>(stats.reduced_from) == Approx(0.3).margin(0.1));
}

TEST_CASE("Numbers are unique and lie in the block of their area") {
    app::RecordOptions options;
    options.units = 600;
    options.same_as = 0.1;
    const auto g = app::generate_record(options);
    std::set<std::string> numbers;
    for (const auto& u : g.record.units) CHECK(numbers.insert(u.number).second);
    const auto matrix = strat::HarrisMatrix::build(g.record);
    CHECK(matrix.stats().same_as > 0);
    for (const auto& d : strat::check(g.record, matrix, {}, {}, Progress::none()).diagnostics) {
        CHECK(d.code != "number-outside-block");
        CHECK(d.code != "number-reused");
    }
}

TEST_CASE("A record smaller or larger than is meant is refused") {
    app::RecordOptions options;
    options.units = 10;
    CHECK_THROWS_AS(app::generate_record(options), Error);
    options.units = 30'000;
    CHECK_THROWS_AS(app::generate_record(options), Error);
}

TEST_CASE("A seeded mistake closes one cycle of the length asked for, and breaking it mends the record") {
    for (const MistakeKind kind : {MistakeKind::Reversed, MistakeKind::Transposed, MistakeKind::Mistyped}) {
        auto g = app::generate_record({});
        const auto mistake = app::seed_mistake(g, kind, {});
        REQUIRE(mistake);
        CHECK(mistake->cycle >= 6);
        const auto matrix = strat::HarrisMatrix::build(g.record);
        CHECK(matrix.stats().cycle_groups == 1);
        const auto wrong = std::find_if(g.record.relations.begin(), g.record.relations.end(),
                                        [&](const auto& r) { return r.id == mistake->relation; });
        REQUIRE(wrong != g.record.relations.end());
        const auto at = static_cast<strat::RelationIndex>(wrong - g.record.relations.begin());
        strat::MatrixOptions without;
        without.without = std::span(&at, 1);
        CHECK(strat::HarrisMatrix::build(g.record, without).stats().cycle_groups == 0);
    }
}

TEST_CASE("A number used twice and a wrong same-as close cycles, exchanged levels contradict") {
    auto twice = app::generate_record({});
    const auto units = twice.record.units.size();
    REQUIRE(app::seed_mistake(twice, MistakeKind::NumberUsedTwice, {}));
    CHECK(twice.record.units.size() == units - 1);
    CHECK(strat::HarrisMatrix::build(twice.record).stats().cycle_groups == 1);
    auto same = app::generate_record({});
    REQUIRE(app::seed_mistake(same, MistakeKind::WrongSameAs, {}));
    CHECK(strat::HarrisMatrix::build(same.record).stats().cycle_groups == 1);
    auto levels = app::generate_record({});
    CHECK(app::seed_mistake(levels, MistakeKind::SwappedLevels, {.least_cycle = 0}));
}

TEST_CASE("The wrong statement of a seeded cycle comes first mostly and among three nearly always") {
    test::SuspectTally all;
    for (const MistakeKind kind : {MistakeKind::Reversed, MistakeKind::Transposed, MistakeKind::Mistyped}) {
        all += test::measure_suspects({}, kind, 12);
    }
    CHECK(all.cases > 30);
    CHECK(all.share_first() >= 0.6);
    CHECK(all.share_three() >= 0.9);
}
