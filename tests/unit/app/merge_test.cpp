// SPDX-License-Identifier: MIT
#include "app/import/merge.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/apply_plan.hpp"
#include "tests/support/catch.hpp"

using namespace planum;
using app::ImportSet;
using app::MergeOptions;
using app::plan_merge;
using model::RelationKind;
using model::StatementSide;
using test::applied;

namespace {

struct Bench {
    SeededUuids ids{11};
    FixedClock clock{"2025-06-01T17:00:00.000Z"};
    MergeOptions options;

    app::MergePlan plan(const model::Record& record, const std::vector<ImportSet>& sets) {
        return plan_merge(record, sets, options, ids, clock);
    }

    model::Record merged(const model::Record& record, const std::vector<ImportSet>& sets) {
        return applied(record, plan(record, sets));
    }
};

ImportSet a_set(const std::string& name) {
    ImportSet set;
    model::Source source;
    source.name = name;
    source.format = "test";
    source.sha256 = name;
    set.sources = {source};
    set.main_source = name;
    return set;
}

strat::ImportedUnit a_sheet(const std::string& number, const std::string& title = "", const std::string& area = "") {
    strat::ImportedUnit unit;
    unit.name = {area, number};
    unit.values.title = title;
    return unit;
}

strat::StatedRelation said(const std::string& a, RelationKind kind, const std::string& b,
                           StatementSide side = StatementSide::Subject) {
    strat::StatedRelation relation;
    relation.subject = {"", a};
    relation.kind = kind;
    relation.object = {"", b};
    relation.side = side;
    return relation;
}

} // namespace

TEST_CASE("Importing the same again plans nothing") {
    Bench bench;
    auto set = a_set("units.csv");
    set.record.units = {a_sheet("1", "floor"), a_sheet("2", "fill", "A")};
    set.record.units[1].values.details["colour"] = "brown";
    set.record.relations = {said("1", RelationKind::Covers, "2"),
                            said("1", RelationKind::Covers, "2", StatementSide::Object),
                            said("2", RelationKind::SameAs, "1"), said("2", RelationKind::Fills, "9")};
    set.notes = {{"units.csv", 4, "unparsed", "???", "not understood"},
                 {"units.csv", 4, "unparsed", "???", "not understood"}};
    const auto first = bench.merged({}, {set});
    CHECK(first.units.size() == 3);
    CHECK(first.relations.size() == 3);
    CHECK(first.statements.size() == 4);
    CHECK(first.import_notes.size() == 2);
    CHECK(bench.plan(first, {set}).is_empty());
}

TEST_CASE("A longer list of the next day adds, and an edit made in between is not overwritten") {
    Bench bench;
    auto monday = a_set("units.csv");
    monday.record.units = {a_sheet("1", "floor")};
    monday.record.relations = {said("1", RelationKind::Covers, "2")};
    auto record = bench.merged({}, {monday});
    record.units[0].title = "floor of house 3"; // by the director
    auto tuesday = monday;
    tuesday.sources[0].sha256 = "other";
    tuesday.record.units.push_back(a_sheet("3"));
    tuesday.record.relations.push_back(said("3", RelationKind::Cuts, "1"));
    const auto plan = bench.plan(record, {tuesday});
    CHECK(plan.new_units.size() == 1);
    CHECK(plan.changed_units.empty());
    CHECK(plan.new_relations.size() == 1);
    CHECK(plan.new_statements.size() == 1);
    REQUIRE(plan.conflicts.size() == 1);
    CHECK(plan.conflicts[0].what == "unit 1");
    CHECK(plan.conflicts[0].kept == "floor of house 3");
    CHECK_FALSE(plan.conflicts[0].replaced);
}

TEST_CASE("With update the file's value stands, and both are still reported") {
    Bench bench;
    auto set = a_set("units.csv");
    set.record.units = {a_sheet("1", "floor")};
    const auto record = bench.merged({}, {set});
    set.record.units[0].values.title = "yard";
    bench.options.update = true;
    const auto plan = bench.plan(record, {set});
    REQUIRE(plan.changed_units.size() == 1);
    CHECK(plan.changed_units[0].title == "yard");
    CHECK(plan.conflicts.at(0).replaced);
}

TEST_CASE("A list of units that names phases without their periods means those that there are") {
    Bench bench;
    auto all = a_set("phases.csv");
    all.record.units = {a_sheet("1"), a_sheet("2")};
    all.record.periods.resize(2);
    all.record.periods[0].number = "M";
    all.record.periods[1].number = "R";
    all.record.phases.resize(1);
    all.record.phases[0].values.number = "P1";
    all.record.phases[0].period = "R";
    all.record.units[0].phase = "P1";
    all.record.units[0].period = "R";
    const auto record = bench.merged({}, {all});
    REQUIRE(record.phases.size() == 1);
    auto set = a_set("units.csv");
    set.record.units = {a_sheet("1"), a_sheet("2")};
    set.record.phases.resize(1);
    set.record.phases[0].values.number = "P1";
    for (auto& unit : set.record.units) unit.phase = "P1";
    const auto plan = bench.plan(record, {set});
    CHECK(plan.conflicts.empty());
    CHECK(plan.new_phases.empty());
    REQUIRE(plan.changed_units.size() == 1); // 2 had none
    CHECK(plan.changed_units[0].phase == record.phases[0].id);
}

