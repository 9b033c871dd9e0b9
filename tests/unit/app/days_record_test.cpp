// SPDX-License-Identifier: MIT
#include "app/reports/days_record.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/layout_records.hpp"

using namespace planum;
using Catch::Matchers::Contains;

namespace {

model::StratigraphicUnit& unit(model::Record& record, const std::string& number) {
    return *std::find_if(record.units.begin(), record.units.end(), [&](const auto& u) { return u.number == number; });
}

std::vector<std::string> numbers(const model::Record& record) {
    std::vector<std::string> all;
    for (const model::StratigraphicUnit& u : record.units) all.push_back(u.number);
    return all;
}

// 1 over 2 over 3 over 4 over 5, and 6 alone; 3 was dug from the 2nd to the 4th.
model::Record five_layers() {
    auto builder = test::a_matrix();
    builder.above("1", "2").above("2", "3").above("3", "4").above("4", "5").above("6", "7");
    model::Record record = builder.record();
    unit(record, "3").excavated_from = "2025-06-02";
    unit(record, "3").excavated_on = "2025-06-04";
    return record;
}

} // namespace

TEST_CASE("A day's report holds what was in work on it and what that touches, nothing else") {
    const model::Record record = five_layers();
    const auto matrix = strat::HarrisMatrix::build(record);
    for (const char* day : {"2025-06-02", "2025-06-04"}) {
        const app::DaysRecord of_day = app::days_record(record, matrix, day, {});
        CHECK(of_day.units.size() == 1);
        CHECK(numbers(of_day.record) == std::vector<std::string>{"2", "3", "4"});
        CHECK(of_day.record.relations.size() == 2);
        CHECK(of_day.orders.size() == 2);
    }
    CHECK(app::units_of_day(record, "2025-06-03").size() == 1); // between the two, though nothing is dated so
    CHECK(app::units_of_day(record, "2025-06-05").empty());
}

TEST_CASE("A find of the day brings its unit, a relation entered that day both of its units") {
    model::Record record = five_layers();
    model::Find find;
    find.number = "F1";
    find.unit = unit(record, "6").id;
    find.found_on = "2025-06-09";
    record.finds.push_back(find);
    model::RelationStatement statement;
    statement.relation = record.relations.front().id;
    statement.stated_at = "2025-06-09T17:00:00Z";
    record.statements = {statement};
    const auto units = app::units_of_day(record, "2025-06-09");
    CHECK(units.size() == 3);
    CHECK(units.contains(unit(record, "6").id));
    CHECK(units.contains(record.relations.front().subject));
    // Read from a file, the time is that of the import and says nothing about the day's work.
    record.statements.front().source = model::SourceId{record.units[0].id.value};
    CHECK(app::units_of_day(record, "2025-06-09").size() == 1);
}

TEST_CASE("The problems of a day name one of its units, and stay readable in its record") {
    model::Record record = five_layers();
    const auto matrix = strat::HarrisMatrix::build(record);
    model::Diagnostic near;
    near.relations = {
        {record.relations[0].id, record.relations[0].subject, model::RelationKind::Covers, record.relations[0].object}};
    near.units = {record.relations[0].subject, unit(record, "3").id};
    model::Diagnostic far;
    far.units = {unit(record, "6").id};
    std::vector<model::Diagnostic> problems = {near, far};
    const auto units = app::units_of_day(record, "2025-06-02");
    app::keep_problems_of_day(problems, units, "2025-06-02");
    REQUIRE(problems.size() == 1);
    const app::DaysRecord of_day = app::days_record(record, matrix, "2025-06-02", problems);
    CHECK(numbers(of_day.record) == std::vector<std::string>{"1", "2", "3", "4"});
    CHECK(of_day.record.relations.size() == 3);
}

TEST_CASE("A day without work is refused with the day before it that has some") {
    const model::Record record = five_layers();
    const auto matrix = strat::HarrisMatrix::build(record);
    CHECK_THROWS_WITH(app::days_record(record, matrix, "2025-06-20", {}),
                      Contains("2025-06-20: nothing") && Contains("last day before it with something is 2025-06-04"));
    CHECK_THROWS_WITH(app::days_record(record, matrix, "2025-06-01", {}),
                      Contains("the first day with something is 2025-06-02"));
}
