// SPDX-License-Identifier: MIT
#include "app/suggestions/suggestions.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/evidence/evidence.hpp"
#include "app/regions/outline_text.hpp"
#include "app/regions/region_import.hpp"
#include "app/scans/add_scans.hpp"
#include "core/base/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary.hpp"

using namespace planum;

namespace {

// A floor of 2 × 1 m: unit 1 lies 12 cm thick over 2 on the first day, over its western half.
void write_day(const std::filesystem::path& folder, double height_in_west) {
    std::filesystem::create_directories(folder);
    std::ofstream out(folder / "s.xyz");
    for (int x = 0; x < 200; ++x) {
        for (int y = 0; y < 100; ++y) {
            out << fmt::format("{:.3f} {:.3f} {}\n", 0.01 * x + 0.005, 0.01 * y + 0.005,
                               x < 100 ? height_in_west : 5.0);
        }
    }
}

app::DrawnOutline drawn(const std::string& unit, const std::string& day, const std::string& corners) {
    app::DrawnOutline outline;
    outline.unit = unit;
    outline.day = day;
    outline.shape = app::parse_outline(corners);
    return outline;
}

constexpr const char* kWest = "0 0, 1 0, 1 1, 0 1";
constexpr const char* kEast = "1 0, 2 0, 2 1, 1 1";

void place_all(app::Project& project) {
    const std::vector<model::Scan> scans = project.record().scans;
    project.change("place", [&] {
        model::RegistrationRun run;
        run.name = "1";
        run.made_at = "2025-06-02T10:00:00Z";
        run.state = "accepted";
        run.id = project.file().insert(run);
        for (const model::Scan& scan : scans) {
            model::ScanPose pose;
            pose.scan = scan.id;
            pose.run = run.id;
            pose.site_from_scan = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
            project.file().insert(pose);
        }
    });
}

app::Project two_days(const test::TemporaryFolder& folder) {
    write_day(folder / "2025-06-01", 5.12);
    write_day(folder / "2025-06-02", 5.0);
    app::Project project = app::Project::create(folder / "site.gpkg", {}, {});
    app::add_scans(project, {folder / "2025-06-01", folder / "2025-06-02"}, {}, Progress::none());
    app::RegionImportOptions options;
    options.create_units = true;
    app::import_outlines(project,
                         {{drawn("1", "2025-06-01", kWest), drawn("3", "2025-06-01", kEast),
                           drawn("2", "2025-06-02", kWest), drawn("3", "2025-06-02", kEast)},
                          {}},
                         options);
    place_all(project);
    return project;
}

std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator{}));
}

} // namespace

TEST_CASE("What lay bare where something had been dug away is proposed to lie below it") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const auto list = app::list_suggestions(project, Progress::none());
    CHECK(list.unused.empty());
    REQUIRE(list.suggestions.size() == 1);
    const model::Suggestion& s = list.suggestions.front();
    CHECK(s.type == model::SuggestionType::Relation);
    CHECK(project.index().name(s.unit) == "1");
    CHECK(s.kind == model::RelationKind::Covers);
    CHECK(project.index().name(s.other) == "2");
    CHECK(s.direct);
    CHECK(s.thickness == Approx(0.12).margin(0.002));
    CHECK(s.area < 1.0);  // cells near the outline are left out
    CHECK(s.area > 0.75); // a strip of 6 cm on all sides
    CHECK(s.state == model::SuggestionState::Open);
    CHECK(app::concerns_day(project.record(), s, "2025-06-02"));
    CHECK_FALSE(app::concerns_day(project.record(), s, "2025-06-03"));
}