TEST_CASE("Differing areas, phases and features are reported by their names") {
    Bench bench;
    auto set = a_set("units.csv");
    set.record.units = {a_sheet("1", "", "A"), a_sheet("2"), a_sheet("3")};
    set.record.phases.resize(2);
    set.record.phases[0].values.number = "I";
    set.record.phases[1].values.number = "II";
    set.record.units[0].phase = "I";
    set.record.units[0].parent = {"", "2"};
    const auto record = bench.merged({}, {set});
    set.record.units[0].name.area = "B";
    set.record.units[0].phase = "II";
    set.record.units[0].parent = {"", "3"};
    const auto plan = bench.plan(record, {set});
    std::vector<std::string> said;
    for (const app::MergeConflict& c : plan.conflicts) said.push_back(c.field + ": " + c.kept + ", " + c.offered);
    std::sort(said.begin(), said.end());
    CHECK(said == std::vector<std::string>{"area: A, B", "parent: 2, 3", "phase: I, II"});
}

TEST_CASE("A unit only mentioned becomes recorded when its sheet arrives") {
    Bench bench;
    auto relations = a_set("relations.csv");
    relations.record.relations = {said("1", RelationKind::Covers, "2")};
    const auto record = bench.merged({}, {relations});
    CHECK(record.units[1].origin == model::UnitOrigin::Mentioned);
    auto sheets = a_set("units.csv");
    sheets.record.units = {a_sheet("2")};
    const auto after = bench.merged(record, {sheets});
    CHECK(after.units[1].origin == model::UnitOrigin::Recorded);
    CHECK(after.units.size() == 2);
}

TEST_CASE("The order of the files does not matter") {
    auto units = a_set("units.csv");
    units.record.units = {a_sheet("1", "", "A"), a_sheet("2", "", "B")};
    auto relations = a_set("relations.csv");
    relations.record.relations = {said("1", RelationKind::Covers, "2"), said("5", RelationKind::Fills, "2")};
    Bench one;
    Bench other;
    const auto a = one.merged({}, {units, relations});
    const auto b = other.merged({}, {relations, units});
    REQUIRE(a.units.size() == b.units.size());
    const model::RecordIndex in_a(a);
    const model::RecordIndex in_b(b);
    for (std::size_t i = 0; i < a.units.size(); ++i) {
        CHECK(in_a.name(a.units[i].id) == in_b.name(b.units[i].id));
        CHECK(a.units[i].origin == b.units[i].origin);
    }
    CHECK(a.relations.size() == b.relations.size());
}

TEST_CASE("An area comes in with all that a source says of it, and is dug as the project where none says how") {
    auto sheets = a_set("units.csv");
    sheets.record.units = {a_sheet("1", "", "A"), a_sheet("2", "", "B")};
    auto areas = a_set("areas.csv");
    areas.record.areas = {{{}, "A", "trench by the wall", model::DigMethod::Planum, "100", "199"}};
    model::Record mixed;
    mixed.settings.method = model::DigMethod::Mixed;
    for (const auto& sets : {std::vector{sheets, areas}, std::vector{areas, sheets}}) {
        Bench one;
        const auto record = one.merged(mixed, sets);
        REQUIRE(record.areas.size() == 2);
        CHECK(record.areas[0].method == model::DigMethod::Planum);
        CHECK(record.areas[0].title == "trench by the wall");
        CHECK(record.areas[0].last_number == "199");
        CHECK(record.areas[1].method == model::DigMethod::Mixed);
        CHECK(one.plan(record, sets).is_empty());
    }
}

TEST_CASE("One number in two areas is one unit with a warning, or two units where numbers are per area") {
    auto set = a_set("units.csv");
    set.record.units = {a_sheet("7", "pit", "A"), a_sheet("7", "wall", "B")};
    set.record.relations = {said("7", RelationKind::Covers, "8")};
    set.record.relations[0].subject.area = "B";
    Bench site;
    const auto plan = site.plan({}, {set});
    CHECK(plan.new_units.size() == 2);
    REQUIRE(plan.warnings.size() == 1);
    CHECK(plan.warnings[0].find("number 7 is used in area A and in area B") == 0);
    Bench area;
    area.options.numbers = model::NumberScope::Area;
    const auto record = area.merged({}, {set});
    REQUIRE(record.units.size() == 3);
    const model::RecordIndex index(record);
    CHECK(index.name(record.relations.at(0).subject) == "B::7");
    CHECK(index.name(record.relations.at(0).object) == "8");
}

TEST_CASE("Statements of one side stay counted, so that a relation written twice on a sheet is seen") {
    Bench bench;
    auto set = a_set("units.csv");
    set.record.relations = {said("1", RelationKind::Covers, "2"), said("1", RelationKind::Covers, "2")};
    const auto record = bench.merged({}, {set});
    CHECK(record.relations.size() == 1);
    CHECK(record.statements.size() == 2);
    CHECK(bench.plan(record, {set}).is_empty());
}

TEST_CASE("Symmetric relations are one, whichever side they are said from") {
    Bench bench;
    auto set = a_set("units.csv");
    set.record.relations = {said("10", RelationKind::SameAs, "9"), said("9", RelationKind::SameAs, "10")};
    const auto record = bench.merged({}, {set});
    REQUIRE(record.relations.size() == 1);
    const model::RecordIndex index(record);
    CHECK(index.name(record.relations[0].subject) == "9");
    REQUIRE(record.statements.size() == 2);
    CHECK(record.statements[0].side != record.statements[1].side);
    CHECK(record.sources[0].states_both_sides);
}

TEST_CASE("Notes of a source are those of its last reading") {
    Bench bench;
    auto set = a_set("units.csv");
    set.notes = {{"units.csv", 4, "unparsed", "a", "not understood"},
                 {"units.csv", 5, "unparsed", "b", "not understood"}};
    const auto record = bench.merged({}, {set});
    set.sources[0].sha256 = "mended";
    set.notes.erase(set.notes.begin());
    const auto after = bench.merged(record, {set});
    REQUIRE(after.import_notes.size() == 1);
    CHECK(after.import_notes[0].line == 5);
}
