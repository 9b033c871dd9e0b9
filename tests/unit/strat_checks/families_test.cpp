// SPDX-License-Identifier: MIT
#include <variant>

#include "tests/support/catch.hpp"
#include "tests/support/small_record.hpp"

using namespace planum;
using model::LevelRole;
using model::RelationKind;
using model::UnitForm;
using model::UnitKind;
using test::SmallRecord;
using Names = std::vector<std::string>;

TEST_CASE("A record without contradictions has no errors and no warnings") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3").covers("1", "3");
    for (const auto& d : r.check().diagnostics) CHECK(d.severity == model::Severity::Info);
}

TEST_CASE("A unit above itself is said once and is no cycle") {
    SmallRecord r;
    r.covers("6", "6").covers("5", "6");
    REQUIRE(r.said("self-relation").size() == 1);
    CHECK(r.names(r.said("self-relation")[0].units) == Names{"6"});
    CHECK(r.said("cycle").empty());
}

TEST_CASE("Two units each above the other are a contradicting pair") {
    SmallRecord r;
    r.covers("3", "5").relate("5", RelationKind::Cuts, "3");
    const auto pairs = r.said("contradicting-pair");
    REQUIRE(pairs.size() == 1);
    CHECK(r.names(pairs[0].units) == Names{"3", "5"});
    CHECK(pairs[0].relations.size() == 2);
}

TEST_CASE("Bonded units that a path orders are an error, contemporary ones a warning") {
    SmallRecord r;
    r.covers("1", "2")
        .covers("2", "3")
        .relate("1", RelationKind::BondsWith, "3")
        .relate("2", RelationKind::Contemporary, "3");
    const auto said = r.said("contemporary-ordered");
    REQUIRE(said.size() == 2);
    CHECK(said[0].severity == model::Severity::Error);
    CHECK(std::get<std::int64_t>(said[0].evidence.at("steps")) == 2);
    CHECK(said[1].severity == model::Severity::Warning);
}

TEST_CASE("A base that lies above the top by exactly the tolerance is a contradiction") {
    SmallRecord r;
    r.covers("1", "2").level("1", LevelRole::Top, 92.75).level("1", LevelRole::Base, 92.77);
    CHECK(r.said("level-contradiction").size() == 1);
    SmallRecord within;
    within.covers("1", "2").level("1", LevelRole::Top, 92.75).level("1", LevelRole::Base, 92.76);
    CHECK(within.said("level-contradiction").empty());
}

TEST_CASE("A base above the top is a contradiction and judges no relation") {
    SmallRecord r;
    r.covers("1", "2").level("1", LevelRole::Top, 9.0).level("1", LevelRole::Base, 9.5);
    r.level("2", LevelRole::Base, 9.6);
    const auto said = r.said("level-contradiction");
    REQUIRE(said.size() == 1);
    CHECK(r.names(said[0].units) == Names{"1"});
    CHECK(std::get<double>(said[0].evidence.at("difference_m")) == Approx(-0.5));
    CHECK(r.check().coverage.contradicted == 0);
}

TEST_CASE("Levels contradict a relation only when they exclude it") {
    SmallRecord below;
    below.covers("1", "2").level("1", LevelRole::Top, 9.0).level("2", LevelRole::Base, 9.5);
    CHECK(below.said("level-contradiction").size() == 1);
    SmallRecord slope;
    slope.covers("1", "2").level("1", LevelRole::Top, 9.0).level("2", LevelRole::Top, 9.5);
    CHECK(slope.said("level-contradiction").empty());
    SmallRecord cut;
    cut.relate("1", RelationKind::Cuts, "2").level("1", LevelRole::Base, 9.6).level("2", LevelRole::Top, 9.5);
    CHECK(cut.said("level-contradiction").size() == 1);
    SmallRecord fill;
    fill.relate("1", RelationKind::Fills, "2").level("1", LevelRole::Base, 9.0).level("2", LevelRole::Cut, 9.5);
    CHECK(fill.said("level-contradiction").size() == 1);
}

