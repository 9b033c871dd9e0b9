// SPDX-License-Identifier: MIT
#include <variant>

#include "strat/checks/decisions.hpp"
#include "strat/checks/incremental.hpp"
#include "strat/checks/today.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/small_record.hpp"

using namespace planum;
using model::RelationKind;
using test::SmallRecord;
using Names = std::vector<std::string>;
using Sides = SmallRecord::Sides;

namespace {

std::string text(const SmallRecord& r, const model::NamedRelation& relation) {
    return r.name(relation.unit) + ">" + r.name(relation.other);
}

// `1>2` for a relation, `1=2` for same_as, `1>2:3` for a number that should be 3, `unit 4`.
std::string text(const SmallRecord& r, const model::Suspect& suspect) {
    struct Visitor {
        const SmallRecord& r;

        std::string operator()(const model::SuspectRelation& s) const { return text(r, s.relation); }

        std::string operator()(const model::SuspectSameAs& s) const {
            return r.name(s.same_as.unit) + "=" + r.name(s.same_as.other);
        }

        std::string operator()(const model::SuspectNumber& s) const { return text(r, s.relation) + ":" + s.probably; }

        std::string operator()(const model::SuspectUnit& s) const { return "unit " + r.name(s.unit); }
    };

    return std::visit(Visitor{r}, suspect.what);
}

std::int64_t number(const model::Diagnostic& d, const std::string& key) {
    return std::get<std::int64_t>(d.evidence.at(key));
}

// 1 over 2 over … over n.
SmallRecord chain(int n) {
    SmallRecord r;
    for (int i = 1; i < n; ++i) r.covers(std::to_string(i), std::to_string(i + 1));
    return r;
}

} // namespace

TEST_CASE("A cycle is a diagnostic that names its units, not an exception") {
    SmallRecord r = chain(6);
    r.covers("6", "1", Sides::Subject);
    const auto said = r.said("cycle");
    REQUIRE(said.size() == 1);
    CHECK(said[0].units.size() == 6);
    CHECK(said[0].relations.size() == 6);
    CHECK(number(said[0], "removals") == 1);
}

TEST_CASE("In a cycle the relation that stands on one sheet only is doubted first") {
    SmallRecord r = chain(6);
    for (int i = 10; i < 20; ++i) r.covers(std::to_string(i), std::to_string(i + 1));
    r.covers("6", "1", Sides::Subject);
    const auto said = r.said("cycle");
    REQUIRE(said.size() == 1);
    CHECK(text(r, said[0].suspects.front()) == "6>1");
    CHECK(number(said[0], "cannot_tell") == 0);
}

TEST_CASE("Where nothing distinguishes the relations of a cycle it says so") {
    SmallRecord r;
    r.covers("a", "b").covers("b", "c").covers("c", "a");
    const auto said = r.said("cycle");
    REQUIRE(said.size() == 1);
    CHECK(number(said[0], "cannot_tell") == 1);
    CHECK(said[0].suspects.size() == 3);
    CHECK(said[0].message.find("nothing in the record tells") != std::string::npos);
}

TEST_CASE("A relation that two paths agree with is not the one to doubt") {
    // 2>1 closes two circles, 1>2 by way of a and by way of b.
    SmallRecord r;
    r.covers("1", "a").covers("a", "2").covers("1", "b").covers("b", "2").covers("2", "1");
    const auto said = r.said("cycle");
    REQUIRE(said.size() == 1);
    CHECK(text(r, said[0].suspects.front()) == "2>1");
    CHECK(number(said[0], "cannot_tell") == 0);
}

