// SPDX-License-Identifier: MIT
#include "app/evidence/section_evidence.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "app/checks/contradiction_sheet.hpp"
#include "app/checks/daily_check.hpp"
#include "app/checks/interpretation_diff.hpp"
#include "app/records/record_kind.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/suggestions/suggestions.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;
using Catch::Matchers::Contains;

namespace {

// A box in the plane of section W, metres along it and heights.
app::DrawnOutline drawn(const std::string& unit, double x0, double z0, double x1, double z1) {
    app::DrawnOutline outline;
    outline.unit = unit;
    outline.day = "2025-06-01";
    outline.section = app::SectionWish{"W", {{{{100.0, 200.0}, {100.0, 204.0}}}}};
    outline.on_plane = true;
    outline.kind = {model::UnitKind::Deposit, model::UnitForm::Layer};
    outline.shape = {{{{x0, z0, 0}, {x1, z0, 0}, {x1, z1, 0}, {x0, z1, 0}}}};
    return outline;
}

// 1 over 2 over 3, without scans or surfaces.
app::Project three_layers(const test::TemporaryFolder& folder) {
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    app::RegionImportOptions options;
    options.create_units = true;
    app::import_outlines(
        project, {{drawn("3", 0, 9.0, 4, 9.4), drawn("2", 0, 9.4, 3, 9.6), drawn("1", 0, 9.6, 3, 9.9)}, {}}, options);
    return project;
}

void relate(app::Project& project, const std::string& upper, const std::string& lower) {
    model::PhysicalRelation relation;
    relation.subject = project.record().units[project.unit_named(upper)].id;
    relation.object = project.record().units[project.unit_named(lower)].id;
    project.change("relate", [&] { project.file().insert(relation); });
}

} // namespace

TEST_CASE("A section proposes what lies on what, with the section named, without any scan") {
    const test::TemporaryFolder folder;
    app::Project project = three_layers(folder);
    const auto list = app::list_suggestions(project, Progress::none());
    REQUIRE(list.suggestions.size() == 2);
    for (const model::Suggestion& s : list.suggestions) {
        CHECK(s.source == model::EvidenceSource::Section);
        CHECK(s.kind == model::RelationKind::Covers);
        CHECK_THAT(s.reason, Contains("in section W") && Contains("along 3.00 m"));
        CHECK(project.index().name(s.unit) < project.index().name(s.other));
    }
    CHECK(app::compile_interpretation(project, "from sections", Progress::none()) == 2);
}

TEST_CASE("A relation that a section contradicts is an error, one that it shows is confirmed") {
    const test::TemporaryFolder folder;
    app::Project project = three_layers(folder);
    relate(project, "1", "2");
    relate(project, "3", "2");
    const app::DailyCheck check = app::check_project(project, {}, Progress::none());
    CHECK(check.coverage.confirmed == 1);
    CHECK(check.coverage.contradicted == 1);
    const auto found = std::find_if(check.problems.begin(), check.problems.end(),
                                    [](const auto& problem) { return problem.code == "height-contradiction"; });
    REQUIRE(found != check.problems.end());
    CHECK(found->severity == model::Severity::Error);
    CHECK_THAT(found->message, Contains("3 covers 2, but in the section 2 lies on 3 along 3.00 m"));
}

TEST_CASE("Sections outweigh levels, not what stratigraphic surfaces say") {
    const test::TemporaryFolder folder;
    app::Project project = three_layers(folder);
    const model::Record& record = project.record();
    model::SurfaceEvidence wrong;
    wrong.upper = record.units[project.unit_named("2")].id;
    wrong.lower = record.units[project.unit_named("1")].id;
    wrong.area = 1.0;
    for (const auto source : {model::EvidenceSource::Levels, model::EvidenceSource::StratigraphicSurfaces}) {
        wrong.source = source;
        const auto all = app::with_sections({wrong}, record);
        CHECK(all.size() == (source == model::EvidenceSource::Levels ? 2 : 3));
        CHECK(std::count_if(all.begin(), all.end(),
                            [](const auto& e) { return e.source == model::EvidenceSource::Section; }) == 2);
    }
}

TEST_CASE("What a section contradicts in one reading only is told of that one") {
    const test::TemporaryFolder folder;
    app::Project project = three_layers(folder);
    app::record_kind("relation").add(project, "3 covers 2", {});
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

namespace {

std::string contradiction_of(app::Project& project) {
    for (const auto& problem : app::check_project(project, {}, Progress::none()).problems) {
        if (problem.code == "height-contradiction") return problem.id;
    }
    return {};
}

} // namespace

TEST_CASE("A contradiction seen in a section is drawn: the section with both outlines, and the worst place larger") {
    const test::TemporaryFolder folder;
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    app::RegionImportOptions options;
    options.create_units = true;
    // 2 lies on 3 all along; east of 1 m it is 40 cm thick, west of it 10 cm.
    app::import_outlines(
        project, {{drawn("3", 0, 9.0, 4, 9.4), drawn("2", 0, 9.4, 1, 9.5), drawn("2", 1, 9.4, 4, 9.8)}, {}}, options);
    relate(project, "3", "2");
    const std::string id = contradiction_of(project);
    REQUIRE_FALSE(id.empty());
    const app::ContradictionSheet made = app::contradiction_sheet(project, id, {}, Progress::none());
    CHECK(made.upper == "2");
    CHECK(made.lower == "3");
    CHECK(made.section == "W");
    CHECK(made.length == Approx(4.0).margin(0.03));
    CHECK(made.before.empty());
    // Section W runs north from 100, 200.
    CHECK(made.x == Approx(100.0));
    CHECK(made.y > 201.0);
    CHECK(made.z_upper == Approx(9.4));
    CHECK(made.z_lower == Approx(9.4));
    REQUIRE(made.group.sheets.size() == 2);
    for (const auto& sheet : made.group.sheets) {
        CHECK(sheet.sheet.is_section);
        CHECK(sheet.sheet.shapes.size() == 3);
        CHECK(sheet.sheet.pictures.empty()); // no scans
        CHECK(std::any_of(sheet.sheet.labels.begin(), sheet.sheet.labels.end(),
                          [](const auto& label) { return label.text == "2"; }));
    }
    CHECK(made.group.sheets[1].scale < made.group.sheets[0].scale);

    project.change("mend", [&] { project.file().remove(project.record().relations.front().id); });
    CHECK_THROWS_AS(app::contradiction_sheet(project, id, {}, Progress::none()), Error);
}