TEST_CASE("A surface with a first day alone is one of that day") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const std::vector<model::Surface> surfaces = project.record().surfaces;
    project.change("no last days; a unit came and went between the two", [&] {
        for (model::Surface surface : surfaces) {
            surface.last_day.clear();
            project.file().update(surface);
        }
        model::StratigraphicUnit hidden;
        hidden.number = "9";
        hidden.excavated_on = "2025-06-02";
        project.file().insert(hidden);
    });
    const auto list = app::list_suggestions(project, Progress::none());
    REQUIRE(list.suggestions.size() == 1);
    const model::Suggestion& s = list.suggestions.front();
    CHECK_FALSE(s.direct); // 9 may have lain between
    CHECK(s.kind == model::RelationKind::Later);
    CHECK(app::concerns_day(project.record(), s, "2025-06-02"));
    CHECK_THAT(s.reason, Catch::StartsWith("on 2 June 2025"));
}

TEST_CASE("Where the record says both orders, what surfaces show is still proposed") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const auto unit = [&](const std::string& number) {
        const auto& units = project.record().units;
        return std::find_if(units.begin(), units.end(), [&](const auto& one) { return one.number == number; })->id;
    };
    const model::UnitId one = unit("1");
    const model::UnitId two = unit("2");
    project.change("1 covers 4, 4 covers 2, 2 covers 1; 9 came and went between", [&] {
        model::StratigraphicUnit hidden;
        hidden.number = "9";
        hidden.excavated_on = "2025-06-02";
        project.file().insert(hidden);
        model::StratigraphicUnit other;
        other.number = "4";
        other.id = project.file().insert(other);
        for (const auto& [later, earlier] : {std::pair{one, other.id}, std::pair{other.id, two}, std::pair{two, one}}) {
            model::PhysicalRelation relation;
            relation.subject = later;
            relation.kind = model::RelationKind::Covers;
            relation.object = earlier;
            project.file().insert(relation);
        }
    });
    const auto list = app::list_suggestions(project, Progress::none());
    REQUIRE(list.suggestions.size() == 1);
    const model::Suggestion& s = list.suggestions.front();
    CHECK(s.kind == model::RelationKind::Later);
    CHECK(s.state == model::SuggestionState::Open);
    CHECK_THAT(s.reason, Catch::EndsWith("; the record has 1 above 2 and 2 above 1: one of the two is wrong"));
    app::accept_suggestions(project, std::vector{s.id}, Progress::none());
    CHECK(app::list_suggestions(project, Progress::none()).suggestions.front().state ==
          model::SuggestionState::Accepted);
}

TEST_CASE("What was found of two surfaces is kept, and judged again where an outline changed") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const auto first = app::list_suggestions(project, Progress::none());
    const std::filesystem::path kept = folder / "site.scans";
    const std::size_t surfaces = files_in(kept / "surfaces");
    const std::size_t evidence = files_in(kept / "evidence");
    CHECK(surfaces == 2);
    CHECK(app::list_suggestions(project, Progress::none()).suggestions == first.suggestions);
    CHECK(files_in(kept / "evidence") == evidence);

    // A unit more in the list moves all numbers but nothing that was found.
    project.change("another unit", [&] {
        model::StratigraphicUnit unit;
        unit.number = "0";
        project.file().insert(unit);
    });
    CHECK(app::list_suggestions(project, Progress::none()).suggestions == first.suggestions);
    CHECK(files_in(kept / "evidence") == evidence);

    const model::UnitId second = project.record().units[project.unit_named("2")].id;
    const std::vector<model::Region> regions = project.record().regions;
    project.change("redraw", [&] {
        for (model::Region region : regions) {
            if (region.unit != second) continue;
            region.outline = {{{{0.5, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0.5, 1, 5}, {0.5, 0, 5}}, {}}};
            project.file().update(region);
        }
    });
    const auto redrawn = app::list_suggestions(project, Progress::none());
    REQUIRE(redrawn.suggestions.size() == 1);
    CHECK(redrawn.suggestions.front().area < 0.55 * first.suggestions.front().area);
    CHECK(files_in(kept / "surfaces") == surfaces);
    CHECK(files_in(kept / "evidence") > evidence);
}