TEST_CASE("Levels near each other judge a relation, less what a slope between them makes up for") {
    // Unit 1 has a top far away that is high enough, so only the pair of near points can speak.
    const auto said = [](double apart, double height_of_top) {
        SmallRecord r;
        r.covers("1", "2").level("1", LevelRole::Top, 12.0, 50.0, 0.0);
        r.level("1", LevelRole::Top, height_of_top, 0.0, 0.0).level("2", LevelRole::Base, 10.0, apart, 0.0);
        return r.said("level-contradiction").size();
    };
    CHECK(said(0.0, 9.95) == 1);
    CHECK(said(0.0, 9.99) == 0); // within the tolerance of 2 cm
    CHECK(said(0.4, 9.7) == 0);  // a slope of 45° loses 0.4 m over 0.4 m
    CHECK(said(0.4, 9.5) == 1);
    CHECK(said(0.6, 9.0) == 0); // too far apart to be compared
}

TEST_CASE("A top confirms what it covers only by more than a slope could") {
    const auto confirmed = [](double apart) {
        SmallRecord r;
        r.covers("1", "2").level("1", LevelRole::Top, 10.2, 0.0, 0.0).level("2", LevelRole::Top, 10.0, apart, 0.0);
        return r.check().coverage.confirmed;
    };
    CHECK(confirmed(0.1) == 1);
    CHECK(confirmed(0.3) == 0);
}

TEST_CASE("Coverage says of every relation whether it could be judged, and else why not") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3").relate("3", RelationKind::Abuts, "4").relate("4", RelationKind::Later, "5");
    r.level("1", LevelRole::Base, 9.5).level("2", LevelRole::Top, 9.5);
    const model::Coverage c = r.check().coverage;
    CHECK(c.relations == 4);
    CHECK(c.confirmed == 1);
    std::int64_t sum = c.confirmed + c.contradicted;
    for (const auto& [why, n] : c.untestable) sum += n;
    CHECK(sum == c.relations);
    CHECK(c.untestable.at("stated in time only") == 1);
}

TEST_CASE("Only typed dates and termini ante quem say not later than") {
    SmallRecord coin;
    coin.covers("1", "2").dating("1", model::DatingKind::Coin, 100, 120).dating("2", model::DatingKind::Coin, 300, 320);
    CHECK(coin.said("date-contradiction").empty());
    SmallRecord typed;
    typed.covers("1", "2")
        .dating("1", model::DatingKind::Typed, 100, 120)
        .dating("2", model::DatingKind::Coin, 300, 320);
    const auto said = typed.said("date-contradiction");
    REQUIRE(said.size() == 1);
    CHECK(std::get<std::int64_t>(said[0].evidence.at("direct")) == 1);
    CHECK(said[0].message.find("intrusive") != std::string::npos);
}

TEST_CASE("A date contradiction across undated units names the path") {
    SmallRecord r;
    r.covers("1", "2")
        .covers("2", "3")
        .dating("1", model::DatingKind::AnteQuem, 100, 100)
        .dating("3", model::DatingKind::PostQuem, 300, 300);
    const auto said = r.said("date-contradiction");
    REQUIRE(said.size() == 1);
    CHECK(said[0].relations.size() == 2);
    CHECK(std::get<std::int64_t>(said[0].evidence.at("direct")) == 0);
}

TEST_CASE("A date contradiction names the same-as that its path goes over, also at its ends") {
    SmallRecord r;
    r.covers("1", "2").relate("2", RelationKind::SameAs, "3").relate("4", RelationKind::SameAs, "1");
    r.dating("4", model::DatingKind::AnteQuem, 100, 100).dating("3", model::DatingKind::PostQuem, 300, 300);
    const auto said = r.said("date-contradiction");
    REQUIRE(said.size() == 1);
    CHECK(said[0].message.rfind("4 is the same as 1, 1 covers 2, 2 is the same as 3, but 4 ", 0) == 0);
}

TEST_CASE("A longer date contradiction is silent where a shorter one lies on its path") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3");
    r.dating("1", model::DatingKind::Typed, 0, 100)
        .dating("2", model::DatingKind::Typed, 0, 100)
        .dating("3", model::DatingKind::Typed, 300, 400);
    const auto said = r.said("date-contradiction");
    REQUIRE(said.size() == 1);
    CHECK(r.names(said[0].units) == Names{"2", "3"});
}

