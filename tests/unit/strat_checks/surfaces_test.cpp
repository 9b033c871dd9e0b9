// SPDX-License-Identifier: MIT
#include <algorithm>
#include <variant>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/small_record.hpp"

using namespace planum;
using model::RelationKind;
using test::SmallRecord;

namespace {

model::SurfaceEvidence seen_above(SmallRecord& r, const char* upper, const char* lower) {
    model::SurfaceEvidence e;
    e.upper = r.unit(upper).id;
    e.lower = r.unit(lower).id;
    e.area = 1.2;
    e.thickness = 0.14;
    e.tolerance = 0.02;
    e.both_faces_own = true;
    return e;
}

std::vector<model::Diagnostic> contradictions(SmallRecord& r, const std::vector<model::SurfaceEvidence>& evidence,
                                              strat::CheckResult* whole = nullptr) {
    model::sort_record(r.record());
    const auto matrix = strat::HarrisMatrix::build(r.record());
    strat::CheckResult result = strat::check(r.record(), matrix, {}, evidence, Progress::none());
    if (whole != nullptr) *whole = result;
    std::erase_if(result.diagnostics, [](const auto& d) { return d.code != "height-contradiction"; });
    return result.diagnostics;
}

} // namespace

TEST_CASE("A relation whose opposite the surfaces show is an error, one that they show is confirmed") {
    SmallRecord r;
    r.covers("1", "2").covers("3", "2");
    strat::CheckResult whole;
    const auto said = contradictions(r, {seen_above(r, "2", "1"), seen_above(r, "3", "2")}, &whole);
    REQUIRE(said.size() == 1);
    CHECK(said[0].severity == model::Severity::Error);
    CHECK(said[0].relations.size() == 1);
    CHECK(std::get<double>(said[0].evidence.at("area_m2")) == Approx(1.2));
    CHECK(whole.coverage.contradicted == 1);
    CHECK(whole.coverage.confirmed == 1);
}

TEST_CASE("Levels, steep contacts, little area and faces that are not the units' own only warn") {
    SmallRecord r;
    r.covers("1", "2");
    auto levels = seen_above(r, "2", "1");
    levels.source = model::EvidenceSource::Levels;
    auto steep = seen_above(r, "2", "1");
    steep.contact_dip = 1.0;
    auto inside = seen_above(r, "2", "1");
    inside.both_faces_own = false;
    auto little = seen_above(r, "2", "1");
    little.area = 0.05;
    for (const auto& e : {levels, steep, inside, little}) {
        const auto said = contradictions(r, {e});
        REQUIRE(said.size() == 1);
        CHECK(said[0].severity == model::Severity::Warning);
    }
}

TEST_CASE("Specks, thin units, contrary cells and both directions contradict nothing") {
    SmallRecord r;
    r.covers("1", "2");
    auto small = seen_above(r, "2", "1");
    small.area = 0.015;
    auto thin = seen_above(r, "2", "1");
    thin.testable = false;
    auto mixed = seen_above(r, "2", "1");
    mixed.contrary_area = 0.5;
    for (const auto& e : {small, thin, mixed}) CHECK(contradictions(r, {e}).empty());
    CHECK(contradictions(r, {seen_above(r, "2", "1"), seen_above(r, "1", "2")}).empty());
}

TEST_CASE("Leaning, bonding and age alone are not held against heights") {
    for (const RelationKind kind : {RelationKind::Abuts, RelationKind::Later, RelationKind::BondsWith}) {
        SmallRecord r;
        r.relate("1", kind, "2");
        CHECK(contradictions(r, {seen_above(r, "2", "1")}).empty());
    }
}

TEST_CASE("A cut said to fill what lay above it is contradicted also where the surfaces only ask") {
    SmallRecord r;
    r.unit("1").kind = model::UnitKind::Cut;
    r.unit("2").kind = model::UnitKind::Deposit;
    r.relate("1", RelationKind::Fills, "2");
    auto asked = seen_above(r, "2", "1");
    asked.area = 0.018; // a proposal takes no more
    asked.testable = false;
    asked.below_is_bare_cut = true;
    strat::CheckResult whole;
    const auto said = contradictions(r, {asked}, &whole);
    REQUIRE(said.size() == 1);
    CHECK(said[0].severity == model::Severity::Warning);
    CHECK_THAT(said[0].message, Catch::StartsWith("1 fills 2, but over 0.02 m² the bare cut 1 came out where 2 had "
                                                  "been, 0.14 m lower: 2 fills 1, or 1 cuts 2 from beside"));
    CHECK(whole.coverage.contradicted == 0); // a question is no evidence
    auto thin = asked;
    thin.thickness = 0.01;
    CHECK(contradictions(r, {thin}).empty());
    CHECK(contradictions(r, {asked, seen_above(r, "1", "2")}).empty()); // both ways round
}

TEST_CASE("What surfaces only ask contradicts nothing that may be") {
    for (const RelationKind kind : {RelationKind::Cuts, RelationKind::Covers, RelationKind::Fills}) {
        SmallRecord r;
        r.unit("1").kind = kind == RelationKind::Fills ? model::UnitKind::Deposit : model::UnitKind::Cut;
        r.unit("2").kind = kind == RelationKind::Fills ? model::UnitKind::Cut : model::UnitKind::Deposit;
        r.relate("1", kind, "2");
        auto asked = seen_above(r, "2", "1");
        asked.testable = false;
        asked.below_is_bare_cut = true;
        CHECK(contradictions(r, {asked}).empty());
    }
}

TEST_CASE("A pair stated as two kinds is one mistake") {
    SmallRecord r;
    r.covers("1", "2").relate("1", RelationKind::Cuts, "2");
    CHECK(contradictions(r, {seen_above(r, "2", "1")}).size() == 1);
}

TEST_CASE("Surfaces say which relation of a circle to doubt") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3").covers("3", "4").covers("4", "1");
    strat::CheckResult whole;
    static_cast<void>(
        contradictions(r, {seen_above(r, "1", "2"), seen_above(r, "3", "2"), seen_above(r, "3", "4")}, &whole));
    const auto cycle = std::find_if(whole.diagnostics.begin(), whole.diagnostics.end(),
                                    [](const auto& d) { return d.code == "cycle"; });
    REQUIRE(cycle != whole.diagnostics.end());
    REQUIRE_FALSE(cycle->suspects.empty());
    const auto* suspect = std::get_if<model::SuspectRelation>(&cycle->suspects.front().what);
    REQUIRE(suspect != nullptr);
    CHECK(suspect->relation.unit == r.unit("2").id);
    CHECK(suspect->relation.other == r.unit("3").id);
}
