// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include "tests/support/catch.hpp"
#include "tests/support/suspect_tally.hpp"

// How often the wrong statement stands where among the suspects, printed for docs/checks.md.

using namespace planum;
using app::MistakeKind;

namespace {

struct NamedKind {
    MistakeKind kind;
    const char* name;
};

constexpr std::array kStatements = {NamedKind{MistakeKind::Reversed, "reversed"},
                                    NamedKind{MistakeKind::Transposed, "transposed"},
                                    NamedKind{MistakeKind::Mistyped, "mistyped"}};
constexpr std::size_t kRecords = 150;

void print(const char* record, const char* mistake, const test::SuspectTally& t) {
    std::printf("%-22s %-12s %4d cycles  first %5.1f %%  first three %5.1f %%  cannot tell %d\n", record, mistake,
                t.cases, 100.0 * t.share_first(), 100.0 * t.share_three(), t.cannot_tell);
}

test::SuspectTally all_of(const char* name, const app::RecordOptions& options, std::size_t least_cycle) {
    test::SuspectTally all;
    for (const NamedKind& kind : kStatements) {
        const auto t = test::measure_suspects(options, kind.kind, kRecords, least_cycle);
        print(name, kind.name, t);
        all += t;
    }
    print(name, "all", all);
    return all;
}

} // namespace

TEST_CASE("The wrong statement of a seeded cycle is first in 60 % and among the first three in 90 %") {
    const auto all = all_of("ordinary", {}, 6);
    CHECK(all.share_first() >= 0.6);
    CHECK(all.share_three() >= 0.9);
}

TEST_CASE("So it is in records that state each relation on one sheet only") {
    app::RecordOptions options;
    options.both_sheets = 0.0;
    const auto all = all_of("one sheet", options, 6);
    CHECK(all.share_first() >= 0.6);
    CHECK(all.share_three() >= 0.9);
}

TEST_CASE("Relations and numbers alone still put it among the first three most of the time") {
    app::RecordOptions options;
    options.both_sheets = 0.0;
    options.levelled = options.dug_dates = options.phased = options.dated = 0.0;
    CHECK(all_of("relations only", options, 6).share_three() >= 0.7);
    options.number_blur = 1000.0; // numbers without any order
    options.unknown_kind = 1.0;
    const auto nothing = all_of("nothing else known", options, 6);
    CHECK(nothing.share_three() >= 0.2);
    CHECK(nothing.cannot_tell > 0);
}

TEST_CASE("Shorter cycles and a reversal that the other sheet contradicts are measured too") {
    CHECK(all_of("cycles of two and more", {}, 2).share_three() >= 0.9);
}

TEST_CASE("A wrong same_as is named") {
    app::RecordOptions options;
    const auto t = test::measure_suspects(options, MistakeKind::WrongSameAs, kRecords, 5);
    print("ordinary", "wrong same_as", t);
    CHECK(t.share_three() >= 0.9);
}