TEST_CASE("A second bound still travels on when the strongest has met its contradiction") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3").covers("2", "4");
    r.dating("1", model::DatingKind::AnteQuem, 50, 50).dating("2", model::DatingKind::AnteQuem, 250, 250);
    r.dating("3", model::DatingKind::Coin, 300, 310).dating("4", model::DatingKind::Coin, 200, 210);
    const auto said = r.said("date-contradiction");
    REQUIRE(said.size() == 2);
    CHECK(r.names(said[0].units) == Names{"1", "4"});
    CHECK(r.names(said[1].units) == Names{"2", "3"});
}

TEST_CASE("Phases compare by years before ranks, and across units without a phase") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "3");
    model::Phase early;
    early.id = model::PhaseId{Uuid{0, 1}};
    early.number = "2";
    early.from = 0;
    early.to = 100;
    model::Phase late = early;
    late.id = model::PhaseId{Uuid{0, 2}};
    late.number = "1";
    late.from = 200;
    late.to = 300;
    r.record().phases = {early, late};
    r.unit("1").phase = early.id;
    r.unit("3").phase = late.id;
    const auto said = r.said("phase-contradiction");
    REQUIRE(said.size() == 1);
    CHECK(said[0].relations.size() == 2);
}

TEST_CASE("A unit dug out before what covers it was begun is said, but not beside a baulk") {
    SmallRecord r;
    r.covers("1", "2");
    r.unit("1").excavated_on = "2024-06-10";
    r.unit("2").excavated_on = "2024-06-03";
    CHECK(r.said("dug-too-early").size() == 1);
    r.unit("1").title = "North baulk";
    CHECK(r.said("dug-too-early").empty());
}

TEST_CASE("Kinds that cannot have a relation are said unless the project is lenient") {
    SmallRecord r;
    r.relate("1", RelationKind::Cuts, "2").kind("1", UnitKind::Deposit, UnitForm::Layer).kind("2", UnitKind::Deposit);
    CHECK(r.said("kind-mismatch").size() == 1);
    r.record().settings.strictness = model::Strictness::Lenient;
    CHECK(r.said("kind-mismatch").empty());
}

TEST_CASE("Incomplete sequences are said only where the record knows cuts and fills") {
    SmallRecord plain;
    plain.covers("1", "2").kind("1", UnitKind::Deposit, UnitForm::Fill).kind("2", UnitKind::Cut);
    CHECK(plain.said("fill-without-cut").empty());
    SmallRecord knows;
    knows.relate("1", RelationKind::Fills, "2").relate("2", RelationKind::Cuts, "3").covers("4", "5");
    knows.kind("4", UnitKind::Deposit, UnitForm::Fill).kind("6", UnitKind::Cut).kind("2", UnitKind::Cut);
    CHECK(knows.said("fill-without-cut").size() == 1);
    CHECK(knows.said("cut-without-fill").size() == 1);
    CHECK(knows.said("cut-cuts-nothing").size() == 1);
}

TEST_CASE("Natural ground above something made is said") {
    SmallRecord r;
    r.covers("1", "2").kind("1", UnitKind::Natural).kind("2", UnitKind::Deposit);
    CHECK(r.said("natural-not-lowest").size() == 1);
}

TEST_CASE("A number in two areas is reused only where numbers are unique on the site") {
    SmallRecord r;
    r.unit("1", "A");
    r.unit("1", "B");
    CHECK(r.said("number-reused").size() == 1);
    r.record().settings.numbers = model::NumberScope::Area;
    CHECK(r.said("number-reused").empty());
}

TEST_CASE("A number outside the block of its area is said") {
    SmallRecord r;
    r.area("A").first_number = "100";
    r.area("A").last_number = "199";
    r.unit("150", "A");
    r.unit("1500", "A");
    const auto said = r.said("number-outside-block");
    REQUIRE(said.size() == 1);
    CHECK(r.names(said[0].units) == Names{"1500"});
}

