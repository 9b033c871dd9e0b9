// SPDX-License-Identifier: MIT
#include "app/checks/interpretation_diff.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/measured_days.hpp"
#include "tests/support/record_builder.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

// 1 over 2 over 3 in the record; `other` drops 2 over 3 and says 3 over 2.
app::Project a_project(const test::TemporaryFolder& folder) {
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    const model::Record record = test::a_record().covers("1", "2").covers("2", "3").record();
    project.change("record", [&] {
        for (const auto& unit : record.units) project.file().insert(unit);
        for (const auto& relation : record.relations) project.file().insert(relation);
        model::Interpretation other;
        other.name = "other";
        for (const auto& relation : record.relations) {
            if (relation.object != record.units[2].id) continue;
            other.dropped = {relation.id};
            model::PhysicalRelation turned = relation;
            turned.id = {project.uuids().next()};
            std::swap(turned.subject, turned.object);
            other.added = {turned};
        }
        project.file().insert(other);
    });
    return project;
}

} // namespace

TEST_CASE("Two readings differ by the relations and orders that only one has") {
    const test::TemporaryFolder folder;
    app::Project project = a_project(folder);
    const auto diff = app::diff_interpretations(project, "record", "other", Progress::none());
    REQUIRE(diff.relations.size() == 2);
    CHECK(diff.relations[0].unit == "2");
    CHECK(diff.relations[0].in == app::Reading::First);
    CHECK(diff.relations[0].contradicted);
    CHECK(diff.relations[1].unit == "3");
    CHECK(diff.relations[1].in == app::Reading::Second);
    REQUIRE(diff.orders.size() == 1); // told once, not from both sides
    CHECK(diff.orders[0].later == "2");
    CHECK(diff.orders[0].reversed);
}

TEST_CASE("A reading compared with itself differs in nothing, and an unknown one is refused") {
    const test::TemporaryFolder folder;
    app::Project project = a_project(folder);
    const auto same = app::diff_interpretations(project, "other", "other", Progress::none());
    CHECK(same.relations.empty());
    CHECK(same.orders.empty());
    CHECK(same.problems.empty());
    CHECK_THROWS_AS(app::diff_interpretations(project, "other", "third", Progress::none()), Error);
}

TEST_CASE("What only one reading contradicts is told of that one") {
    const test::TemporaryFolder folder;
    app::Project project = a_project(folder);
    project.change("cycle", [&] {
        model::Interpretation circle;
        circle.name = "circle";
        model::PhysicalRelation back;
        back.id = {project.uuids().next()};
        back.subject = project.record().units[2].id;
        back.object = project.record().units[0].id;
        circle.added = {back};
        project.file().insert(circle);
    });
    const auto diff = app::diff_interpretations(project, "record", "circle", Progress::none());
    REQUIRE(std::any_of(diff.problems.begin(), diff.problems.end(), [](const app::DifferingProblem& p) {
        return p.in == app::Reading::Second && p.problem.code == "cycle";
    }));
}

TEST_CASE("What the measured surfaces contradict in one reading only is told of that one") {
    const test::TemporaryFolder folder;
    app::Project project = test::make_measured_days(folder, folder / "site.gpkg");
    app::record_kind("relation").add(project, "2 covers 1", {});
    const model::RelationId wrong = project.record().relations.front().id;
    project.change("reading", [&] {
        model::Interpretation mended;
        mended.name = "mended";
        mended.dropped = {wrong};
        project.file().insert(mended);
    });
    const auto diff = app::diff_interpretations(project, "record", "mended", Progress::none());
    CHECK(std::any_of(diff.problems.begin(), diff.problems.end(), [](const app::DifferingProblem& p) {
        return p.in == app::Reading::First && p.problem.code == "height-contradiction";
    }));
}