TEST_CASE("The sample with a self relation, a pair and a group of five names all three") {
    // The structure of a published test list: 6 below itself, 3 and 5 each below the other.
    SmallRecord r;
    r.covers("+", "1").covers("1", "2").covers("2", "3").covers("3", "1").covers("3", "4").covers("4", "5");
    r.covers("5", "1").covers("5", "3").covers("3", "5").covers("5", "6").covers("6", "6");
    CHECK(r.said("self-relation").size() == 1);
    const auto pairs = r.said("contradicting-pair");
    REQUIRE(pairs.size() == 1);
    CHECK(r.names(pairs[0].units) == Names{"3", "5"});
    const auto cycles = r.said("cycle");
    REQUIRE(cycles.size() == 1);
    CHECK(r.names(cycles[0].units) == Names{"1", "2", "3", "4", "5"});
    CHECK(number(cycles[0], "removals") <= 2);
}

TEST_CASE("A circle that only same-as makes names the same-as, correlations first") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3").covers("4", "5").covers("5", "6");
    r.relate("3", RelationKind::SameAs, "4").relate("1", RelationKind::SameAs, "6");
    r.record().relations.back().correlation = true;
    CHECK(r.said("cycle").empty());
    const auto said = r.said("cycle-by-same-as");
    REQUIRE(said.size() == 1);
    CHECK(said[0].units.size() == 6);
    CHECK(text(r, said[0].suspects.front()) == "1=6");
    CHECK(text(r, said[0].suspects[1]) == "3=4");
    // Two same-as hold the circle together, and whatever unit it is begun at, both are said.
    const std::string circle = std::get<std::string>(said[0].evidence.at("cycle_1"));
    CHECK(circle.find("3 is the same as 4") != std::string::npos);
    CHECK(circle.find("6 is the same as 1") != std::string::npos);
}

TEST_CASE("A statement from one sheet is compared with most relations only where most stand on both") {
    const auto reasons_say = [](std::size_t on_both, std::string_view what) {
        SmallRecord r;
        for (std::size_t i = 0; i < 20; ++i) {
            r.covers(std::to_string(100 + i), std::to_string(101 + i),
                     i < on_both ? SmallRecord::Sides::Both : SmallRecord::Sides::Subject);
        }
        r.covers("1", "2").covers("2", "3").covers("3", "1", SmallRecord::Sides::Subject);
        const auto said = r.said("cycle");
        for (const model::Suspect& suspect : said.at(0).suspects) {
            for (const std::string& reason : suspect.reasons) {
                if (reason == what) return true;
            }
        }
        return false;
    };
    const std::string_view often = "only one of the two sheets states it, where most relations stand on both";
    const std::string_view plain = "only one of the two sheets states it";
    CHECK(reasons_say(16, often));
    CHECK_FALSE(reasons_say(4, often));
    CHECK(reasons_say(4, plain));
}

TEST_CASE("A unit above one that it is the same as is named as made by same-as") {
    SmallRecord r;
    r.covers("1", "2").relate("1", RelationKind::SameAs, "2");
    const auto said = r.said("cycle-by-same-as");
    REQUIRE(said.size() == 1);
    CHECK(r.names(said[0].units) == Names{"1", "2"});
    CHECK(said[0].suspects.size() == 2);
}

TEST_CASE("A number one slip away whose sheet states the relation is named as the one meant") {
    SmallRecord r;
    r.covers("100", "101").covers("101", "102").covers("102", "103").covers("103", "104").covers("104", "121");
    for (int i = 200; i < 215; ++i) r.covers(std::to_string(i), std::to_string(i + 1));
    // The sheet of 121 names 100 instead of 110 as what it covers; the sheet of 110 says it right.
    r.covers("121", "110", Sides::Object).covers("121", "100", Sides::Subject);
    const auto said = r.said("cycle");
    REQUIRE(said.size() == 1);
    CHECK(text(r, said[0].suspects.front()) == "121>100:110");
}

TEST_CASE("A unit through which all circles pass is probably two") {
    SmallRecord r;
    r.covers("1", "x").covers("x", "2").covers("2", "1");
    r.covers("3", "x").covers("x", "4").covers("4", "3");
    r.covers("5", "x").covers("x", "6").covers("6", "5");
    const auto said = r.said("cycle");
    REQUIRE(said.size() == 1);
    CHECK(text(r, said[0].suspects.front()) == "unit x");
}