TEST_CASE("Missing reciprocals are one line, and none for a source that states one side only") {
    SmallRecord both;
    for (int i = 1; i < 10; ++i) both.covers(std::to_string(i), std::to_string(i + 1));
    both.covers("20", "21", SmallRecord::Sides::Subject).covers("21", "22", SmallRecord::Sides::Object);
    const auto said = both.said("missing-reciprocal");
    REQUIRE(said.size() == 1);
    CHECK(std::get<std::int64_t>(said[0].evidence.at("count")) == 2);
    SmallRecord one;
    for (int i = 1; i < 10; ++i) one.covers(std::to_string(i), std::to_string(i + 1), SmallRecord::Sides::Subject);
    CHECK(one.said("missing-reciprocal").empty());
}

TEST_CASE("One contact as two kinds is a duplicate, a contact and an order in time is not") {
    SmallRecord r;
    r.covers("1", "2").relate("1", RelationKind::Fills, "2").covers("2", "3").relate("2", RelationKind::Later, "3");
    CHECK(r.said("duplicate-relation").size() == 1);
}

TEST_CASE("A unit without a sheet dangles, unless the source has no sheets at all") {
    SmallRecord r;
    r.covers("1", "2");
    r.unit("2").origin = model::UnitOrigin::Mentioned;
    CHECK(r.said("dangling-unit").size() == 1);
    r.unit("1").origin = model::UnitOrigin::Mentioned;
    CHECK(r.said("dangling-unit").empty());
}

TEST_CASE("A line that was not understood is said with file and line") {
    SmallRecord r;
    model::ImportNote note;
    note.source = r.record().sources.front().id;
    note.line = 17;
    note.code = "empty-target";
    note.raw_text = "Covers ''";
    note.message = "no unit named";
    r.record().import_notes = {note, note};
    const auto said = r.said("unparsed");
    REQUIRE(said.size() == 2);
    CHECK(said[0].message.starts_with("sheets.csv:17"));
    CHECK(said[0].id != said[1].id);
}

TEST_CASE("More than twenty isolated units become one info; void ones are silent") {
    SmallRecord r;
    for (int i = 0; i < 30; ++i) r.unit(std::to_string(i));
    r.kind("3", UnitKind::Void);
    const auto said = r.said("isolated-unit");
    REQUIRE(said.size() == 1);
    CHECK(std::get<std::int64_t>(said[0].evidence.at("count")) == 29);
}

TEST_CASE("A find in a cut, above or below its unit is outside of it") {
    SmallRecord r;
    r.kind("1", UnitKind::Cut).level("2", LevelRole::Top, 9.0).level("2", LevelRole::Base, 8.5);
    const auto add = [&](std::string number, std::string_view unit, double z) {
        model::Find find;
        find.number = std::move(number);
        find.unit = r.unit(unit).id;
        find.z = z;
        r.record().finds.push_back(find);
    };
    add("F1", "1", 9.0);
    add("F2", "2", 9.5);
    add("F3", "2", 8.0);
    add("F4", "2", 8.7);
    CHECK(r.said("find-outside-unit").size() == 3);
}

TEST_CASE("Every code that is said stands in the table") {
    SmallRecord r;
    r.covers("1", "2").covers("2", "1").covers("3", "3").relate("4", RelationKind::SameAs, "5").covers("4", "5");
    for (const auto& d : r.check().diagnostics) {
        const auto codes = strat::all_check_codes();
        CHECK(std::any_of(codes.begin(), codes.end(), [&](const strat::CheckCode& c) { return c.code == d.code; }));
    }
}

TEST_CASE("Ranges of years that share a year follow each other, single years do not exclude each other") {
    SmallRecord ranges;
    ranges.covers("1", "2")
        .dating("1", model::DatingKind::Typed, -2200, -2000)
        .dating("2", model::DatingKind::Typed, -2000, -1700);
    CHECK(ranges.said("date-contradiction").size() == 1);
    SmallRecord years;
    years.covers("1", "2")
        .dating("1", model::DatingKind::AnteQuem, -2000, -2000)
        .dating("2", model::DatingKind::PostQuem, -2000, -2000);
    CHECK(years.said("date-contradiction").empty());
}