TEST_CASE("A damaged cache is made again, and one that cannot be made is said") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const auto first = app::list_suggestions(project, Progress::none());
    for (const char* kind : {"surfaces", "evidence"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder / "site.scans" / kind))
            std::filesystem::resize_file(entry.path(), std::filesystem::file_size(entry.path()) / 2);
    }
    CHECK(app::list_suggestions(project, Progress::none()).suggestions == first.suggestions);
    std::filesystem::remove_all(folder / "site.scans");
    std::filesystem::remove_all(folder / "2025-06-02");
    const auto without = app::list_suggestions(project, Progress::none());
    CHECK(without.suggestions.empty());
    REQUIRE(without.unused.size() == 1);
    CHECK(without.unused.front().surface == "2025-06-02");
}

TEST_CASE("A surface seen anew after its points were missing is judged as if nothing had been") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    std::filesystem::rename(folder / "site.scans", folder / "away");
    std::filesystem::rename(folder / "2025-06-02", folder / "day");
    CHECK(app::list_suggestions(project, Progress::none()).suggestions.empty());
    std::filesystem::rename(folder / "day", folder / "2025-06-02");
    CHECK(app::list_suggestions(project, Progress::none()).suggestions.size() == 1);
}

TEST_CASE("An outline far from all scans is left out and said") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    app::import_outlines(project, {{drawn("2", "2025-06-02", "5000 0, 5001 0, 5001 1, 5000 1")}, {}}, {});
    const auto list = app::list_suggestions(project, Progress::none());
    CHECK(list.suggestions.size() == 1);
    REQUIRE(list.unused.size() == 1);
    CHECK(list.unused.front().why.find("100 m") != std::string::npos);
}

TEST_CASE("Accepted proposals are relations with their reason; rejected ones stay silent until more is seen") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const std::vector<std::string> ids = {app::list_suggestions(project, Progress::none()).suggestions.front().id};
    app::reject_suggestions(project, ids, "slump", Progress::none());
    const auto rejected = app::list_suggestions(project, Progress::none()).suggestions;
    CHECK(rejected.front().state == model::SuggestionState::Rejected);
    CHECK_THROWS_AS(app::accept_suggestions(project, ids, Progress::none()), Error);
    CHECK_THROWS_AS(app::compile_interpretation(project, "scans", Progress::none()), Error);
    project.undo();
    project.change("decided on less", [&] {
        model::Decision decision;
        decision.subject_id = ids.front();
        decision.kind = "suggestion";
        decision.verdict = "rejected";
        decision.area = rejected.front().area / 1.6;
        project.file().insert(decision);
    });
    CHECK(app::list_suggestions(project, Progress::none()).suggestions.front().state == model::SuggestionState::Open);
    app::accept_suggestions(project, ids, Progress::none());
    const auto accepted = app::list_suggestions(project, Progress::none()).suggestions;
    CHECK(accepted.front().state == model::SuggestionState::Accepted);
    REQUIRE(project.record().relations.size() == 1);
    REQUIRE(project.record().statements.size() == 1);
    CHECK(project.record().statements.front().raw_text == accepted.front().reason);
}

TEST_CASE("A reading from surfaces has what they propose, and nothing that they do not") {
    const test::TemporaryFolder folder;
    app::Project project = two_days(folder);
    const auto unit = [&](const char* name) { return project.record().units[project.unit_named(name)].id; };
    model::PhysicalRelation relation;
    relation.subject = unit("3");
    relation.object = unit("2");
    project.change("recorded by hand", [&] { project.file().insert(relation); });
    CHECK(app::compile_interpretation(project, "from surfaces", Progress::none()) == 1);
    const model::Interpretation& made = project.record().interpretations.front();
    REQUIRE(made.added.size() == 1);
    CHECK(made.added.front().subject == unit("1"));
    REQUIRE(made.dropped.size() == 1);
    CHECK(made.dropped.front() == project.record().relations.front().id);
    CHECK_THROWS_AS(app::compile_interpretation(project, "from surfaces", Progress::none()), Error);
}