TEST_CASE("Ids survive another import: they are made of names, not of uuids") {
    SmallRecord a = chain(4);
    a.covers("4", "1");
    SmallRecord b;
    b.covers("4", "1").covers("3", "4").covers("2", "3").covers("1", "2");
    REQUIRE(a.said("cycle").size() == 1);
    REQUIRE(b.said("cycle").size() == 1);
    CHECK(a.said("cycle")[0].id == b.said("cycle")[0].id);
    CHECK(a.said("cycle")[0].id.size() == 12);
}

TEST_CASE("An accepted diagnostic stays silent until its evidence changes sign or its area grows by half") {
    model::Diagnostic d;
    d.id = "abc";
    d.evidence_hash = "h1";
    d.evidence["area_m2"] = 2.0;
    model::Decision decision = strat::accept(d, "looked at it");
    decision.made_at = "2025-06-01";
    CHECK(strat::review({d}, std::vector{decision})[0].accepted);
    d.evidence["area_m2"] = 2.9;
    CHECK(strat::review({d}, std::vector{decision})[0].accepted);
    d.evidence["area_m2"] = 3.1;
    CHECK(strat::review({d}, std::vector{decision})[0].reopened);
    d.evidence["area_m2"] = 2.0;
    d.evidence_hash = "h2";
    CHECK(strat::review({d}, std::vector{decision})[0].reopened);
}

TEST_CASE("After a sign-off only what came since is new") {
    model::Diagnostic old;
    old.id = "old";
    model::Diagnostic fresh;
    fresh.id = "fresh";
    const auto signed_off = strat::sign_off(std::vector{old}, "2025-06-01T18:00:00Z");
    const auto reviewed = strat::review({old, fresh}, signed_off);
    CHECK_FALSE(reviewed[0].is_new);
    CHECK(reviewed[1].is_new);
}

TEST_CASE("A relation about to be added tells which circle it would close") {
    SmallRecord r = chain(5);
    model::sort_record(r.record());
    const auto matrix = strat::HarrisMatrix::build(r.record());
    const auto closes = strat::predict(matrix, {4, RelationKind::Covers, 0});
    CHECK(closes.consequence == strat::Consequence::ClosesCycle);
    CHECK(closes.path.size() == 4);
    CHECK(strat::predict(matrix, {0, RelationKind::Cuts, 4}).consequence == strat::Consequence::None);
    CHECK(strat::predict(matrix, {2, RelationKind::Covers, 2}).consequence == strat::Consequence::SelfRelation);
    CHECK(strat::predict(matrix, {0, RelationKind::SameAs, 3}).consequence == strat::Consequence::OrdersSame);
    CHECK(strat::predict(matrix, {3, RelationKind::BondsWith, 0}).consequence == strat::Consequence::OrdersTogether);
}

TEST_CASE("Only units with nothing undug above may be dug next; a cut is in nobody's way") {
    SmallRecord r;
    r.covers("1", "2").relate("2", RelationKind::Cuts, "3").covers("4", "5");
    r.kind("2", model::UnitKind::Cut);
    r.unit("1").status = model::UnitStatus::Excavated;
    model::sort_record(r.record());
    const auto matrix = strat::HarrisMatrix::build(r.record());
    const auto names = [&](const std::vector<strat::UnitIndex>& units) {
        Names result;
        for (const auto u : units) result.push_back(r.record().units[u].number);
        return result;
    };
    const strat::Today today = strat::today(r.record(), matrix);
    CHECK(names(today.open) == Names{"2", "3", "4", "5"});
    CHECK(names(today.diggable) == Names{"2", "3", "4"});
    CHECK(today.gaps.size() == 5);
}
