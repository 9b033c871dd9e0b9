// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>

#include "app/demo/random.hpp"
#include "app/demo/record_generator.hpp"
#include "core/base/uuid.hpp"
#include "strat/checks/check.hpp"
#include "strat/checks/incremental.hpp"
#include "tests/support/catch.hpp"

// Times on generated records of the largest size. Limits are three times what is asked for on two quiet
// cores, so that a busy machine does not fail a build; the figures are printed.

namespace {

using namespace planum;

double seconds_of(const auto& work) {
    const std::clock_t start = std::clock(); // of the processor: other programs do not count
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double check_seconds(const model::Record& record, const char* what) {
    const auto matrix = strat::HarrisMatrix::build(record);
    std::size_t said = 0;
    const double seconds =
        seconds_of([&] { said = strat::check(record, matrix, {}, {}, Progress::none()).diagnostics.size(); });
    const auto& s = matrix.stats();
    std::printf("%-28s %6lld units %7zu relations %5lld groups, largest %6lld: %6.3f s, %zu diagnostics\n", what,
                static_cast<long long>(s.units), record.relations.size(), static_cast<long long>(s.cycle_groups),
                static_cast<long long>(s.largest_cycle_group), seconds, said);
    return seconds;
}

void add(model::Record& record, std::uint64_t id, std::size_t later, std::size_t earlier) {
    model::PhysicalRelation r;
    r.id = model::RelationId{Uuid{~0ULL, id}};
    r.subject = record.units[later].id;
    r.object = record.units[earlier].id;
    record.relations.push_back(r);
    model::RelationStatement s;
    s.id = model::StatementId{Uuid{~0ULL, id}};
    s.relation = r.id;
    s.source = record.sources.front().id;
    record.statements.push_back(s);
}

app::GeneratedRecord large() {
    app::RecordOptions options;
    options.units = 20'000;
    options.relations_per_unit = 5.0;
    return app::generate_record(options);
}

} // namespace

TEST_CASE("Checks of 20,000 units take tenths of a second without cycles") {
    const app::GeneratedRecord clean = large();
    CHECK(check_seconds(clean.record, "no cycle") < 0.45);
}

TEST_CASE("Checks of 20,000 units take seconds with large or many cycle groups") {
    const app::GeneratedRecord clean = large();

    model::Record ring = clean.record; // one chain through half of the units, closed at its end
    for (std::size_t i = 0; i + 1 < 10'000; ++i) add(ring, i, i, i + 1);
    add(ring, 10'000, 9'999, 0);
    model::sort_record(ring);
    CHECK(check_seconds(ring, "one ring of 10,000") < 12.0);

    for (const std::size_t arcs : {40U, 60U, 100U}) {
        model::Record groups = clean.record; // twenty units drawn together at random, two hundred times
        app::Random random(arcs);
        groups.relations.clear();
        groups.statements.clear();
        for (std::size_t g = 0; g < 200; ++g) {
            for (std::size_t i = 0; i < 20; ++i) add(groups, g * 1000 + i, g * 20 + i, g * 20 + (i + 1) % 20);
            for (std::size_t i = 20; i < arcs; ++i) {
                const std::size_t a = random.below(20);
                const std::size_t b = random.below(20);
                if (a != b) add(groups, g * 1000 + i, g * 20 + a, g * 20 + b);
            }
        }
        model::sort_record(groups);
        CHECK(check_seconds(groups, ("200 groups of 20, " + std::to_string(arcs) + " arcs").c_str()) < 12.0);
    }
}

TEST_CASE("Adding one relation to 20,000 units is judged within ten milliseconds") {
    const app::GeneratedRecord clean = large();
    const auto matrix = strat::HarrisMatrix::build(clean.record);
    app::Random random(7);
    double worst = 0.0;
    int closing = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto a = static_cast<strat::UnitIndex>(random.below(clean.record.units.size()));
        // Half of the pairs lie in one trench, where paths are.
        const auto b = static_cast<strat::UnitIndex>(
            i % 2 == 0 ? random.below(clean.record.units.size())
                       : std::min<std::size_t>(a + random.below(100), clean.record.units.size() - 1));
        strat::Prediction prediction;
        worst = std::max(worst, seconds_of([&] {
                             prediction = strat::predict(matrix, {a, model::RelationKind::Covers, b});
                         }));
        closing += prediction.consequence == strat::Consequence::ClosesCycle ? 1 : 0;
    }
    std::printf("one relation: at most %.3f ms, %d of 2000 close a cycle\n", 1000.0 * worst, closing);
    CHECK(worst < 0.03);
    CHECK(closing > 0);
}
