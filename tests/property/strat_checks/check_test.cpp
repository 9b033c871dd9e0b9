// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <rapidcheck.h>

#include "strat/checks/incremental.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/small_record.hpp"

using namespace planum;
using model::RelationKind;

namespace {

struct Stated {
    int subject;
    RelationKind kind;
    int object;
};

std::vector<Stated> any_relations(int units, std::size_t most) {
    std::vector<Stated> stated;
    const auto n = *rc::gen::inRange<std::size_t>(1, most + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const auto kind = *rc::gen::element(RelationKind::Covers, RelationKind::Cuts, RelationKind::Fills,
                                            RelationKind::Abuts, RelationKind::SameAs, RelationKind::Contemporary);
        int subject = *rc::gen::inRange(1, units + 1);
        int object = *rc::gen::inRange(1, units + 1);
        if (model::is_symmetric(kind)) {
            if (subject == object) continue;
            if (subject > object) std::swap(subject, object);
        }
        const bool known = std::any_of(stated.begin(), stated.end(), [&](const Stated& s) {
            return s.subject == subject && s.kind == kind && s.object == object;
        });
        if (!known) stated.push_back({subject, kind, object});
    }
    return stated;
}

test::SmallRecord record_of(const std::vector<Stated>& stated, int units) {
    test::SmallRecord r;
    for (int u = 1; u <= units; ++u) r.unit(std::to_string(u)).excavated_on = "2024-06-" + std::to_string(10 + u);
    for (const Stated& s : stated) r.relate(std::to_string(s.subject), s.kind, std::to_string(s.object));
    return r;
}

// Everything a reader of the result sees, without uuids.
std::vector<std::string> shown(test::SmallRecord& r) {
    std::vector<std::string> lines;
    for (const model::Diagnostic& d : r.check().diagnostics) {
        std::string line = d.id + " " + d.code + " " + d.message + " " + d.evidence_hash;
        for (const model::Suspect& s : d.suspects)
            line += " " + std::to_string(s.score) + (s.reasons.empty() ? "" : s.reasons.front());
        lines.push_back(line);
    }
    return lines;
}

} // namespace

TEST_CASE("The order in which relations come in changes nothing that is said") {
    CHECK(rc::check([] {
        constexpr int kUnits = 9;
        std::vector<Stated> stated = any_relations(kUnits, 16);
        test::SmallRecord one = record_of(stated, kUnits);
        const auto turn = *rc::gen::inRange<std::size_t>(0, stated.size() + 1);
        std::rotate(stated.begin(), stated.begin() + static_cast<std::ptrdiff_t>(turn), stated.end());
        std::reverse(stated.begin(), stated.end());
        test::SmallRecord other = record_of(stated, kUnits);
        RC_ASSERT(shown(one) == shown(other));
    }));
}

TEST_CASE("A relation added against the order is always found, before and after it is added") {
    CHECK(rc::check([] {
        constexpr int kUnits = 10;
        test::SmallRecord r;
        for (int u = 1; u <= kUnits; ++u) r.unit(std::to_string(u));
        const auto n = *rc::gen::inRange(1, 20);
        for (int i = 0; i < n; ++i) {
            const int a = *rc::gen::inRange(1, kUnits);
            const int b = *rc::gen::inRange(a + 1, kUnits + 1);
            r.covers(std::to_string(a), std::to_string(b));
        }
        model::sort_record(r.record());
        const auto matrix = strat::HarrisMatrix::build(r.record());
        const auto later = static_cast<strat::UnitIndex>(*rc::gen::inRange(0, kUnits));
        const auto earlier = static_cast<strat::UnitIndex>(*rc::gen::inRange(0, kUnits));
        RC_PRE(later != earlier);
        const auto told = strat::predict(matrix, {earlier, RelationKind::Covers, later});
        const bool ordered = matrix.is_later(later, earlier);
        RC_ASSERT((told.consequence == strat::Consequence::ClosesCycle) == ordered);
        if (ordered) {
            RC_ASSERT(matrix.orders()[told.path.front()].later == later);
            RC_ASSERT(matrix.orders()[told.path.back()].earlier == earlier);
        }
        r.covers(r.record().units[earlier].number, r.record().units[later].number);
        RC_ASSERT(r.said("cycle").empty() != ordered);
    }));
}

TEST_CASE("Every cycle group has one diagnostic, and its first suspects break it") {
    CHECK(rc::check([] {
        constexpr int kUnits = 8;
        test::SmallRecord r = record_of(any_relations(kUnits, 18), kUnits);
        model::sort_record(r.record());
        const auto matrix = strat::HarrisMatrix::build(r.record());
        std::size_t groups = 0;
        for (const model::Diagnostic& d : r.check().diagnostics) {
            if (d.code != "cycle" && !(d.code == "cycle-by-same-as" && d.evidence.contains("removals"))) continue;
            ++groups;
            RC_ASSERT(!d.suspects.empty());
            double sum = 0.0;
            for (const model::Suspect& s : d.suspects) sum += s.score;
            RC_ASSERT(sum < 1.0 + 1e-9);
        }
        RC_ASSERT(groups == matrix.cycle_groups().size());
    }));
}
